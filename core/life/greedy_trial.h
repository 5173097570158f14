// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the greedy policy while a life goes on (Task::testEvery): a test is an episode in a separate environment.
// The agent learns nothing from it, and no total counts it.
#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <vector>

#include "core/action_value.h"
#include "core/environment.h"
#include "core/files/archive.h"
#include "core/policy.h"
#include "core/values_of_state.h"

namespace surefoot {

/// One greedy test episode.
struct GreedyTest {
  std::int64_t episode = 0;    ///< the episode of the life after which the test was made
  std::int64_t lifeSteps = 0;  ///< transitions of the life up to then
  std::int64_t steps = 0;      ///< transitions of the test
  double reward = 0.0;
  int falls = 0;
  EpisodeMeasures measures{};
};

/// Makes the tests of one life, and keeps them. Used by one thread.
class GreedyTester {
 public:
  /// `seed`: for the starts of the tests; no start depends on earlier ones.
  GreedyTester(std::unique_ptr<Environment> environment, std::uint64_t seed);

  bool due(std::int64_t episodes) const {
    const int every = environment_ ? environment_->task().testEvery : 0;
    return every > 0 && episodes % every == 0;
  }
  /// Gives the test environment the parameters of the life's environment.
  void follow(Environment& environment);
  /// A sentence if the environment did not answer: the test did not happen. Empty: it did, or was given up.
  /// `policy`: its caution is the greedy policy's, too.
  std::string test(const ActionValueFunction& values, const Policy& policy, std::int64_t episode,
                   std::int64_t lifeSteps, const std::atomic<bool>* giveUp = nullptr);

  const std::vector<GreedyTest>& tests() const { return tests_; }
  /// CPU time of the tests made by this process [s].
  double cpuSeconds() const { return cpuSeconds_; }
  void transfer(Archive& archive);

 private:
  std::unique_ptr<Environment> environment_;
  std::uint64_t seed_;
  ValuesOfState here_;
  std::vector<double> pi_;
  std::vector<GreedyTest> tests_;
  double cpuSeconds_ = 0.0;
};

/// [m]: only walking reaches this distance in a test.
inline constexpr double kWalkDistance = 2.0;

/// The first test in which a robot walked: more than kWalkDistance without a fall. nullptr: none did, or the task has
/// no distance.
const GreedyTest* firstWalk(const std::vector<GreedyTest>& tests, const std::vector<TaskMeasure>& measures);

}  // namespace surefoot
