// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/findings/evidence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include "core/basics/typed_json.h"
#include "core/files/limited_json.h"
#include "core/life/greedy_trial.h"
#include "core/life/life_measures.h"

namespace surefoot {

namespace {

struct NamedMeasure {
  const char *name, *title;
  double (*of)(const LifeMeasures&);
};

double own(const LifeMeasures& life, std::string_view name) {
  const auto found = std::find_if(life.own.begin(), life.own.end(), [&](const auto& m) { return m.name == name; });
  return found == life.own.end() ? std::numeric_limits<double>::quiet_NaN() : found->value;
}

/// 1 if the robot walks at the end of the life, by the last ten greedy tests.
double walks(const LifeMeasures& life) {
  const double distance = own(life, "greedy_distance");
  return std::isfinite(distance) ? distance > kWalkDistance && own(life, "greedy_falls") <= 0.5 : distance;
}

constexpr NamedMeasure kMeasures[] = {
    {"falls", "falls during learning", [](const LifeMeasures& l) { return l.falls; }},
    {"minutes", "learning time [min]", [](const LifeMeasures& l) { return l.minutes; }},
    {"all_falls", "falls of a life", [](const LifeMeasures& l) { return l.allFalls; }},
    {"end_performance", "falls per episode, last 500", [](const LifeMeasures& l) { return l.endPerformance; }},
    {"average_reward", "average reward at the end", [](const LifeMeasures& l) { return l.averageReward; }},
    {"life_reward", "reward of an episode, whole life", [](const LifeMeasures& l) { return l.lifeReward; }},
    {"success_during", "transitions of a success, during learning",
     [](const LifeMeasures& l) { return l.during.success; }},
    {"success_after", "transitions of a success, after learning",
     [](const LifeMeasures& l) { return l.after.success; }},
    {"failure_during", "transitions of a failure, during learning",
     [](const LifeMeasures& l) { return l.during.failure; }},
    {"failure_after", "transitions of a failure, after learning",
     [](const LifeMeasures& l) { return l.after.failure; }},
    {"first_transitions", "transitions of an episode, first 80",
     [](const LifeMeasures& l) { return l.firstTransitions; }},
    {"walks", "lives that walk", walks},
    {"falls_1_min", "falls by minute 1", [](const LifeMeasures& l) { return l.fallsByMinute[0]; }},
    {"falls_3_min", "falls by minute 3", [](const LifeMeasures& l) { return l.fallsByMinute[1]; }},
    {"falls_6_min", "falls by minute 6", [](const LifeMeasures& l) { return l.fallsByMinute[2]; }},
    {"falls_330", "falls by episode 330", [](const LifeMeasures& l) { return l.fallsByEpisode; }},
    {"exploring", "share of actions that are not the best", [](const LifeMeasures& l) { return own(l, "exploring"); }},
    {"final_falls", "falls of a greedy episode at the end",
     [](const LifeMeasures& l) { return own(l, "final_falls"); }},
    {"final_reward", "reward of a greedy episode at the end",
     [](const LifeMeasures& l) { return own(l, "final_reward"); }},
    {"guarded", "share of the guardian's actions", [](const LifeMeasures& l) { return own(l, "guarded"); }},
    {"risk_said", "risk of a fall, said at the end", [](const LifeMeasures& l) { return own(l, "risk_said"); }},
    {"risk_fell", "falls where this was said", [](const LifeMeasures& l) { return own(l, "risk_fell"); }},
    {"risk_error", "error of the risk", [](const LifeMeasures& l) { return own(l, "risk_error"); }},
    {"price_of_fall", "price of a fall at the end", [](const LifeMeasures& l) { return own(l, "price_of_fall"); }},
    {"rewinds", "falls taken back", [](const LifeMeasures& l) { return own(l, "rewinds"); }}};

}  // namespace

Result<std::vector<Evidence>> readEvidence(const Registry& registry, const Store& store) {
  auto records = readConditions(store);
  if (!records) return records.error();
  std::vector<Evidence> all;
  std::map<std::string, std::vector<TaskMeasure>> tasks;  // by environment: making one takes time
  for (ConditionRecord& record : *records) {
    Evidence e{.record = std::move(record), .averages = {}, .end = {}, .lives = {}, .pool = {}, .configuration = {}};
    e.averages = meanAverageRewards(e.record);
    e.end = endOfLearning(e.averages, e.record.condition.goalReward);
    e.lives = measure(e.record, e.end);
    e.untilOtherEnds = resampledUntilEnd(e.record, e.end);
    e.configuration = parseJson(e.record.condition.configuration);
    if (e.configuration.contains("pre_learning")) e.pool = jsonText(e.configuration["pre_learning"]);
    const std::string environment = textIn(e.configuration, "environment");
    const auto [task, fresh] = tasks.try_emplace(environment);
    if (fresh) task->second = taskMeasuresOf(registry, {environment});
    e.taskMeasures = task->second;
    all.push_back(std::move(e));
  }
  return all;
}

std::vector<std::string> measureNames(const std::vector<TaskMeasure>& task) {
  std::vector<std::string> names;
  for (const NamedMeasure& m : kMeasures) names.emplace_back(m.name);
  for (const LifeMeasure& m : lifeMeasures(task)) names.push_back(m.name);
  return names;
}

std::vector<TaskMeasure> taskMeasuresOf(std::span<const Evidence> evidence) {
  std::vector<TaskMeasure> all;
  for (const Evidence& e : evidence)
    for (const TaskMeasure& m : e.taskMeasures)
      if (!measureAt(all, m.key)) all.push_back(m);
  return all;
}

std::string measureTitle(std::string_view measure, std::span<const Evidence> evidence) {
  for (const NamedMeasure& m : kMeasures)
    if (measure == m.name) return m.title;
  for (const LifeMeasure& m : lifeMeasures(taskMeasuresOf(evidence)))
    if (measure == m.name) return m.titleWithUnit();
  return std::string(measure);
}

std::vector<double> valuesOf(const Evidence& evidence, std::string_view measure) {
  std::vector<double> values;
  for (const NamedMeasure& m : kMeasures)
    if (measure == m.name)
      for (const LifeMeasures& l : evidence.lives) values.push_back(m.of(l));
  for (const LifeMeasure& m : lifeMeasures(evidence.taskMeasures))
    if (measure == m.name)
      for (const LifeMeasures& l : evidence.lives) values.push_back(own(l, measure));
  return values;
}

Groups groupsOf(const Evidence& evidence, std::string_view measure) {
  Groups groups = byQFunction(evidence.record, valuesOf(evidence, measure));
  for (auto& group : groups) std::erase_if(group, [](double v) { return !std::isfinite(v); });
  std::erase_if(groups, [](const auto& group) { return group.empty(); });
  return groups;
}

namespace {

/// Keys that are equal for conditions with the same units; empty: the condition shares no units.
struct UnitKeys {
  std::string qFunctions, lives;
};

UnitKeys keysOf(const Evidence& e) {
  UnitKeys keys;
  const Units units = unitsOf(e.record);
  if (units.areQFunctions && e.hasPool()) {
    std::set<int> numbers;
    for (const StoredLife& l : e.record.lives) numbers.insert(l.qFunction);
    keys.qFunctions = fmt::format("{} of {}", fmt::join(numbers, " "), e.pool);
  }
  if (e.record.paired) {
    keys.lives = "lives";
    for (std::size_t i = 0; i < units.of.size(); ++i)
      keys.lives += fmt::format(" {} {}", units.of[i], e.record.lives[i].life);
  }
  return keys;
}

}  // namespace

bool sameUnits(const Evidence& a, const Evidence& b) {
  const UnitKeys ofA = keysOf(a), ofB = keysOf(b);
  return (!ofA.qFunctions.empty() && ofA.qFunctions == ofB.qFunctions) ||
         (!ofA.lives.empty() && ofA.lives == ofB.lives);
}

std::vector<double> unitMeans(const Evidence& evidence, std::string_view measure) {
  const Units units = unitsOf(evidence.record);
  const std::vector<double> values = valuesOf(evidence, measure);
  std::vector<double> sums(units.count), counts(units.count);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) sums[units.of[i]] += values[i], ++counts[units.of[i]];
  for (std::size_t g = 0; g < units.count; ++g) sums[g] /= counts[g];  // NaN: none has a value
  return sums;
}

std::optional<TestResult> testOfUnits(const Evidence& a, const Evidence& b, std::string_view measure) {
  std::vector<double> first = unitMeans(a, measure), second = unitMeans(b, measure);
  const auto isMissing = [](double v) { return !std::isfinite(v); };
  if (sameUnits(a, b)) {
    std::vector<double> pairs[2];
    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
      if (!isMissing(first[i]) && !isMissing(second[i])) pairs[0].push_back(first[i]), pairs[1].push_back(second[i]);
    return pairedTest(pairs[0], pairs[1]);
  }
  const bool shared = unitsOf(a.record).areQFunctions || unitsOf(b.record).areQFunctions;
  std::erase_if(first, isMissing);
  std::erase_if(second, isMissing);
  return shared ? welchTest(first, second) : anovaOfTwo(first, second);
}

std::optional<CountRatio> countsOf(const Evidence& before, const Evidence& after, std::string_view measure) {
  return countRatio(valuesOf(before, measure), unitsOf(before.record), valuesOf(after, measure), unitsOf(after.record),
                    sameUnits(before, after));
}

std::size_t FirstWithSameUnits::add(const Evidence& evidence) {
  std::size_t first = count_++;
  const UnitKeys keys = keysOf(evidence);
  for (const std::string& key : {keys.qFunctions, keys.lives})
    if (const auto found = firsts_.find(key); !key.empty() && found != firsts_.end())
      first = std::min(first, found->second);
  for (const std::string& key : {keys.qFunctions, keys.lives})
    if (!key.empty()) firsts_.try_emplace(key, count_ - 1);
  return first;
}

namespace {

/// Some of the lives, without what must be measured anew.
Evidence someOf(const Evidence& whole, const std::function<bool(std::size_t)>& isIn) {
  const ConditionRecord& all = whole.record;
  Evidence some{.record = {.condition = all.condition,
                           .lives = {},
                           .episodes = {},
                           .measures = {},
                           .preLearned = all.preLearned,
                           .diverged = all.diverged,
                           .paired = all.paired},
                .averages = whole.averages,
                .end = whole.end,
                .lives = {},
                .pool = whole.pool,
                .configuration = whole.configuration,
                .taskMeasures = whole.taskMeasures};
  for (std::size_t i = 0; i < all.lives.size(); ++i) {
    if (!isIn(i)) continue;
    some.record.lives.push_back(all.lives[i]);
    some.lives.push_back(whole.lives[i]);
    if (i < all.episodes.size()) some.record.episodes.push_back(all.episodes[i]);
    if (i < all.measures.size()) some.record.measures.push_back(all.measures[i]);
  }
  return some;
}

}  // namespace

Evidence halfOf(const Evidence& whole, std::size_t which) {
  const Units units = unitsOf(whole.record);
  Evidence half = someOf(whole, [&](std::size_t i) { return units.of[i] % 2 == which; });
  half.untilOtherEnds = resampledUntilEnd(half.record, half.end);
  return half;
}

Evidence livesOf(const Evidence& whole, int first, int last) {
  Evidence some = someOf(whole, [&](std::size_t i) {
    const int life = whole.record.lives[i].life;
    return life >= first && life < last;
  });
  if (some.record.episodes.size() != some.lives.size()) return some;  // made without episodes: measured as it is
  some.averages = meanAverageRewards(some.record);
  some.end = endOfLearning(some.averages, some.record.condition.goalReward);
  some.lives = measure(some.record, some.end);
  some.untilOtherEnds = resampledUntilEnd(some.record, some.end);
  return some;
}

MeanEstimate estimateOf(const Evidence& evidence, std::string_view measure) {
  const auto values = valuesOf(evidence, measure);
  const Units units = unitsOf(evidence.record);
  MeanEstimate estimate = estimateOf(values, units);
  const auto found = evidence.untilOtherEnds.find(measure);
  if (found != evidence.untilOtherEnds.end()) return estimateOf(estimate.value, found->second, units.count);
  return estimate;
}

Interval meanOf(const Evidence& evidence, std::string_view measure) {
  return intervalOf(estimateOf(evidence, measure));
}

}  // namespace surefoot
