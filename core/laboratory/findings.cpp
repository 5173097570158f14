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

/// What was measured of a condition, and what comparisons need besides.
struct Measured {
  ConditionRecord record;
  std::vector<LifeMeasures> lives;
  std::vector<double> falls, minutes;
  std::string pool;  // which Q-functions its lives began with; empty: none
  nlohmann::json configuration;
};

/// γ and the rewards of the rule of thumb, as the condition's configuration has them.
std::optional<Interval> thresholdOf(const Measured& m, const Interval& transitions) {
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

Finding describe(const Measured& m, std::optional<std::size_t> end, const std::vector<double>& averages) {
  Finding f;
  f.name = m.record.condition.name, f.reference = m.record.condition.reference;
  f.lives = static_cast<int>(m.lives.size());
  f.diverged = m.record.diverged;
  f.end = end;
  if (end) f.largestChangeAfter = largestChangeAfter(averages, *end);
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
  const Groups groups = byQFunction(m.record, m.falls);
  if (groups.size() > 1) f.betweenQFunctions = varianceComponent({groups.begin(), groups.end()});
  return f;
}

void warn(Finding& f, const Measured& m) {
  if (!f.end) f.warnings.push_back("learning did not end by the rule of section 4.2.1; the whole lives are measured");
  if (f.diverged > 0) f.warnings.push_back(fmt::format("{} lives diverged and are left out", f.diverged));
  if (f.atCap > 0)
    f.warnings.push_back(
        fmt::format("{} of {} Q-functions did not reach the reward of their pre-learning", f.atCap, f.qFunctions));
  if (const auto normal = normalityTest(m.falls); normal && normal->p < 0.01)
    f.warnings.push_back(
        fmt::format("falls are not normally distributed (p {:.2g}); trust the bootstrap rather than t", normal->p));
  if (f.betweenQFunctions && f.betweenQFunctions->test.p < 0.01)
    f.warnings.push_back(
        fmt::format("lives of one Q-function are alike ({:.0f} % of the variance lies between Q-functions); the "
                    "analysis of variance takes them for independent, the bootstrap does not",
                    100 * f.betweenQFunctions->share));
}

Comparison compare(const Measured& reference, const Measured& other, std::optional<std::size_t> end, bool paired,
                   std::vector<std::string>& warnings, std::uint64_t seed) {
  Comparison c;
  const Sample a(reference.falls), b(other.falls);
  const bool samePool = !reference.pool.empty() && reference.pool == other.pool;
  const auto change = [](const std::vector<double>& means) { return changeInPerCent(means[0], means[1]); };
  const auto interval = [&](const std::vector<double>& before, const std::vector<double>& after) {
    const std::vector<Groups> groups = {byQFunction(reference.record, before), byQFunction(other.record, after)};
    Random random(seed);
    return bootstrap(groups, samePool && groups[0].size() == groups[1].size(), change, random);
  };
  c.change = interval(reference.falls, other.falls);
  if (end) c.changeAtItsEnd = interval(fallsUntil(reference.record, *end), fallsUntil(other.record, *end));
  c.anova = oneWayAnova({a, b});
  c.welch = welchTest(a, b);
  if ((paired || samePool) && a.size() == b.size()) c.paired = pairedTest(a, b);
  c.effect = effectSize(a, b);
  c.minutes = differenceInterval(reference.minutes, other.minutes);
  if (const double sd = std::sqrt((varianceOf(a) + varianceOf(b)) / 2); sd > 0)
    c.livesNeeded = livesNeeded(sd, meanOf(b) - meanOf(a));
  if (const auto equal = brownForsytheTest({a, b}); equal && equal->p < 0.01)
    warnings.push_back(fmt::format("variances differ from the reference's (p {:.2g}); trust Welch's test", equal->p));
  return c;
}

Result<Measured> readAndMeasure(const Store& store, int condition, std::optional<std::size_t>& end,
                                std::vector<double>& averages) {
  auto record = readCondition(store, condition);
  if (!record) return record.error();
  Measured m{.record = std::move(*record), .lives = {}, .falls = {}, .minutes = {}, .pool = {}, .configuration = {}};
  averages = meanAverageRewards(m.record);
  end = endOfLearning(averages, m.record.condition.goalReward);
  m.lives = measure(m.record, end);
  for (const LifeMeasures& l : m.lives) m.falls.push_back(l.falls), m.minutes.push_back(l.minutes);
  for (auto& life : m.record.episodes) life.shrink_to_fit();
  m.configuration = nlohmann::json::parse(m.record.condition.configuration, nullptr, false);
  if (m.configuration.contains("pre_learning")) m.pool = m.configuration["pre_learning"].dump();
  return m;
}

}  // namespace

Result<Findings> findingsOf(const Store& store) {
  auto plan = store.plan();
  if (!plan) return plan.error();
  Findings findings{.plan = std::move(*plan), .complete = true, .conditions = {}};
  const auto& conditions = findings.plan.conditions;
  std::vector<Measured> measured;
  for (int i = 0; i < static_cast<int>(conditions.size()); ++i) {
    std::optional<std::size_t> end;
    std::vector<double> averages;
    auto m = readAndMeasure(store, i, end, averages);
    if (!m) return m.error();
    findings.conditions.push_back(describe(*m, end, averages));
    warn(findings.conditions.back(), *m);
    findings.complete &=
        static_cast<int>(m->lives.size()) + m->record.diverged == conditions[static_cast<std::size_t>(i)].lives;
    measured.push_back(std::move(*m));
  }

  std::map<std::string, std::size_t> numbers;
  for (std::size_t i = 0; i < conditions.size(); ++i) numbers[conditions[i].name] = i;
  std::map<std::size_t, std::vector<std::size_t>> families;  // conditions by their reference
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const auto found = numbers.find(conditions[i].reference);
    if (found == numbers.end() || found->second == i) continue;
    const std::size_t r = found->second;
    if (measured[r].falls.empty() || measured[i].falls.empty()) continue;
    Finding& f = findings.conditions[i];
    f.comparison = compare(measured[r], measured[i], findings.conditions[r].end, findings.plan.paired, f.warnings,
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
