// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/rewinding.h"

#include "tests/core/life/ice.h"

namespace surefoot {

namespace {

/// Where an episode began, by another environment of the same kind.
std::vector<double> poseAtTheBeginning(const Registry& r, const Configuration& c, const Life& life) {
  const auto environment = makeEnvironment(r, c);
  Random random(life.inputs().random);
  (*environment)->reset(random);
  return (*environment)->pose();
}

/// Lives to the end and holds every rewind against the poses before it; `pushes`: a push in every state of the episode
/// but the first. Returns how many there were.
std::int64_t checkEveryRewind(const Registry& r, const Configuration& c, Life& life, bool pushes = false) {
  const auto steps = static_cast<std::size_t>(c.parameters.get("life.rewind"));
  std::vector<std::vector<double>> poses;
  std::int64_t all = 0;
  while (!life.finished()) {
    const bool begins = !life.inEpisode() || life.steps() == 0;
    const int before = begins ? 0 : life.log().current().rewinds;
    if (pushes && !begins) life.push(poses.size() % 2 == 0 ? 0.002 : -0.001);
    life.step();
    const std::vector<double> pose = life.environment().pose();
    if (begins) poses = {poseAtTheBeginning(r, c, life)};
    if (life.inEpisode() && life.log().current().rewinds > before) {
      ++all;
      const std::size_t at = poses.size() > steps ? poses.size() - steps : 0;
      EXPECT_EQ(pose, poses[at]) << "rewind " << all;
      EXPECT_EQ(life.inputs().actions.size(), at);
      poses.resize(at);
    }
    poses.push_back(pose);
  }
  return all;
}

std::int64_t rowsOf(const Life& life, const std::function<std::int64_t(const EpisodeRow&)>& of) {
  std::int64_t sum = 0;
  for (const EpisodeRow& row : life.log().rows()) sum += of(row);
  return sum;
}

std::uint64_t hashAfter(const Registry& r, const Configuration& c) {
  const auto life = lifeOf(r, c);
  livePart(*life);
  return life->hash();
}

}  // namespace

// Three steps to the right from 0, a push before the third: two steps back is x = 0.5, and the push is undone.
TEST(EpisodeInputs, GoBackToWhereAnActionWasChosen) {
  EpisodeInputs inputs;
  inputs.start = {0.0};
  inputs.actions = {1, 1, 1};
  inputs.explored = {0, 1, 0};
  inputs.pushSteps = {0, 1, 2};
  inputs.pushImpulses = {0.0, 0.25, 1.0};
  EpisodeInputs one = inputs;
  one.keepFirst(1);
  EXPECT_EQ(one.actions, (std::vector<std::uint16_t>{1}));
  EXPECT_EQ(one.explored, (std::vector<std::uint8_t>{0}));
  EXPECT_EQ(one.pushSteps, (std::vector<std::uint64_t>{0}));
  EXPECT_EQ(one.pushImpulses, (std::vector<double>{0.0}));
  inputs.explored.pop_back();  // of a life that was resumed
  inputs.keepFirst(2);
  EXPECT_TRUE(inputs.explored.empty());
  Ice ice;
  Random random(1);
  Ending ending = Ending::None;
  EXPECT_TRUE(repeat(one, ice, random, ending, [](const Outcome&, Action) {}));
  EXPECT_EQ(ice.state()[0], 0.5);
}

TEST(Rewinding, TheWorldIsExactlyWhereItWas) {
  Told told;
  const Registry r = withIce(told);
  for (const bool pushes : {false, true}) {
    told = {};
    const Configuration c = rewinding(r, "ice", "3", "2", "listening");
    auto made = makeLife(r, c, 0, true);
    ASSERT_TRUE(made) << made.error().message;
    Life& life = **made;
    EXPECT_GT(checkEveryRewind(r, c, life, pushes), 50);
    const LifeTotals& totals = life.log().totals();
    EXPECT_GT(totals.falls, 0);
    EXPECT_EQ(totals.episodes, 200);
    EXPECT_EQ(told.starts, totals.episodes + totals.rewinds) << "for the learner an episode begins with each";
    EXPECT_EQ(told.ends + told.cuts, told.starts);
    EXPECT_EQ(rowsOf(life, [](const EpisodeRow& row) { return row.steps; }), life.steps()) << "all that was lived";
    EXPECT_EQ(rowsOf(life, [](const EpisodeRow& row) { return row.rewinds; }), totals.rewinds);
    for (const EpisodeRow& row : life.log().rows()) {
      EXPECT_LE(row.rewinds, 2);
      EXPECT_LE(row.falls, 1);
      EXPECT_TRUE(row.falls == 0 || row.rewinds == 2) << "the fall after the last rewind ends the episode";
      EXPECT_EQ(row.reward, -10.0 * (row.rewinds + row.falls) + 10.0 * row.success);
    }
  }
}

TEST(Rewinding, WithFewerStepsItBeginsAgain) {
  Told told;
  const Registry r = withIce(told);
  const Configuration c = rewinding(r, "ice", "1000", "3", "listening");
  const auto life = lifeOf(r, c);
  EXPECT_GT(checkEveryRewind(r, c, *life), 20);
  for (const double x : told.begins) EXPECT_LE(std::abs(x), 1.0) << "where episodes begin";
}

TEST(Rewinding, OfThePendulumBitForBit) {
  const Registry r = fullRegistry();
  for (const char* steps : {"1", "20", "60"}) {
    const Configuration c = rewinding(r, "pendulum", steps, "3");
    const auto life = lifeOf(r, c);
    EXPECT_GT(checkEveryRewind(r, c, *life), 100) << steps;
    EXPECT_GT(life->log().totals().falls, 0);
  }
}

TEST(Rewinding, OffChangesNoBit) {
  const Registry r = fullRegistry();
  Configuration c = pendulumConfiguration(r);
  c.episodes = 60;
  const std::uint64_t hash = hashAfter(r, c);
  ASSERT_TRUE(c.parameters.set("life.rewinds", 20.0));
  EXPECT_EQ(hashAfter(r, c), hash);
  ASSERT_TRUE(c.parameters.set("life.rewind", 20.0));
  const std::uint64_t rewound = hashAfter(r, c);
  EXPECT_NE(rewound, hash);
  const auto looked = lifeOf(r, c);
  looked->keepInputs();
  livePart(*looked);
  EXPECT_EQ(looked->hash(), rewound);
}

TEST(Rewinding, AWorldThatNeverDoesTheSameStopsTheLife) {
  Told told;
  const Registry r = withIce(told);
  const auto life = lifeOf(r, rewinding(r, "thaw", "2", "3"));
  livePart(*life);
  ASSERT_TRUE(life->diverged());
  EXPECT_NE(life->divergence().find("does not do the same again"), std::string::npos) << life->divergence();
  EXPECT_EQ(life->log().totals().rewinds, 0);
}

TEST(Rewinding, WhatIsNotAllowedIsASentence) {
  Told told;
  const Registry r = withIce(told);
  for (const auto& [key, value] : {std::pair{"life.rewind", "-1"}, std::pair{"life.rewind", "1.5"},
                                   std::pair{"life.rewinds", "0"}, std::pair{"life.rewind", "1000001"}}) {
    const auto c = configure(r, {}, {{key, value}});
    ASSERT_FALSE(c) << key << " " << value;
    EXPECT_NE(c.error().message.find(key), std::string::npos) << c.error().message;
  }
  Configuration slow = rewinding(r, "slow-ice", "2", "3");
  const auto refused = makeLife(r, slow, 0, false);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("life.rewind = 2"), std::string::npos) << refused.error().message;
  ASSERT_TRUE(slow.parameters.set("life.rewind", 0.0));
  const auto life = lifeOf(r, slow);
  EXPECT_FALSE(life->set("life.rewind", 2));
  EXPECT_EQ(life->parameters().get("life.rewind"), 0.0);
  slow.commands = {{5, "life.rewind", "2"}};
  EXPECT_FALSE(makeLife(r, slow, 0, false));
}

}  // namespace surefoot
