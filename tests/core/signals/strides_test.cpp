// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signals/strides.h"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot {

namespace {

/// Two feet by a plan: 'l' the left one is down, 'r' the right one, 'b' both, '.' none; 0.1 s and 0.05 m a row, and
/// 2 W of one motor while both are down.
class Walk final : public Environment {
 public:
  explicit Walk(std::string plan) : plan_(std::move(plan)) {
    task_.state = {{.key = "x"}};
    task_.actions = {0.0};
    task_.rewardTerms = {"time"};
    task_.measures = {{"distance", "distance", "m"}};
    task_.stepTime = 0.1;
  }
  void declare(Fields&) override {}
  const Task& task() const override { return task_; }
  void reset(Random&) override {}
  Outcome step(Action) override {
    ++at_;
    return {};
  }
  std::span<const double> state() const override { return {&zero_, 1}; }
  std::span<const double> measures() const override {
    distance_ = 0.05 * static_cast<double>(at_);
    return {&distance_, 1};
  }
  std::vector<Signal> signals() const override {
    return {{.key = "heel_l", .group = "contacts", .kind = Signal::Kind::OnOff},
            {.key = "right_toe", .group = "contacts", .kind = Signal::Kind::OnOff},
            {.key = "right_knee", .unit = "W", .group = "motors"}};
  }
  void readSignals(std::span<double> values) const override {
    const char now = plan_[at_];
    values[0] = now == 'l' || now == 'b';
    values[1] = now == 'r' || now == 'b';
    values[2] = now == 'b' ? 2.0 : -1.0;
  }
  std::vector<double> pose() const override { return {}; }
  void draw(std::span<const double>, Scene&) const override {}
  std::vector<ReadOut> readOuts(std::span<const double>) const override { return {}; }

 private:
  Task task_;
  std::string plan_;
  std::size_t at_ = 0;
  double zero_ = 0.0;
  mutable double distance_ = 0.0;
};

SignalTable walked(const std::string& plan, std::size_t newEpisodeAt = 1000, std::size_t gapAt = 1000) {
  Walk walk(plan);
  SignalTable table(walk, false);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    table.before(
        walk,
        {.time = 0.1 * static_cast<double>(i < gapAt ? i : i + 3), .episode = i < newEpisodeAt ? 1 : 2, .action = 0});
    static_cast<void>(walk.step(0));
  }
  return table;
}

}  // namespace

TEST(Strides, GoFromATouchDownOfTheLeftFootToTheNext) {
  //                  0123456789012345
  const auto all = stridesOf(walked("rrllbrrrbllbrrbl"));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1].to, 14u);
  EXPECT_EQ(all[0].from, 2u);
  EXPECT_EQ(all[0].to, 8u);
  EXPECT_NEAR(all[0].begins, 0.2, 1e-12);
  EXPECT_NEAR(all[0].duration, 0.6, 1e-12);
  EXPECT_NEAR(all[0].length, 0.3, 1e-12);
  EXPECT_NEAR(all[0].speed(), 0.5, 1e-12);
  EXPECT_NEAR(all[0].bothDown, 1.0 / 6, 1e-12) << "row 4 of rows 2 to 7";
  EXPECT_NEAR(all[0].energy, 2 * (2.0 * 0.1), 1e-12) << "positive power of rows 3 to 8: rows 4 and 8";
}

TEST(Strides, AFootThatBouncesTouchesDownOnce) {
  EXPECT_EQ(stridesOf(walked("rl.l.lrr.lr")).size(), 1u);
  EXPECT_EQ(stridesOf(walked("rl.l.lrr.lr"))[0].from, 1u);
  EXPECT_TRUE(stridesOf(walked(".l.l.l.l")).empty()) << "hopping on one leg is no walking";
}

TEST(Strides, DoNotReachOverTheEndOfAnEpisode) {
  const std::string plan = "rllrrllrrl";
  EXPECT_EQ(stridesOf(walked(plan)).size(), 2u);
  EXPECT_EQ(stridesOf(walked(plan, 4)).size(), 1u);
  EXPECT_EQ(stridesOf(walked(plan, 1000, 4)).size(), 1u) << "or over rows that are missing";
}

TEST(Strides, FeetAreContactsNamedLeftAndRight) {
  const auto foot = [](const char* key, const char* group = "contacts") {
    return footOf({.key = key, .group = group, .kind = Signal::Kind::OnOff});
  };
  EXPECT_EQ(foot("left_heel"), Foot::Left);
  EXPECT_EQ(foot("shin_r"), Foot::Right);
  EXPECT_EQ(foot("hull"), Foot::None);
  EXPECT_EQ(foot("leftover"), Foot::None);
  EXPECT_EQ(foot("right_leg_stands", "gait"), Foot::None);
}

// mean 4, sum of squares 8, 8 / 2 = 4: by hand.
TEST(Strides, TheSpreadIsThatOfASample) {
  const Spread s = spreadOf({2, 4, 6});
  EXPECT_DOUBLE_EQ(s.mean, 4);
  EXPECT_DOUBLE_EQ(s.deviation, 2);
  EXPECT_TRUE(std::isnan(spreadOf({1}).deviation));
  EXPECT_TRUE(std::isnan(spreadOf({}).mean));
}

}  // namespace surefoot
