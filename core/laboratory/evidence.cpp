// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace surefoot {

namespace {

struct NamedMeasure {
  const char* name;
  double (*of)(const LifeMeasures&);
};
constexpr NamedMeasure kMeasures[] = {{"falls", [](const LifeMeasures& l) { return l.falls; }},
                                      {"minutes", [](const LifeMeasures& l) { return l.minutes; }},
                                      {"all_falls", [](const LifeMeasures& l) { return l.allFalls; }},
                                      {"end_performance", [](const LifeMeasures& l) { return l.endPerformance; }},
                                      {"average_reward", [](const LifeMeasures& l) { return l.averageReward; }},
                                      {"success_during", [](const LifeMeasures& l) { return l.during.success; }},
                                      {"success_after", [](const LifeMeasures& l) { return l.after.success; }},
                                      {"failure_during", [](const LifeMeasures& l) { return l.during.failure; }},
                                      {"failure_after", [](const LifeMeasures& l) { return l.after.failure; }},
                                      {"first_transitions", [](const LifeMeasures& l) { return l.firstTransitions; }}};

/// What a task may measure besides (measuresOf).
constexpr const char* kOwnMeasures[] = {"falls_per_hour", "distance",        "net_footsteps",        "energy",
                                        "greedy_falls",   "greedy_distance", "greedy_net_footsteps", "greedy_energy",
                                        "greedy_reward",  "walks_after"};

}  // namespace

Result<std::vector<Evidence>> readEvidence(const Store& store) {
  auto records = readConditions(store);
  if (!records) return records.error();
  std::vector<Evidence> all;
  for (ConditionRecord& record : *records) {
    Evidence e{.record = std::move(record), .averages = {}, .end = {}, .lives = {}, .pool = {}, .configuration = {}};
    e.averages = meanAverageRewards(e.record);
    e.end = endOfLearning(e.averages, e.record.condition.goalReward);
    e.lives = measure(e.record, e.end);
    e.configuration = nlohmann::json::parse(e.record.condition.configuration, nullptr, false);
    if (e.configuration.contains("pre_learning")) e.pool = e.configuration["pre_learning"].dump();
    all.push_back(std::move(e));
  }
  return all;
}

std::vector<std::string> measureNames() {
  std::vector<std::string> names;
  for (const NamedMeasure& m : kMeasures) names.emplace_back(m.name);
  names.insert(names.end(), std::begin(kOwnMeasures), std::end(kOwnMeasures));
  return names;
}

std::vector<double> valuesOf(const Evidence& evidence, std::string_view measure) {
  std::vector<double> values;
  for (const NamedMeasure& m : kMeasures)
    if (measure == m.name)
      for (const LifeMeasures& l : evidence.lives) values.push_back(m.of(l));
  if (std::find(std::begin(kOwnMeasures), std::end(kOwnMeasures), measure) == std::end(kOwnMeasures)) return values;
  for (const LifeMeasures& l : evidence.lives) {
    const auto found = std::find_if(l.own.begin(), l.own.end(), [&](const auto& m) { return m.name == measure; });
    values.push_back(found == l.own.end() ? std::numeric_limits<double>::quiet_NaN() : found->value);
  }
  return values;
}

Groups groupsOf(const Evidence& evidence, std::string_view measure) {
  Groups groups = byQFunction(evidence.record, valuesOf(evidence, measure));
  for (auto& group : groups) std::erase_if(group, [](double v) { return !std::isfinite(v); });
  std::erase_if(groups, [](const auto& group) { return group.empty(); });
  return groups;
}

bool shareQFunctions(const Evidence& a, const Evidence& b) {
  return a.hasPool() && a.pool == b.pool;
}

Interval meanOf(const Groups& groups, std::uint64_t seed) {
  if (groups.empty()) {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    return {nothing, nothing, nothing};
  }
  if (groups.size() == 1) return meanInterval(groups[0]).value_or(Interval{groups[0][0], groups[0][0], groups[0][0]});
  Random random(seed);
  return bootstrap(
      {groups}, false, [](const std::vector<double>& means) { return means[0]; }, random);
}

Interval meanOf(const Evidence& evidence, std::string_view measure, std::uint64_t seed) {
  return meanOf(groupsOf(evidence, measure), seed);
}

}  // namespace surefoot
