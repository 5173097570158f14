// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/rule_of_thumb.h"

#include <fmt/format.h>

#include "core/text/text.h"

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
  rule.goal = false;
  rule.discount = discount, rule.reward = t.highestReward, rule.timeReward = task.timeReward;
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
  rule.discount = discount->value, rule.reward = *task.goalReward, rule.timeReward = task.timeReward;
  rule.transitions =
      during > 0 ? mean(t.successSteps - t.successStepsAfter, during) : mean(t.successSteps, t.successes);
  rule.threshold = threshold(rule.transitions);
  if (rule.preLearned) return rule;
  if (during > 0) rule.lower = rule.threshold;
  if (t.successesAfter > 0) rule.upper = threshold(mean(t.successStepsAfter, t.successesAfter));
  return rule;
}

std::string whyNoRule(const Task& task, const Parameters& parameters) {
  if (!parameters.find("agent.discount")) return "The rule of thumb needs a learning rule that discounts.";
  if (task.goalReward) return "The rule of thumb appears with the first success.";
  if (measureAt(task.measures, "net_footsteps")) return "The rule of thumb appears with the first footstep.";
  return "The rule of thumb is not defined for this task: nothing is earned at a goal.";
}

namespace {

double rounded(double value, int decimals) {
  const double unit = std::pow(10.0, decimals);
  return std::round(value * unit) / unit;
}

/// As short as possible with at most that many decimals: "200", "0.5", "−1".
std::string shortText(double value, int decimals) {
  std::string text = fixedText(value, decimals);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string formulaOf(const std::string& discount, const std::string& n, const std::string& goal,
                      const std::string& time, bool discounted) {
  if (!discounted) return time.empty() ? goal : fmt::format("{} + {} · {}", goal, n, time);
  const std::string end = fmt::format("{}^{} · {}", discount, n, goal);
  if (time.empty()) return end;
  return fmt::format("{0} + {1} · (1 − {1}^{2}) / (1 − {1}) · {3}", end, discount, n, time);
}

std::string inBrackets(double value, const std::string& text) {
  return value < 0 ? "(" + text + ")" : text;
}

}  // namespace

RuleText textOf(const RuleOfThumb& rule) {
  constexpr int kMost = 12;
  RuleText text;
  text.threshold = fixedText(rule.threshold, 1);
  const double discount = rounded(rule.discount, kMost), time = rounded(rule.timeReward, kMost);
  int decimals = 1;
  const auto says = [&] {
    const double n = rounded(rule.transitions, decimals), reward = rounded(rule.reward, decimals);
    return fixedText(ruleOfThumb(discount, n, reward, time), 1);
  };
  while (decimals < kMost && says() != text.threshold) ++decimals;
  const bool discounted = rule.discount < 1.0, timed = rule.timeReward != 0.0;
  text.transitions = fixedText(rule.transitions, decimals);
  text.symbols = formulaOf("γ", "n*", "R", timed ? "R_t" : "", discounted);
  text.formula =
      formulaOf(shortText(discount, kMost), text.transitions, inBrackets(rule.reward, shortText(rule.reward, decimals)),
                timed ? inBrackets(time, shortText(time, kMost)) : "", discounted);
  return text;
}

}  // namespace surefoot
