// SPDX-License-Identifier: GPL-3.0-or-later
// What the greedy policy can do by now: an episode in an environment of its own, from which nothing is learned and
// which no total counts (Task::testEvery).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/action_value.h"
#include "core/environment.h"
#include "core/files/archive.h"

namespace surefoot {

/// One greedy test episode.
struct GreedyTest {
  std::int64_t episode = 0;    ///< of the life, after which it was made
  std::int64_t lifeSteps = 0;  ///< transitions of the life up to then
  std::int64_t steps = 0;      ///< transitions of the test
  double reward = 0.0;
  int falls = 0;
  EpisodeMeasures measures{};
};

/// Makes the tests of one life, and keeps them. Used by one thread.
class GreedyTester {
 public:
  /// `seed`: of the starts; none of them depends on those before.
  GreedyTester(std::unique_ptr<Environment> environment, std::uint64_t seed);

  bool due(std::int64_t episodes) const {
    const int every = environment_ ? environment_->task().testEvery : 0;
    return every > 0 && episodes % every == 0;
  }
  /// Gives its environment the parameters of the life's.
  void follow(Environment& environment);
  void test(const ActionValueFunction& values, std::int64_t episode, std::int64_t lifeSteps);

  const std::vector<GreedyTest>& tests() const { return tests_; }
  /// CPU time that they took here [s].
  double cpuSeconds() const { return cpuSeconds_; }
  void transfer(Archive& archive);

 private:
  std::unique_ptr<Environment> environment_;
  std::uint64_t seed_;
  std::vector<double> q_, pi_;
  std::vector<GreedyTest> tests_;
  double cpuSeconds_ = 0.0;
};

/// [m]: what nothing but walking reaches in a test.
inline constexpr double kWalkDistance = 2.0;

/// The first test in which a robot walked: more than kWalkDistance without a fall. nullptr: none did, or the task has
/// no distance.
const GreedyTest* firstWalk(const std::vector<GreedyTest>& tests, const std::vector<TaskMeasure>& measures);

}  // namespace surefoot
