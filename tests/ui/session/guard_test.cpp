// SPDX-License-Identifier: GPL-3.0-or-later
// What is thrown behind the window ends nothing: it is told. And whatever is read there ends soon when it is cancelled.
#include <QSignalSpy>
#include <QTest>
#include <chrono>
#include <stdexcept>

#include "core/plans/plan.h"
#include "core/register/register.h"
#include "tests/ui/window_setup.h"
#include "ui/support/background.h"

namespace surefoot {

TEST(Guard, WhatIsThrownAfterTheWorkIsTold) {
  Background background;
  QSignalSpy failed(&background, &Background::failed);
  background.start([](const std::atomic<bool>&) {}, [] { throw std::runtime_error("neither this"); },
                   std::chrono::milliseconds(1000));
  ASSERT_EQ(failed.size(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("neither this")));
}

TEST(Guard, APlanOfTenThousandConditionsIsLetGoAtOnce) {
  std::string list;
  for (int i = 1; i <= 100; ++i) list += (i > 1 ? "," : "") + std::to_string(i / 101.0);
  const std::string plan =
      "[base]\nenvironment = \"cliff\"\nfeatures = \"table\"\nepisodes = 5\n[[condition]]\nname = \"a\"\n"
      "set.policy.epsilon = [" +
      list + "]\nset.agent.discount = [" + list + "]\n";
  static const Registry registry = [] {
    Registry r;
    registerCore(r);
    return r;
  }();
  auto background = std::make_unique<Background>();
  std::atomic<bool> begun{false};
  background->start(
      [&](const std::atomic<bool>& interrupted) {
        begun = true;
        PlanChanges changes;
        changes.interrupted = &interrupted;
        static_cast<void>(static_cast<bool>(parsePlan(registry, plan, "plan.toml", changes)));
      },
      [] {});
  ASSERT_TRUE(QTest::qWaitFor([&] { return begun.load(); }));
  QTest::qWait(100);
  const auto before = std::chrono::steady_clock::now();
  background.reset();  // as the window does when it is closed
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(1));
}

}  // namespace surefoot
