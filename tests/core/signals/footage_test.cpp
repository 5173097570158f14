// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signals/footage.h"

#include <gtest/gtest.h>

namespace surefoot {

namespace {

/// A world whose pose is a number.
struct Numbered final : Environment {
  double number = 0.0;
  Task nothing{};
  const Task& task() const override { return nothing; }
  void reset(Random&) override {}
  Outcome step(Action) override { return {}; }
  std::span<const double> state() const override { return {&number, 1}; }
  std::vector<double> pose() const override { return {number}; }
  void draw(std::span<const double>, Scene&) const override {}
  std::vector<ReadOut> readOuts(std::span<const double>) const override { return {}; }
  void declare(Fields&) override {}
};

/// Steps 0, 1, 2 … of a world.
Footage taken(double step, int steps) {
  Numbered world;
  FootageTaker taker;
  for (int k = 0; k <= steps; ++k) {
    world.number = k;
    taker.look(world, k * step, false);
  }
  return taker.finish(steps * step);
}

}  // namespace

TEST(Footage, HasTheNewestPoseAtEveryThirtiethOfASecond) {
  const Footage pendulum = taken(0.005, 600);
  ASSERT_EQ(pendulum.poses.size(), 90u) << "3 s";
  EXPECT_DOUBLE_EQ(pendulum.seconds(), 3.0);
  for (const auto& [frame, step] : {std::pair{0, 0}, {1, 6}, {2, 13}, {3, 20}, {45, 300}, {89, 593}})
    EXPECT_EQ(pendulum.poses[static_cast<std::size_t>(frame)][0], step) << frame;
  const Footage slow = taken(0.05, 20);
  ASSERT_EQ(slow.poses.size(), 30u);
  for (const auto& [frame, step] : {std::pair{0, 0}, {1, 0}, {2, 1}, {3, 2}, {29, 19}})
    EXPECT_EQ(slow.poses[static_cast<std::size_t>(frame)][0], step) << frame;
  const Footage same = taken(1.0 / 30, 1000);
  ASSERT_EQ(same.poses.size(), 1000u);
  for (std::size_t i = 0; i < same.poses.size(); ++i) ASSERT_EQ(same.poses[i][0], static_cast<double>(i));
}

TEST(Footage, ShowsAFallForAMomentWhileTheNextEpisodeGoesOn) {
  Numbered world;
  FootageTaker taker;
  world.number = 1;
  taker.look(world, 0.0, false);
  world.number = 2;
  taker.look(world, 0.5, true);
  world.number = 3;
  taker.look(world, 0.5, false);
  const Footage footage = taker.finish(1.0);
  ASSERT_EQ(footage.poses.size(), 30u);
  for (std::size_t i = 0; i < 30; ++i) {
    EXPECT_EQ(footage.poses[i][0], i < 15 ? 1 : i < 21 ? 2 : 3) << i;
    EXPECT_EQ(footage.falls[i], i >= 15 && i < 21) << i;
  }
}

TEST(Footage, EndsWithAFallThatIsSeen) {
  Numbered world;
  FootageTaker taker;
  taker.look(world, 0.0, false);
  world.number = 7;
  taker.look(world, 0.5, true);
  const Footage footage = taker.finish(0.5);
  ASSERT_EQ(footage.poses.size(), 21u);
  EXPECT_EQ(footage.poses.back()[0], 7);
  EXPECT_EQ(footage.falls.back(), 1);
}

TEST(Footage, IsCutAndSlowed) {
  Footage footage{.poses = {}, .falls = std::vector<std::uint8_t>(600, 0), .rows = {}, .rate = 200};
  for (int i = 0; i < 600; ++i) footage.poses.push_back({double(i)}), footage.rows.push_back(i + 5);
  const Footage part = cut(footage, 1.0, 2.0);
  ASSERT_EQ(part.poses.size(), 30u);
  EXPECT_EQ(part.rate, kFilmRate);
  for (const auto& [frame, pose] : {std::pair{0, 200}, {1, 206}, {15, 300}, {29, 393}})
    EXPECT_EQ(part.poses[static_cast<std::size_t>(frame)][0], pose) << frame;
  for (std::size_t i = 0; i < part.rows.size(); ++i)
    EXPECT_EQ(static_cast<double>(part.rows[i]), part.poses[i][0] + 5) << "the signals of the same moment";
  const Footage half = cut(footage, 1.0, 2.0, 0.5);
  ASSERT_EQ(half.poses.size(), 60u);
  EXPECT_EQ(half.poses[1][0], 203);
  EXPECT_EQ(cut(footage, 2.9, 9.0).poses.back()[0], 599) << "past the end it stands still";
  EXPECT_TRUE(cut({}, 0, 1).poses.empty());
}

TEST(Footage, KnowsTheLengthOfAFilm) {
  EXPECT_EQ(filmFrames(25.0), 750);
  EXPECT_EQ(filmFrames(0.001), 1);
  EXPECT_EQ(filmFrames(0.1), 3) << "0.1 s is not quite a sum of thirtieths";
  EXPECT_EQ(filmFrames(0.101), 4);
}

}  // namespace surefoot
