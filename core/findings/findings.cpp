// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/findings/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/basics/typed_json.h"
#include "core/files/limited_json.h"
#include "core/findings/growth.h"
#include "core/life/rule_of_thumb.h"
#include "core/statistics/distribution.h"

namespace surefoot {

namespace {

/// γ and the rewards of the rule of thumb, from the condition's configuration.
std::optional<Interval> thresholdOf(const Evidence& m, const Interval& transitions) {
  const auto& parameters = partOf(m.configuration, "parameters");
  const double discount = numberIn(parameters, "agent.discount");
  const double goal = numberIn(parameters, "environment.goal_reward");
  if (!std::isfinite(discount) || !std::isfinite(goal) || !std::isfinite(transitions.value)) return std::nullopt;
  const auto rule = [&](double n) {
    return ruleOfThumb(discount, n, goal, numberIn(parameters, "environment.time_reward", 0.0));
  };
  return Interval{rule(transitions.value), rule(transitions.high), rule(transitions.low)};
}

Interval endRangeOf(const Evidence& m) {
  const double end = m.end ? static_cast<double>(*m.end) : std::numeric_limits<double>::infinity();
  const auto found = m.untilOtherEnds.find("end");
  if (found == m.untilOtherEnds.end()) return {end, end, end};
  std::vector<double> sorted = found->second;
  std::sort(sorted.begin(), sorted.end());
  const auto at = [&](double q) {
    return sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1))];
  };
  return {end, at(0.025), at(0.975)};
}

SpreadOfFalls spreadOf(const Evidence& m) {
  const auto falls = valuesOf(m, "falls");
  const Units units = unitsOf(m.record);
  const auto quantile = [](double q) {
    return [q](Sample x) {
      std::vector<double> sorted(x.begin(), x.end());
      std::sort(sorted.begin(), sorted.end());
      return sorted.empty() ? std::nan("") : quantileOfSorted(sorted, q);
    };
  };
  const auto never = std::count(falls.begin(), falls.end(), 0.0);
  return {.iqm = bootstrapped(falls, units, interquartileMean),
          .median = bootstrapped(falls, units, quantile(0.5)),
          .most = bootstrapped(falls, units, quantile(0.9)),
          .worst = bootstrapped(falls, units, [](Sample x) { return worstMean(x, 0.1); }),
          .withoutFall = falls.empty() ? std::nan("") : static_cast<double>(never) / static_cast<double>(falls.size())};
}

Finding describe(const Evidence& m) {
  Finding f;
  f.name = m.record.condition.name, f.reference = m.record.condition.reference;
  f.lives = static_cast<int>(m.lives.size());
  f.diverged = m.record.diverged;
  f.end = m.end;
  f.endRange = endRangeOf(m);
  if (m.end) f.largestChangeAfter = largestChangeAfter(m.averages, *m.end);
  f.falls = meanOf(m, "falls");
  f.minutes = meanOf(m, "minutes");
  f.allFalls = meanOf(m, "all_falls");
  f.endPerformance = meanOf(m, "end_performance");
  f.averageReward = meanOf(m, "average_reward");
  for (std::size_t i = 0; i < kFixedMinutes.size(); ++i)
    f.fallsByMinute[i] = meanOf(m, fmt::format("falls_{}_min", kFixedMinutes[i]));
  f.fallsByEpisode = meanOf(m, "falls_330");
  f.spread = spreadOf(m);
  f.exploring = meanOf(m, "exploring");
  f.finalFalls = meanOf(m, "final_falls");
  f.finalReward = meanOf(m, "final_reward");
  f.successDuring = meanOf(m, "success_during");
  f.successAfter = meanOf(m, "success_after");
  f.failureDuring = meanOf(m, "failure_during");
  f.failureAfter = meanOf(m, "failure_after");
  f.threshold = thresholdOf(m, f.successDuring);
  f.qFunctions = static_cast<int>(m.record.preLearned.size());
  for (const StoredPreLearning& p : m.record.preLearned) f.atCap += !p.reached;
  const Groups groups = groupsOf(m, "falls");
  if (groups.size() > 1) f.betweenQFunctions = varianceComponent({groups.begin(), groups.end()});
  return f;
}

void warn(Finding& f, const Evidence& m) {
  if (f.lives == 1) f.warnings.push_back("one life has no interval and no test; it takes two, better five");
  if (!f.end)
    f.warnings.push_back(
        "learning did not end by the rule of section 4.2.1: falls and minutes are those of lives that were cut off, "
        "compare them at fixed moments");
  if (f.diverged > 0) f.warnings.push_back(fmt::format("{} lives diverged and are left out", f.diverged));
  if (f.atCap > 0)
    f.warnings.push_back(
        fmt::format("{} of {} Q-functions did not reach the reward of their pre-learning", f.atCap, f.qFunctions));
  if (const auto normal = normalityTest(valuesOf(m, "falls")); normal && normal->p < 0.01)
    f.warnings.push_back(
        fmt::format("falls are not normally distributed (p {:.2g}); trust the interval rather than p", normal->p));
  if (f.betweenQFunctions && f.betweenQFunctions->test.p < 0.01)
    f.warnings.push_back(
        fmt::format("lives of one Q-function are alike ({:.0f} % of the variance lies between Q-functions): its units "
                    "are {} Q-functions, not {} lives",
                    100 * f.betweenQFunctions->share, f.qFunctions, f.lives));
}

std::optional<FixedChange> changeAtFixedMoment(const Evidence& reference, const Evidence& other, bool same) {
  for (const char* measure : kFixedMeasures) {
    const MeanEstimate before = estimateOf(reference, measure), after = estimateOf(other, measure);
    if (!std::isfinite(before.value) || !std::isfinite(after.value)) continue;
    const auto test = testOfUnits(reference, other, measure);
    return FixedChange{measure, changeOf(before, after, same), test ? test->p : kNoTest};
  }
  return std::nullopt;
}

std::optional<std::int64_t> neededFor(const Evidence& reference, const Evidence& other, const Comparison& c) {
  if (!c.ofUnits || unitsOf(reference.record).count != reference.lives.size() ||
      unitsOf(other.record).count != other.lives.size())
    return std::nullopt;
  const auto a = unitMeans(reference, "falls"), b = unitMeans(other, "falls");
  if (!c.paired) {
    const double sd = std::sqrt((varianceOf(a) + varianceOf(b)) / 2);
    return sd > 0 ? std::optional(livesNeeded(sd, c.difference.value)) : std::nullopt;
  }
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(b[i] - a[i]);
  const double sd = std::sqrt(varianceOf(differences));
  return sd > 0 ? std::optional(pairsNeeded(sd, c.difference.value)) : std::nullopt;
}

Comparison compare(const Evidence& reference, const Evidence& other, std::vector<std::string>& warnings) {
  Comparison c;
  const bool same = sameUnits(reference, other);
  const MeanEstimate before = estimateOf(reference, "falls"), after = estimateOf(other, "falls");
  c.change = changeOf(before, after, same);
  c.difference = differenceOf(before, after, same);
  if (reference.end) {
    const auto until = [&](const Evidence& e) {
      return estimateOf(fallsUntil(e.record, *reference.end), unitsOf(e.record));
    };
    c.changeAtItsEnd = changeOf(until(reference), until(other), same);
  }
  const auto a = valuesOf(reference, "falls"), b = valuesOf(other, "falls");
  c.fixed = changeAtFixedMoment(reference, other, same);
  constexpr double kFewFalls = 5;
  if (c.fixed &&
      std::min(estimateOf(reference, c.fixed->measure).value, estimateOf(other, c.fixed->measure).value) < kFewFalls)
    c.counts = countsOf(reference, other, c.fixed->measure);
  c.ofUnits = testOfUnits(reference, other, "falls");
  c.anova = anovaOfTwo(a, b);
  c.welch = welchTest(a, b);
  if (same) c.paired = c.ofUnits;
  c.effect = effectSize(a, b);
  if (reference.record.condition.stepTime > 0)
    c.minutes = differenceOf(estimateOf(reference, "minutes"), estimateOf(other, "minutes"), same);
  c.livesNeeded = neededFor(reference, other, c);
  constexpr std::size_t kFew = 5;  // with fewer values the distances from the median depend too much on each other
  const auto equal = std::min(a.size(), b.size()) < kFew ? std::nullopt : brownForsytheTest({a, b});
  if (equal && equal->p < 0.01)
    warnings.push_back(fmt::format("variances differ from the reference's (p {:.2g}); trust Welch's test", equal->p));
  return c;
}

}  // namespace

Result<Findings> findingsOf(const Registry& registry, const Store& store) {
  auto plan = store.plan();
  if (!plan) return plan.error();
  const auto evidence = readEvidence(registry, store);
  if (!evidence) return evidence.error();
  const auto growth = plan->growth.empty() ? std::nullopt : growthFromJson(parseJson(plan->growth));
  Findings findings = findingsOf(std::move(*plan), *evidence);
  if (growth) findings.found = growthOf(*growth, *evidence).sentences;
  return findings;
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
    f.comparison = compare(measured[r], measured[i], f.warnings);
    f.improvement = bootstrappedImprovement(valuesOf(measured[i], "falls"), unitsOf(measured[i].record),
                                            valuesOf(measured[r], "falls"), unitsOf(measured[r].record),
                                            sameUnits(measured[r], measured[i]));
    families[r].push_back(i);
  }
  for (auto& [r, family] : families) {
    std::erase_if(family, [&](std::size_t i) { return !findings.conditions[i].comparison->ofUnits; });
    std::vector<double> p;
    for (const std::size_t i : family) p.push_back(findings.conditions[i].comparison->p());
    const auto adjusted = holm(p);
    for (std::size_t k = 0; k < family.size(); ++k) findings.conditions[family[k]].comparison->holm = adjusted[k];
  }
  return findings;
}

}  // namespace surefoot
