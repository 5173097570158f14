// SPDX-License-Identifier: GPL-3.0-or-later
// A life that goes on in an earlier episode.
#include "core/life/inputs_text.h"
#include "core/saved/checkpoint.h"
#include "core/saved/journal.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

/// An episode of a life, with the pose in every state of it.
struct Lived {
  EpisodeInputs inputs;
  std::vector<std::vector<double>> poses;
};

/// A life of the pendulum that keeps inputs, after this many episodes and some steps.
std::unique_ptr<Life> kept(const Registry& r, const Configuration& c, std::int64_t episodes, int more = 0) {
  auto life = lifeOf(r, c);
  life->keepInputs();
  while (life->log().totals().episodes < episodes) life->step();
  for (int i = 0; i < more; ++i) life->step();
  return life;
}

/// The last episode, pushed after its fourth step.
Lived lastEpisode(Life& life) {
  Lived lived;
  const std::int64_t episodes = life.log().totals().episodes;
  while (life.log().totals().episodes == episodes) {
    life.step();
    if (life.inputs().actions.size() == 4) life.push(0.01);
    lived.poses.push_back(life.environment().pose());  // behind its first step, and so on
  }
  lived.inputs = life.inputs();
  return lived;
}

}  // namespace

TEST(GoingOn, TheWorldIsExactlyWhereItWas) {
  const Registry r = fullRegistry();
  for (const char* environment : {"pendulum", "compass"}) {
    auto c = configure(r, {.environment = environment}, {});
    ASSERT_TRUE(c);
    const auto life = kept(r, *c, 5);
    const Lived lived = lastEpisode(*life);
    ASSERT_GT(lived.poses.size(), 12u);
    for (int i = 0; i < 7; ++i) life->step();  // in the middle of another one
    const std::int64_t episodes = life->log().totals().episodes, steps = life->steps();
    EpisodeInputs until = lived.inputs;
    until.keepFirst(10);
    ASSERT_TRUE(life->goOn(until));
    EXPECT_EQ(life->environment().pose(), lived.poses[9]) << environment;
    EXPECT_EQ(life->steps(), steps) << "nothing was lived";
    EXPECT_EQ(life->log().totals().episodes, episodes) << "the episode that was given up does not count";
    while (life->log().totals().episodes == episodes) life->step();
    EXPECT_EQ(life->log().last().steps, life->steps() - steps) << "what was lived before is not counted again";
    EXPECT_EQ(life->inputs().before, 10u);
    ASSERT_FALSE(life->changes().empty());
    EXPECT_EQ(life->changes().back().key, "go_on");
  }
}

TEST(GoingOn, AJournalIsLivedAgainToTheSameBits) {
  const Registry r = fullRegistry();
  Configuration c = pendulumConfiguration(r, "epsilon-greedy");
  c.episodes = 60;
  const auto life = kept(r, c, 20);
  const Lived lived = lastEpisode(*life);
  for (int i = 0; i < 3; ++i) life->step();
  EpisodeInputs until = lived.inputs;
  until.keepFirst(8);
  ASSERT_TRUE(life->goOn(until));
  const std::uint64_t at = static_cast<std::uint64_t>(life->steps());
  while (!life->finished()) life->step();
  LifeResult result = summarise(*life, 0, 0.0);
  result.changes = life->changes();
  const auto journal = parseJournal(r, journalOf(c, result), "j");
  ASSERT_TRUE(journal) << journal.error().message;
  const auto again = replay(r, *journal, {});
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->hash, life->hash()) << "gone on with at step " << at;
  const auto without = lifeOf(r, c);
  while (!without->finished()) without->step();
  EXPECT_NE(without->hash(), life->hash()) << "without it, it is another life";
}

TEST(GoingOn, ASavedLifeGoesOnTheSame) {
  const Registry r = fullRegistry();
  Configuration c = pendulumConfiguration(r, "epsilon-greedy");
  c.episodes = 40;
  const auto life = kept(r, c, 10);
  EpisodeInputs until = lastEpisode(*life).inputs;
  until.keepFirst(6);
  ASSERT_TRUE(life->goOn(until));
  for (int i = 0; i < 5; ++i) life->step();
  ASSERT_TRUE(life->inEpisode());
  auto file = TensorFile::parse(checkpointOf(*life, c, false).write(), "c.safetensors");
  ASSERT_TRUE(file);
  auto resumed = resume(r, std::make_shared<const TensorFile>(std::move(*file)), {});
  ASSERT_TRUE(resumed) << resumed.error().message;
  EXPECT_EQ(resumed->life->environment().pose(), life->environment().pose());
  for (Life* one : {life.get(), resumed->life.get()})
    while (!one->finished()) one->step();
  EXPECT_EQ(resumed->life->hash(), life->hash());
}

TEST(GoingOn, WhereTheModelOfNowEndsBeforeANewEpisodeBegins) {
  const Registry r = fullRegistry();
  const auto life = kept(r, pendulumConfiguration(r), 3);
  const Lived lived = lastEpisode(*life);
  const Status over = life->goOn(lived.inputs);
  ASSERT_FALSE(over) << "it had ended";
  EXPECT_NE(over.error().message.find("ends before that moment"), std::string::npos) << over.error().message;
  EXPECT_TRUE(life->inEpisode());
  life->step();
  EXPECT_EQ(life->inputs().actions.size(), 1u);
}

TEST(InputsText, IsReadAsItWasWritten) {
  const Registry r = fullRegistry();
  const auto life = kept(r, pendulumConfiguration(r), 3);
  const EpisodeInputs inputs = lastEpisode(*life).inputs;
  const auto read = inputsFrom(textOf(inputs), life->environment().task());
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->random, inputs.random);
  EXPECT_EQ(read->start, inputs.start);
  EXPECT_EQ(read->actions, inputs.actions);
  EXPECT_EQ(read->pushSteps, inputs.pushSteps);
  EXPECT_EQ(read->pushImpulses, inputs.pushImpulses);
}

TEST(InputsText, WhatIsNoneIsASentence) {
  const Registry r = fullRegistry();
  const auto environment = makeEnvironment(r, pendulumConfiguration(r));
  const std::string good = R"({"random":["1","2","3","4"],"start":[],"actions":[0,1],"pushes":[[1,0.5]]})";
  ASSERT_TRUE(inputsFrom(good, (*environment)->task()));
  for (const auto& [was, is] : {std::pair{"\"1\",", ""},
                                {"[\"1\",\"2\",\"3\",\"4\"]", "[\"0\",\"0\",\"0\",\"0\"]"},
                                {"\"1\"", "\"x\""},
                                {"\"1\"", "1"},
                                {"\"start\":[]", "\"start\":[1]"},
                                {"\"start\":[]", "\"start\":[9,0,0]"},
                                {"\"start\":[]", "\"start\":7"},
                                {"[0,1]", "[0,5000]"},
                                {"[0,1]", "[0,-1]"},
                                {"[0,1]", "[0,0.5]"},
                                {"[1,0.5]", "[3,0.5]"},
                                {"[1,0.5]", "[1,5000]"},
                                {"[1,0.5]", "[1]"},
                                {"[1,0.5]", "[-1,0.5]"},
                                {"\"pushes\"", "\"pushed\""},
                                {"{\"random\"", "[\"random\""}}) {
    std::string bad = good;
    bad.replace(bad.find(was), std::string(was).size(), is);
    const auto read = inputsFrom(bad, (*environment)->task());
    ASSERT_FALSE(read) << bad;
    EXPECT_TRUE(read.error().message.ends_with(".")) << read.error().message;
  }
}

}  // namespace surefoot
