// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/experiment.h"
#include "core/life/lives_version.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

std::vector<std::uint64_t> hashes(const Registry& r, const Configuration& c, int jobs) {
  const auto lives = runLives(r, c, {.jobs = jobs, .keepRows = false, .interrupted = nullptr, .progress = {}});
  EXPECT_TRUE(lives);
  std::vector<std::uint64_t> list;
  for (const LifeResult& life : *lives) list.push_back(life.hash);
  return list;
}

}  // namespace

TEST(Determinism, TheSameBitsForAnyNumberOfThreads) {
  const Registry r = fullRegistry();
  for (const PolicyEntry& policy : r.policies) {
    Configuration c = pendulumConfiguration(r, policy.name);
    c.lives = 6;
    c.episodes = 120;
    const auto one = hashes(r, c, 1);
    ASSERT_EQ(one.size(), 6u);
    EXPECT_EQ(one, hashes(r, c, 2)) << policy.name;
    EXPECT_EQ(one, hashes(r, c, 7)) << policy.name;
  }
}

namespace {

/// A short life of everything that is registered, in 64 bits.
std::uint64_t hashOfEverything(const Registry& r) {
  Hash64 all;
  for (const EnvironmentEntry& environment : r.environments)
    for (const AgentEntry& agent : r.agents)
      for (const PolicyEntry& policy : r.policies) {
        Names names;
        names.environment = environment.name, names.agent = agent.name, names.policy = policy.name;
        auto c = configure(r, names, {});
        if (!c) continue;  // a learning rule that is not for this task
        c->episodes = 1000;
        auto life = makeLife(r, *c, 0, false, 400);
        if (!life) continue;
        while (!(*life)->finished()) (*life)->step();
        all.add((*life)->hash());
      }
  return all.value();
}

}  // namespace

// Files of two numbers do not belong into one result: these hashes and the number go up together.
TEST(Determinism, TheNumberOfTheLivesIsThatOfTheseBits) {
  EXPECT_EQ(kLivesVersion, 1) << "write down the hash that belongs to it";
  EXPECT_EQ(hashOfEverything(fullRegistry()), 14610224710700448358ULL)
      << "lives take another course than before: raise kLivesVersion (core/experiment/lives_version.h) by one, write "
         "down the new hash here, and say in the CHANGELOG what changed and why";
}

// Written down once: a change of these numbers is a change of every result, and belongs into the CHANGELOG, and into
// kLivesVersion.
TEST(Determinism, TheSameBitsOnEveryMachine) {
  const Registry r = fullRegistry();
  Configuration c = pendulumConfiguration(r, "softmax");
  c.episodes = 200;
  EXPECT_EQ(hashes(r, c, 1), (std::vector<std::uint64_t>{4749420372828358865ULL}));
  c = pendulumConfiguration(r, "trl");
  c.episodes = 200;
  EXPECT_EQ(hashes(r, c, 1), (std::vector<std::uint64_t>{2956750445400578089ULL}));
}

TEST(Experiment, AnInterruptKeepsWhatIsDone) {
  const Registry r = fullRegistry();
  Configuration c = pendulumConfiguration(r);
  c.lives = 1000;
  c.minutes = 1000;
  std::atomic<bool> interrupted{true};
  const auto none = runLives(r, c, {.jobs = 2, .keepRows = false, .interrupted = &interrupted, .progress = {}});
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->empty());

  interrupted = false;
  const auto some =
      runLives(r, c, {.jobs = 2, .keepRows = false, .interrupted = &interrupted, .progress = [&](const Progress& p) {
                        if (p.steps > 0) interrupted = true;
                      }});
  ASSERT_TRUE(some);
  EXPECT_FALSE(some->empty());
  for (const LifeResult& life : *some) EXPECT_FALSE(life.complete);
}

}  // namespace surefoot
