// SPDX-License-Identifier: GPL-3.0-or-later
// A condition's results as comparisons need them.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "core/findings/uncertain_end.h"

namespace surefoot {

struct Evidence {
  ConditionRecord record;
  std::vector<double> averages;    ///< A(k); [k − 1]
  std::optional<std::size_t> end;  ///< of learning
  std::vector<LifeMeasures> lives;
  std::string pool;              ///< which Q-functions its lives began with; empty: none
  nlohmann::json configuration;  ///< as the store has it
  /// resampledUntilEnd: where another end would have been found with other lives.
  std::map<std::string, std::vector<double>, std::less<>> untilOtherEnds{};

  const std::string& name() const { return record.condition.name; }
  bool hasPool() const { return !pool.empty(); }
};

/// Of all conditions of a store, in order.
Result<std::vector<Evidence>> readEvidence(const Store& store);

/// The names of what is measured of a life: falls, minutes, all_falls, end_performance, average_reward, success_during,
/// success_after, failure_during, failure_after, first_transitions, walks (0 or 1: more than kWalkDistance on the mean
/// of the last ten greedy tests, at most half of which fall); and what a task may measure itself (measuresOf).
std::vector<std::string> measureNames();
/// What a person calls it: "distance of a life [m]".
std::string measureTitle(std::string_view measure);
/// One value a life; NaN where a life has none. Empty for a name that is not there.
std::vector<double> valuesOf(const Evidence& evidence, std::string_view measure);

/// Values of lives by the Q-functions that these began with, without those that are NaN.
Groups groupsOf(const Evidence& evidence, std::string_view measure);
/// The units of both are the same ones: lives with the same seeds, or the same Q-functions.
bool sameUnits(const Evidence& a, const Evidence& b);

/// Finds, of a row of conditions, the first that has the same units (sameUnits), however many there are.
class FirstWithSameUnits {
 public:
  /// The number of the first, from 0; of a condition that shares its units with none before it its own.
  std::size_t add(const Evidence& evidence);

 private:
  std::map<std::string, std::size_t> firsts_;
  std::size_t count_ = 0;
};

/// Mean of one value a life, with all that makes it uncertain.
MeanEstimate estimateOf(const Evidence& evidence, std::string_view measure);
/// The same with its 95 % interval.
Interval meanOf(const Evidence& evidence, std::string_view measure);

}  // namespace surefoot
