// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/life_measures.h"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

/// "mean distance": what it is for a whole life.
std::string titleOfALife(const TaskMeasure& m) {
  switch (m.ofALife) {
    case TaskMeasure::OfALife::Sum:
      break;
    case TaskMeasure::OfALife::Mean:
      return "mean " + m.title;
    case TaskMeasure::OfALife::Last:
      return "last " + m.title;
    case TaskMeasure::OfALife::Largest:
      return "largest " + m.title;
  }
  return m.title;
}

}  // namespace

std::vector<LifeMeasure> lifeMeasures(const std::vector<TaskMeasure>& measures) {
  if (measures.empty()) return {};
  std::vector<LifeMeasure> all = {{"falls_per_hour", "falls an hour", "", false}};
  for (const TaskMeasure& m : measures) all.push_back({m.key, titleOfALife(m) + " of a life", m.unit, false});
  const auto addGreedy = [&all](const std::string& key, const std::string& title, const std::string& unit) {
    all.push_back({"greedy_" + key, title + " of a greedy test, last 10", unit, true});
  };
  for (const TaskMeasure& m : measures) addGreedy(m.key, m.title, m.unit);
  addGreedy("reward", "reward", "");
  addGreedy("falls", "falls", "");
  if (measureAt(measures, "distance")) all.push_back({"walks_after", "time to the first greedy walk", "min", true});
  return all;
}

double together(TaskMeasure::OfALife what, double before, double next, bool first) {
  switch (what) {
    case TaskMeasure::OfALife::Sum:
    case TaskMeasure::OfALife::Mean:
      break;
    case TaskMeasure::OfALife::Last:
      return next;
    case TaskMeasure::OfALife::Largest:
      return first ? next : std::max(before, next);
  }
  return before + next;
}

double valueOfALife(const TaskMeasure& measure, double total, std::int64_t episodes) {
  if (measure.ofALife == TaskMeasure::OfALife::Sum) return total;
  if (episodes == 0) return std::nan("");
  return measure.ofALife == TaskMeasure::OfALife::Mean ? total / static_cast<double>(episodes) : total;
}

}  // namespace surefoot
