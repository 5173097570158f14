// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/greedy_trial.h"

#include <algorithm>

#include "core/basics/cpu_time.h"

namespace surefoot {

GreedyTester::GreedyTester(std::unique_ptr<Environment> environment, std::uint64_t seed)
    : environment_(std::move(environment)),
      seed_(seed) {
  if (environment_) pi_.resize(environment_->task().actions.size());
}

void GreedyTester::follow(Environment& environment) {
  if (!environment_) return;
  Fields theirs("environment."), ours("environment.");
  environment.declare(theirs);
  environment_->declare(ours);
  for (std::size_t i = 0; i < ours.all().size(); ++i) ours.all()[i].set(theirs.all()[i].get());
  environment_->parametersChanged();
}

std::string GreedyTester::test(const ActionValueFunction& values, const Policy& policy, std::int64_t episode,
                               std::int64_t lifeSteps, const std::atomic<bool>* giveUp) {
  constexpr std::int64_t kLongest = 10'000;  // steps: a life that is to stop must first finish its test
  const double begin = threadCpuSeconds();
  Random random(mix64(seed_ ^ static_cast<std::uint64_t>(episode)));
  environment_->reset(random);
  if (std::string why = environment_->unanswered(); !why.empty()) return why;
  GreedyTest test{.episode = episode, .lifeSteps = lifeSteps};
  if (environment_->answersAtOnce()) giveUp = nullptr;
  Outcome outcome;
  do {
    if (giveUp && giveUp->load(std::memory_order_relaxed)) return {};
    here_.evaluate(values, environment_->state());
    policy.greedy(here_.view(), pi_);
    outcome = environment_->step(sample(pi_, random));
    ++test.steps;
    test.reward += outcome.reward;
    test.falls += outcome.event == Event::Fall;
  } while (outcome.ending == Ending::None && test.steps < kLongest);
  if (outcome.ending == Ending::Unanswered) return environment_->unanswered();
  const auto measures = environment_->measures();
  std::copy(measures.begin(), measures.end(), test.measures.begin());
  tests_.push_back(test);
  cpuSeconds_ += threadCpuSeconds() - begin;
  return {};
}

void GreedyTester::transfer(Archive& archive) {
  constexpr std::size_t kMost = 100'000'000, kColumns = 5 + kMaxMeasures;
  std::vector<double> rows;
  for (const GreedyTest& t : tests_) {
    for (const double v : {static_cast<double>(t.episode), static_cast<double>(t.lifeSteps),
                           static_cast<double>(t.steps), t.reward, static_cast<double>(t.falls)})
      rows.push_back(v);
    rows.insert(rows.end(), t.measures.begin(), t.measures.end());
  }
  archive.list("greedy_tests", rows, kMost);
  archive.value("greedy_test_seed", seed_);
  if (!archive.reading() || !archive.good()) return;
  if (rows.size() % kColumns != 0) return archive.refuse("greedy_tests", "is no table of tests");
  tests_.clear();
  for (std::size_t i = 0; i < rows.size(); i += kColumns) {
    for (const std::size_t count : {i, i + 1, i + 2, i + 4})
      if (!(rows[count] >= 0 && rows[count] <= 1e15))
        return archive.refuse("greedy_tests", "holds an impossible count");
    GreedyTest t{.episode = static_cast<std::int64_t>(rows[i]),
                 .lifeSteps = static_cast<std::int64_t>(rows[i + 1]),
                 .steps = static_cast<std::int64_t>(rows[i + 2]),
                 .reward = rows[i + 3],
                 .falls = static_cast<int>(std::min(rows[i + 4], 1e9))};
    for (std::size_t m = 0; m < kMaxMeasures; ++m) t.measures[m] = rows[i + 5 + m];
    tests_.push_back(t);
  }
}

const GreedyTest* firstWalk(const std::vector<GreedyTest>& tests, const std::vector<TaskMeasure>& measures) {
  const auto distance = measureAt(measures, "distance");
  if (!distance) return nullptr;
  for (const GreedyTest& test : tests)
    if (test.falls == 0 && test.measures[*distance] > kWalkDistance) return &test;
  return nullptr;
}

}  // namespace surefoot
