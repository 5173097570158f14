// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/experiment/rule_of_thumb.h"
#include "core/random.h"

namespace surefoot {

namespace {

const double kNothing = std::numeric_limits<double>::quiet_NaN();

/// Mean and interval of the finite values of all lives.
template <class Field>
Interval over(const std::vector<LifeMeasures>& lives, Field field) {
  std::vector<double> values;
  for (const LifeMeasures& l : lives)
    if (const double v = field(l); std::isfinite(v)) values.push_back(v);
  if (values.empty()) return {kNothing, kNothing, kNothing};
  return meanInterval(values).value_or(Interval{values[0], kNothing, kNothing});
}

/// γ and the rewards of the rule of thumb, as the condition's configuration has them.
std::optional<Interval> thresholdOf(const Evidence& m, const Interval& transitions) {
  const auto& parameters = m.configuration.value("parameters", nlohmann::json::object());
  if (!parameters.contains("agent.discount") || !parameters.contains("environment.goal_reward") ||
      !std::isfinite(transitions.value))
    return std::nullopt;
  const auto rule = [&](double n) {
    return ruleOfThumb(parameters["agent.discount"], n, parameters["environment.goal_reward"],
                       parameters.value("environment.time_reward", 0.0));
  };
  return Interval{rule(transitions.value), rule(transitions.high), rule(transitions.low)};
}

Finding describe(const Evidence& m) {
  Finding f;
  f.name = m.record.condition.name, f.reference = m.record.condition.reference;
  f.lives = static_cast<int>(m.lives.size());
  f.diverged = m.record.diverged;
  f.end = m.end;
  if (m.end) f.largestChangeAfter = largestChangeAfter(m.averages, *m.end);
  f.falls = over(m.lives, [](const auto& l) { return l.falls; });
  f.minutes = over(m.lives, [](const auto& l) { return l.minutes; });
  f.allFalls = over(m.lives, [](const auto& l) { return l.allFalls; });
  f.endPerformance = over(m.lives, [](const auto& l) { return l.endPerformance; });
  f.averageReward = over(m.lives, [](const auto& l) { return l.averageReward; });
  f.successDuring = over(m.lives, [](const auto& l) { return l.during.success; });
  f.successAfter = over(m.lives, [](const auto& l) { return l.after.success; });
  f.failureDuring = over(m.lives, [](const auto& l) { return l.during.failure; });
  f.failureAfter = over(m.lives, [](const auto& l) { return l.after.failure; });
  f.threshold = thresholdOf(m, f.successDuring);
  f.qFunctions = static_cast<int>(m.record.preLearned.size());
  for (const StoredPreLearning& p : m.record.preLearned) f.atCap += !p.reached;
  const Groups groups = groupsOf(m, "falls");
  if (groups.size() > 1) f.betweenQFunctions = varianceComponent({groups.begin(), groups.end()});
  return f;
}

void warn(Finding& f, const Evidence& m) {
  if (!f.end) f.warnings.push_back("learning did not end by the rule of section 4.2.1; the whole lives are measured");
  if (f.diverged > 0) f.warnings.push_back(fmt::format("{} lives diverged and are left out", f.diverged));
  if (f.atCap > 0)
    f.warnings.push_back(
        fmt::format("{} of {} Q-functions did not reach the reward of their pre-learning", f.atCap, f.qFunctions));
  if (const auto normal = normalityTest(valuesOf(m, "falls")); normal && normal->p < 0.01)
    f.warnings.push_back(
        fmt::format("falls are not normally distributed (p {:.2g}); trust the bootstrap rather than t", normal->p));
  if (f.betweenQFunctions && f.betweenQFunctions->test.p < 0.01)
    f.warnings.push_back(
        fmt::format("lives of one Q-function are alike ({:.0f} % of the variance lies between Q-functions); the "
                    "analysis of variance takes them for independent, the bootstrap does not",
                    100 * f.betweenQFunctions->share));
}

Comparison compare(const Evidence& reference, const Evidence& other, bool paired, std::vector<std::string>& warnings,
                   std::uint64_t seed) {
  Comparison c;
  const auto a = valuesOf(reference, "falls"), b = valuesOf(other, "falls");
  const bool shared = shareQFunctions(reference, other);
  const auto interval = [&](const std::vector<double>& before, const std::vector<double>& after) {
    Random random(seed);
    return bootstrap(
        {byQFunction(reference.record, before), byQFunction(other.record, after)}, shared,
        [](const std::vector<double>& means) { return changeInPerCent(means[0], means[1]); }, random);
  };
  c.change = interval(a, b);
  if (reference.end)
    c.changeAtItsEnd = interval(fallsUntil(reference.record, *reference.end), fallsUntil(other.record, *reference.end));
  c.anova = oneWayAnova({a, b});
  c.welch = welchTest(a, b);
  if ((paired || shared) && a.size() == b.size()) c.paired = pairedTest(a, b);
  c.effect = effectSize(a, b);
  if (reference.record.condition.stepTime > 0)
    c.minutes = differenceInterval(valuesOf(reference, "minutes"), valuesOf(other, "minutes"));
  if (const double sd = std::sqrt((varianceOf(a) + varianceOf(b)) / 2); sd > 0)
    c.livesNeeded = livesNeeded(sd, meanOf(b) - meanOf(a));
  if (const auto equal = brownForsytheTest({a, b}); equal && equal->p < 0.01)
    warnings.push_back(fmt::format("variances differ from the reference's (p {:.2g}); trust Welch's test", equal->p));
  return c;
}

}  // namespace

Result<Findings> findingsOf(const Store& store) {
  auto plan = store.plan();
  if (!plan) return plan.error();
  const auto evidence = readEvidence(store);
  if (!evidence) return evidence.error();
  return findingsOf(std::move(*plan), *evidence);
}

Findings findingsOf(StoredPlan plan, const std::vector<Evidence>& measured) {
  Findings findings{.plan = std::move(plan), .complete = true, .conditions = {}};
  const auto& conditions = findings.plan.conditions;
  for (const Evidence& e : measured) {
    findings.conditions.push_back(describe(e));
    warn(findings.conditions.back(), e);
    findings.complete &= static_cast<int>(e.lives.size()) + e.record.diverged == e.record.condition.lives;
  }

  std::map<std::string, std::size_t> numbers;
  for (std::size_t i = 0; i < conditions.size(); ++i) numbers[conditions[i].name] = i;
  std::map<std::size_t, std::vector<std::size_t>> families;  // conditions by their reference
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const auto found = numbers.find(conditions[i].reference);
    if (found == numbers.end() || found->second == i) continue;
    const std::size_t r = found->second;
    if (measured[r].lives.empty() || measured[i].lives.empty()) continue;
    Finding& f = findings.conditions[i];
    f.comparison = compare(measured[r], measured[i], findings.plan.paired, f.warnings,
                           deriveSeed(findings.plan.seed, i, Stream::Policy));
    families[r].push_back(i);
  }
  for (const auto& [r, family] : families) {
    std::vector<double> p;
    for (const std::size_t i : family) p.push_back(findings.conditions[i].comparison->p());
    const auto adjusted = holm(p);
    for (std::size_t k = 0; k < family.size(); ++k) findings.conditions[family[k]].comparison->holm = adjusted[k];
  }
  return findings;
}

}  // namespace surefoot
