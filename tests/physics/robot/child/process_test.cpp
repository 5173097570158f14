// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/child/process.h"

#include <gtest/gtest.h>

#include <thread>

namespace surefoot {

namespace {

using Clock = Process::Clock;
using std::chrono::milliseconds;

std::unique_ptr<Process> shell(const std::string& what) {
  auto made = Process::start({"sh", "-c", what}, {"PATH=/usr/bin:/bin"});
  EXPECT_TRUE(made) << (made ? "" : made.error().message);
  return made ? std::move(*made) : nullptr;
}

}  // namespace

TEST(Process, HasOneDeadlineForAllBytes) {
  const auto process = shell("while printf x; do sleep 0.05; done");
  std::array<std::byte, 1000> bytes;
  const auto begun = Clock::now();
  EXPECT_EQ(process->read(bytes, begun + milliseconds(400)), Process::Reading::TimedOut);
  EXPECT_LT(Clock::now() - begun, std::chrono::seconds(10));  // 1,000 bytes take a minute
}

// As after Ctrl+Z: when we look again the time is over, but the answer has long been there.
TEST(Process, AnAnswerThatCameInTimeCountsHoweverLateWeLook) {
  const auto process = shell("printf hello; sleep 60");
  std::array<std::byte, 5> bytes;
  for (int i = 0; i < 1000; ++i) {
    if (process->read(bytes, Clock::now() - milliseconds(1)) == Process::Reading::Done) return;
    std::this_thread::sleep_for(milliseconds(10));
  }
  FAIL() << "it was not seen";
}

TEST(Process, NobodyWaitsOnceAllIsToEnd) {
  const auto process = shell("sleep 60");
  std::array<std::byte, 1> bytes;
  EXPECT_EQ(process->read(bytes, Clock::now() + std::chrono::minutes(10), [] { return true; }),
            Process::Reading::Stopped);
}

TEST(Process, OfItsLastWordsTheEndIsKept) {
  const auto process = shell("echo '" + std::string(300, 'x') + " no such file' >&2; exit 3");
  std::array<std::byte, 1> bytes;
  EXPECT_EQ(process->read(bytes, Clock::now() + std::chrono::seconds(10)), Process::Reading::Ended);
  EXPECT_TRUE(process->end().ends_with("xx no such file"));
}

TEST(Process, AFloodOfErrorsDoesNotHoldUs) {
  const auto process = shell("yes 'no, no' >&2");
  std::array<std::byte, 1> bytes;
  EXPECT_EQ(process->read(bytes, Clock::now() + milliseconds(300)), Process::Reading::TimedOut);
}

}  // namespace surefoot
