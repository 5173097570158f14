// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/rewinding.h"

#include "core/agents/agent_around.h"
#include "core/environments/small_world.h"
#include "core/plans/plan.h"
#include "core/saved/checkpoint.h"
#include "core/saved/journal.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

/// A cart on ice between two edges: an action adds ±0.5 to its speed, which the state does not tell. Beyond x = ±4 it
/// falls; beyond 2 it is a success if it is slow. By hand: from x = 0 three steps to the right are x = 0.5, 1.5, 3.
class Ice : public SmallWorld<1> {
 public:
  Ice() {
    task_.state = {{.key = "x", .title = "x", .symbol = "x", .low = -4, .high = 4, .span = 1, .spanText = "1"}};
    task_.state[0].resolution = 2;
    task_.actions = {-0.5, 0.5};
    task_.actionTitle = "push";
    task_.rewardTerms = {"fall", "goal"};
    task_.measures = {{.key = "way", .title = "way"}};
    limit_.most = 60;
  }
  void reset(Random& random) override {
    state_[0] = random.uniform(-1, 1);
    speed_ = 0.0, way_ = {0.0};
    limit_.steps = 0;
  }
  Outcome step(Action action) override {
    speed_ += task_.actions[static_cast<std::size_t>(action)];
    state_[0] += speed_;
    way_[0] += std::abs(speed_);
    Outcome outcome;
    if (std::abs(state_[0]) > 4) {
      outcome.reward = outcome.terms[0] = -10.0;
      outcome.ending = Ending::Terminal;
      outcome.event = Event::Fall;
    } else if (std::abs(state_[0]) > 2 && std::abs(speed_) <= 0.5) {
      outcome.reward = outcome.terms[1] = 10.0;
      outcome.ending = Ending::Terminal;
      outcome.event = Event::Success;
    }
    limit_.count(outcome);
    return outcome;
  }
  bool push(double impulse) override {
    speed_ += impulse;
    return true;
  }
  std::span<const double> measures() const override { return way_; }
  std::vector<double> pose() const override { return {state_[0], speed_, way_[0], static_cast<double>(limit_.steps)}; }
  void draw(std::span<const double>, Scene&) const override {}
  std::vector<ReadOut> readOuts(std::span<const double>) const override { return {}; }

 protected:
  double speed_ = 0.0;
  std::array<double, 1> way_{};
};

/// Its first episode is like no other: later ones end with their first step.
class Thaw final : public Ice {
 public:
  void reset(Random& random) override {
    Ice::reset(random);
    if (++resets_ > 1) state_[0] = 5.0;
  }

 private:
  int resets_ = 0;
};

/// It takes its time.
class SlowIce final : public Ice {
 public:
  bool answersAtOnce() const override { return false; }
};

/// What an agent was told, and in which state its episodes began.
struct Told {
  int starts = 0, ends = 0, cuts = 0;
  std::vector<double> begins;
};

class Listening final : public AgentAround {
 public:
  Listening(std::unique_ptr<Agent> agent, Told& told) : AgentAround(std::move(agent)), told_(told) {}
  Action start(std::span<const double> state, Random& random) override {
    ++told_.starts;
    told_.begins.push_back(state[0]);
    return AgentAround::start(state, random);
  }
  void end(const Outcome& outcome) override {
    ++told_.ends;
    AgentAround::end(outcome);
  }
  Action truncate(const Outcome& outcome, std::span<const double> state, Random& random) override {
    ++told_.cuts;
    return AgentAround::truncate(outcome, state, random);
  }

 private:
  Told& told_;
};

Registry withIce(Told& told) {
  Registry r = fullRegistry();
  r.environments.push_back({{"ice", "Ice", "A cart on ice."}, [] { return std::make_unique<Ice>(); }});
  r.environments.push_back({{"thaw", "Thaw", "Never the same."}, [] { return std::make_unique<Thaw>(); }});
  r.environments.push_back(
      {{"slow-ice", "Slow ice", "It takes its time."}, [] { return std::make_unique<SlowIce>(); }});
  AgentEntry listening = **findEntry(r.agents, "agent", "sarsa");
  listening.name = "listening";
  listening.make = [make = listening.make, &told](const AgentParts& parts) -> Result<std::unique_ptr<Agent>> {
    auto inner = make(parts);
    if (!inner) return inner.error();
    return std::unique_ptr<Agent>(std::make_unique<Listening>(std::move(*inner), told));
  };
  r.agents.push_back(listening);
  return r;
}

Configuration rewinding(const Registry& r, const std::string& environment, const std::string& steps,
                        const std::string& most, const std::string& agent = "sarsa") {
  auto c = configure(r, {.environment = environment, .agent = agent},
                     {{"life.rewind", steps}, {"life.rewinds", most}, {"policy.epsilon", "0.3"}});
  EXPECT_TRUE(c) << c.error().message;
  c->episodes = 200;
  return *c;
}

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

void livePart(Life& life, std::int64_t steps = std::numeric_limits<std::int64_t>::max()) {
  while (life.steps() < steps && !life.finished()) life.step();
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
  EXPECT_TRUE(repeat(one, ice, random, ending, [](Action) {}));
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

// Saved right after a rewind and elsewhere, switched on and changed in the middle of an episode, with pushes.
TEST(Rewinding, ASavedLifeGoesOnTheSame) {
  Told told;
  const Registry r = withIce(told);
  for (const char* environment : {"ice", "pendulum"}) {
    Configuration c = rewinding(r, environment, "0", "2");
    c.commands = {
        {40, "life.rewind", "5"}, {200, "push", "0.01"}, {300, "life.rewinds", "4"}, {900, "life.rewind", "9"}};
    const auto whole = lifeOf(r, c);
    livePart(*whole);
    ASSERT_GT(whole->log().totals().rewinds, 50);
    const auto first = lifeOf(r, c);
    first->keepInputs();
    int saved = 0;
    for (int rewinds = 0; !first->finished() && saved < 40; first->step()) {
      const bool isNew = first->inEpisode() && first->log().current().rewinds > rewinds;
      rewinds = first->inEpisode() ? first->log().current().rewinds : 0;
      if (!isNew && first->steps() % 97 != 0) continue;
      ++saved;
      auto file = TensorFile::parse(checkpointOf(*first, c, false).write(), "c.safetensors");
      ASSERT_TRUE(file);
      auto resumed = resume(r, std::make_shared<const TensorFile>(std::move(*file)), {});
      ASSERT_TRUE(resumed) << resumed.error().message;
      EXPECT_EQ(resumed->life->environment().pose(), first->environment().pose());
      livePart(*resumed->life);
      EXPECT_EQ(resumed->life->hash(), whole->hash()) << environment << " from step " << first->steps();
      EXPECT_EQ(resumed->life->log().totals().rewinds, whole->log().totals().rewinds);
    }
    EXPECT_EQ(saved, 40);
  }
}

TEST(Rewinding, AJournalIsLivedAgain) {
  const Registry r = fullRegistry();
  Configuration c = rewinding(r, "pendulum", "20", "2");
  c.episodes = 60;
  c.commands = {{500, "push", "0.05"}, {2000, "life.rewind", "5"}};
  const auto lives = runLives(r, c, {});
  ASSERT_TRUE(lives);
  EXPECT_GT(lives->front().totals.rewinds, 0);
  const auto journal = parseJournal(r, journalOf(c, lives->front()), "j");
  ASSERT_TRUE(journal) << journal.error().message;
  const auto again = replay(r, *journal, {});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->hash, lives->front().hash);
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

TEST(Rewinding, APreLearningHasItAlone) {
  const Registry r = fullRegistry();
  const auto plan = parsePlan(r,
                              "[pre-learning]\nscenario = \"2\"\nminutes = 1\nset.life.rewind = 20\n"
                              "[[condition]]\nminutes = 1\nscenario = \"actual\"\n",
                              "p.toml", {});
  ASSERT_TRUE(plan) << plan.error().message;
  const Condition& c = plan->conditions.front();
  EXPECT_EQ(c.configuration.parameters.get("life.rewind"), 0.0);
  ASSERT_TRUE(c.preLearning);
  EXPECT_EQ(c.preLearning->configuration.parameters.get("life.rewind"), 20.0);
  EXPECT_NE(c.preLearning->text.find("life.rewind=20"), std::string::npos) << c.preLearning->text;
  EXPECT_EQ(c.preLearning->text.find("life.rewinds"), std::string::npos);
}

}  // namespace surefoot
