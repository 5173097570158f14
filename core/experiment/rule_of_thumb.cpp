// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/rule_of_thumb.h"

namespace surefoot {

namespace {

/// From footstep to footstep.
std::optional<RuleOfThumb> ruleForWalking(const Life& life, double discount) {
  const Task& task = life.environment().task();
  const LifeTotals& t = life.log().totals();
  const auto m = measureAt(task.measures, "net_footsteps");
  if (!m || t.measures[*m] < 1.0) return std::nullopt;
  RuleOfThumb rule;
  rule.preLearned = life.preLearned();
  rule.transitions = static_cast<double>(life.log().last().lifeSteps) / t.measures[*m];
  rule.threshold = ruleOfThumb(discount, rule.transitions, t.highestReward, task.timeReward);
  return rule;
}

}  // namespace

std::optional<RuleOfThumb> ruleOfThumbOf(const Life& life) {
  const Task& task = life.environment().task();
  const Parameters::Entry* discount = life.parameters().find("agent.discount");
  const LifeTotals& t = life.log().totals();
  if (!discount) return std::nullopt;
  if (!task.goalReward) return ruleForWalking(life, discount->value);
  if (t.successes == 0) return std::nullopt;

  const auto threshold = [&](double transitions) {
    return surefoot::ruleOfThumb(discount->value, transitions, *task.goalReward, task.timeReward);
  };
  const auto mean = [](std::int64_t steps, std::int64_t episodes) {
    return static_cast<double>(steps) / static_cast<double>(episodes);
  };
  const std::int64_t during = t.successes - t.successesAfter;
  RuleOfThumb rule;
  rule.preLearned = life.preLearned();
  rule.transitions =
      during > 0 ? mean(t.successSteps - t.successStepsAfter, during) : mean(t.successSteps, t.successes);
  rule.threshold = threshold(rule.transitions);
  if (rule.preLearned) return rule;
  if (during > 0) rule.lower = rule.threshold;
  if (t.successesAfter > 0) rule.upper = threshold(mean(t.successStepsAfter, t.successesAfter));
  return rule;
}

}  // namespace surefoot
