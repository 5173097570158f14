// SPDX-License-Identifier: GPL-3.0-or-later
// A condition's results as comparisons need them.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "core/findings/uncertain_end.h"
#include "core/registry.h"
#include "core/statistics/count_model.h"

namespace surefoot {

struct Evidence {
  ConditionRecord record;
  std::vector<double> averages;    ///< A(k); [k − 1]
  std::optional<std::size_t> end;  ///< end of learning
  std::vector<LifeMeasures> lives;
  std::string pool;                         ///< which Q-functions its lives began with; empty: none
  nlohmann::json configuration;             ///< as the store has it
  std::vector<TaskMeasure> taskMeasures{};  ///< of its environment
  /// From resampledUntilEnd; empty if no resample of the lives gives another end.
  std::map<std::string, std::vector<double>, std::less<>> untilOtherEnds{};

  const std::string& name() const { return record.condition.name; }
  bool hasPool() const { return !pool.empty(); }
};

/// The evidence of all conditions of a store, in order.
Result<std::vector<Evidence>> readEvidence(const Registry& registry, const Store& store);

/// Falls at fixed moments: comparisons take the first of these that both conditions have.
inline constexpr std::array kFixedMeasures = {"falls_6_min", "falls_3_min", "falls_1_min", "falls_330"};

/// The names of the measures of a life: falls, minutes, all_falls, end_performance, average_reward, life_reward,
/// success_during, success_after, failure_during, failure_after, first_transitions, walks (0 or 1: more than
/// kWalkDistance on the mean of the last ten greedy tests, at most half of which fall); at fixed moments falls_1_min,
/// falls_3_min, falls_6_min, falls_330; exploring; final_falls and final_reward (final_greedy.h); and what follows from
/// the task's own (lifeMeasures).
std::vector<std::string> measureNames(const std::vector<TaskMeasure>& task);
/// The measures of the tasks of all these conditions.
std::vector<TaskMeasure> taskMeasuresOf(std::span<const Evidence> evidence);
/// The title of a measure for people: "distance of a life [m]".
std::string measureTitle(std::string_view measure, std::span<const Evidence> evidence);
/// One value per life; NaN where a life has none. Empty for a name that the task does not have.
std::vector<double> valuesOf(const Evidence& evidence, std::string_view measure);

/// Values of lives, grouped by the Q-functions that the lives began with; values that are not finite are left out.
Groups groupsOf(const Evidence& evidence, std::string_view measure);
/// Whether both have the same units: lives with the same seeds, or the same Q-functions.
bool sameUnits(const Evidence& a, const Evidence& b);

/// The means of the units (unitsOf), in their order; lives without a value are left out.
std::vector<double> unitMeans(const Evidence& evidence, std::string_view measure);
/// Whether two conditions differ in a measure, by their units: pairs of units where both have the same; means of
/// Q-functions against each other (Welch) where lives share several; else the analysis of variance of the lives.
std::optional<TestResult> testOfUnits(const Evidence& a, const Evidence& b, std::string_view measure);

/// Their counts in a measure as counts (count_model.h); empty: not all values are counts.
std::optional<CountRatio> countsOf(const Evidence& before, const Evidence& after, std::string_view measure);

/// Finds, for each of a row of conditions, the first condition with the same units (sameUnits).
class FirstWithSameUnits {
 public:
  /// The number of that first condition, from 0; a condition's own number if no earlier one has its units.
  std::size_t add(const Evidence& evidence);

 private:
  std::map<std::string, std::size_t> firsts_;
  std::size_t count_ = 0;
};

/// Every second unit of a condition's lives, from the first (0) or the second (1) on: what was chosen by one half is
/// reported from the other. It keeps the whole condition's end of learning.
Evidence halfOf(const Evidence& evidence, std::size_t which);

/// The lives numbered from `first` up to before `last`, as a study of its own: with their own end of learning.
Evidence livesOf(const Evidence& evidence, int first, int last);

/// Mean of one value per life, with its error.
MeanEstimate estimateOf(const Evidence& evidence, std::string_view measure);
/// The same with its 95 % interval.
Interval meanOf(const Evidence& evidence, std::string_view measure);

}  // namespace surefoot
