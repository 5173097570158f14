// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/experiment.h"

#include <map>

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

/// A short life in 64 bits; 0: there is no such life.
std::uint64_t hashOfALife(const Registry& r, const Names& names, std::int64_t steps) {
  auto c = configure(r, names, {});
  if (!c) return 0;  // a learning rule that is not for this task
  c->episodes = 1000;
  auto life = makeLife(r, *c, 0, false, steps);
  if (!life) return 0;
  while (!(*life)->finished()) (*life)->step();
  return (*life)->hash();
}

/// Of everything that there was when the number of the lives was written down, in all combinations.
std::uint64_t hashOfEverything(const Registry& r) {
  Hash64 all;
  for (const char* environment :
       {"cliff", "grid-world", "chain", "random-walk", "mountain-car", "pendulum", "compass", "leo"})
    for (const char* agent : {"sarsa", "sarsa-2q", "q-learning", "scripted", "expected-sarsa"})
      for (const char* policy : {"epsilon-greedy", "trl", "softmax", "greedy"}) {
        Names names;
        names.environment = environment, names.agent = agent, names.policy = policy;
        if (const std::uint64_t hash = hashOfALife(r, names, 400); hash != 0) all.add(hash);
      }
  return all.value();
}

}  // namespace

// Files of two numbers do not belong into one result: this hash and the number go up together.
TEST(Determinism, TheNumberOfTheLivesIsThatOfTheseBits) {
  EXPECT_EQ(kLivesVersion, 1) << "write down the hash that belongs to it";
  EXPECT_EQ(hashOfEverything(fullRegistry()), 14610224710700448358ULL)
      << "lives take another course than before: raise kLivesVersion (core/life/lives_version.h) by one, write "
         "down the new hash here, and say in the CHANGELOG what changed and why";
}

// What is added gets a line here, and no other line changes; a line that changes means another number of the lives.
TEST(Determinism, EverythingByNameHasItsBits) {
  const Registry r = fullRegistry();
  std::map<std::string, std::uint64_t> hashes;
  constexpr std::int64_t kSteps = 3000;  // so long that episodes end
  for (const EnvironmentEntry& e : r.environments) hashes[e.name] = hashOfALife(r, {.environment = e.name}, kSteps);
  for (const AgentEntry& a : r.agents) {
    hashes[a.name] = hashOfALife(r, {.agent = a.name}, kSteps);
    if (hashes[a.name] == 0) hashes[a.name] = hashOfALife(r, {.environment = "leo", .agent = a.name}, kSteps);
  }
  for (const PolicyEntry& p : r.policies) hashes[p.name] = hashOfALife(r, {.policy = p.name}, kSteps);
  const std::map<std::string, std::uint64_t> expected = {
      {"chain", 11544701465249800999ULL},           {"cliff", 6606714657695595629ULL},
      {"compass", 6533164687143401153ULL},          {"epsilon-greedy", 16677589546937471982ULL},
      {"expected-sarsa", 5349516552993461733ULL},   {"greedy", 7985694141295309353ULL},
      {"grid-world", 8724037484441412862ULL},       {"leo", 9910813277504284794ULL},
      {"mountain-car", 3005567780120635200ULL},     {"pendulum", 16677589546937471982ULL},
      {"q-learning", 13512946993355239925ULL},      {"random-walk", 14600572934211843060ULL},
      {"sarsa", 16677589546937471982ULL},           {"sarsa-2q", 7560413649322738970ULL},
      {"softmax", 7904383473596424398ULL},          {"trl", 9418955801690637604ULL},
      {"scripted", 11925308871388201995ULL},        {"mellowmax", 12024510292643823601ULL},
      {"true-online-sarsa", 2521192948879852395ULL}};
  for (const auto& [name, hash] : hashes)
    EXPECT_TRUE(expected.contains(name) && expected.at(name) == hash) << "{\"" << name << "\", " << hash << "ULL},";
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
