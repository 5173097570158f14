// SPDX-License-Identifier: GPL-3.0-or-later
// Calls that other threads leave for the window's thread.
#include "ui/support/call_queue.h"

#include <gtest/gtest.h>

#include <QEventLoop>
#include <QTest>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

namespace surefoot {

TEST(CallQueue, CallsInOrderOnTheThreadThatOwnsIt) {
  CallQueue calls;
  std::vector<int> made;
  bool elsewhere = false;
  const auto window = std::this_thread::get_id();
  std::thread([&] {
    for (int i = 0; i < 1000; ++i)
      calls.post([&, i] {
        made.push_back(i);
        elsewhere |= std::this_thread::get_id() != window;
      });
  }).join();
  EXPECT_TRUE(made.empty());  // not before the event loop runs
  ASSERT_TRUE(QTest::qWaitFor([&] { return made.size() == 1000; }));
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(made[static_cast<std::size_t>(i)], i);
  EXPECT_FALSE(elsewhere);
}

// As a dialog does that a call opens.
TEST(CallQueue, ACallWithAnEventLoopDoesNotHoldUpTheNext) {
  CallQueue calls;
  QEventLoop loop;
  std::atomic<bool> first = false;
  bool second = false;
  calls.post([&] {
    first = true;
    loop.exec();
  });
  std::thread other([&] {
    while (!first) std::this_thread::yield();
    calls.post([&] {
      second = true;
      loop.quit();
    });
  });
  EXPECT_TRUE(QTest::qWaitFor([&] { return second && !loop.isRunning(); }));
  other.join();
}

TEST(CallQueue, WhatIsLeftIsDroppedWithTheQueue) {
  auto held = std::make_shared<int>(1);
  bool made = false;
  {
    CallQueue calls;
    calls.post([&made, held] { made = true; });
    EXPECT_EQ(held.use_count(), 2);
  }
  QTest::qWait(1);
  EXPECT_FALSE(made);
  EXPECT_EQ(held.use_count(), 1);
}

TEST(CallQueue, MayBeDestroyedByACall) {
  auto calls = std::make_unique<CallQueue>();
  bool second = false;
  calls->post([&] { calls.reset(); });
  calls->post([&] { second = true; });
  EXPECT_TRUE(QTest::qWaitFor([&] { return !calls; }));
  QTest::qWait(1);
  EXPECT_FALSE(second);
}

}  // namespace surefoot
