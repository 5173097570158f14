// SPDX-License-Identifier: GPL-3.0-or-later
// The findings of a store: the measures of every condition with 95 % intervals, and its comparison with the
// reference condition.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "core/findings/evidence.h"
#include "core/statistics/count_model.h"

namespace surefoot {

inline constexpr double kNoTest = std::numeric_limits<double>::quiet_NaN();  ///< p where one life is compared

/// A condition against the reference at a moment that does not depend on when learning ended.
struct FixedChange {
  std::string measure;  ///< the last of falls_1_min, falls_3_min, falls_6_min that both have, or falls_330
  Interval change;      ///< in per cent
  double p = kNoTest;   ///< of the units
};

/// A condition against the reference, in falls during learning.
struct Comparison {
  std::optional<FixedChange> fixed;
  /// The same as counts, where one of the two falls less than five times: a t interval cannot tell there.
  std::optional<CountRatio> counts;
  std::optional<TestResult> ofUnits;       ///< testOfUnits: the p of tables and verdicts
  Interval change;                         ///< in per cent; −45: 45 % fewer. NaN where the reference has no falls
  Interval difference;                     ///< in falls; −90: 90 fewer
  std::optional<TestResult> anova, welch;  ///< the thesis's test; the same without equal variances
  std::optional<TestResult> paired;        ///< where life i shares its seeds or its Q-function with life i of the other
  double holm = kNoTest;                   ///< p of the units, adjusted for the conditions compared
  std::optional<double> effect;            ///< Hedges' g
  /// Lives a condition (pairs of lives, where there are pairs) that show this difference at p < .01 with a power of
  /// 80 %. None where lives share Q-functions: of these it would take more, not of lives.
  std::optional<std::int64_t> livesNeeded;
  std::optional<Interval> minutes;  ///< learning time: difference from the reference
  /// Change of falls up to the reference's end of learning, in per cent; the interval treats this end as certain.
  std::optional<Interval> changeAtItsEnd;

  double p() const { return ofUnits ? ofUnits->p : kNoTest; }
  bool significant() const { return p() < 0.01; }  ///< the thesis's X
};

/// How the falls of a condition's lives during learning are spread (distribution.h).
struct SpreadOfFalls {
  Interval iqm, median, most;  ///< `most`: nine of ten lives fall less often
  Interval worst;              ///< mean of the worst tenth
  double withoutFall = 0.0;    ///< share of the lives
};

struct Finding {
  std::string name, reference;
  int lives = 0, diverged = 0;
  std::optional<std::size_t> end;  ///< the episode in which learning ended
  Interval endRange;               ///< it and 95 % of the ends of resampled lives; infinite: it never ended
  double largestChangeAfter = 0.0;
  Interval falls, minutes, allFalls, endPerformance, averageReward;
  std::array<Interval, 3> fallsByMinute;  ///< at kFixedMinutes
  Interval fallsByEpisode;                ///< 330
  SpreadOfFalls spread;
  std::optional<Interval> improvement;          ///< chance that a life falls less than one of the reference
  Interval exploring, finalFalls, finalReward;  ///< NaN in stores that do not have them
  Interval successDuring, successAfter, failureDuring, failureAfter;  ///< transitions; NaN where there are none
  std::optional<Interval> threshold;                                  ///< the rule of thumb with n* during learning
  int qFunctions = 0, atCap = 0;                       ///< pre-learned Q-functions; how many did not reach their reward
  std::optional<VarianceComponent> betweenQFunctions;  ///< variance of the falls
  std::optional<Comparison> comparison;
  std::vector<std::string> warnings;
};

struct Findings {
  StoredPlan plan;
  bool complete = true;  ///< all lives that were planned are there
  std::vector<Finding> conditions;
  std::vector<std::string> found{};  ///< of a plan whose lives grew: what was decided or chosen (growth.h)
};

/// The same store always gives the same findings.
Findings findingsOf(StoredPlan plan, const std::vector<Evidence>& evidence);
/// The findings of a whole store.
Result<Findings> findingsOf(const Registry& registry, const Store& store);

/// "−45.0 (−55.1 … −32.0)", as a table says it: per cent, or where the reference has no falls the difference in falls.
std::string changeText(const Comparison& comparison, int decimals);

nlohmann::ordered_json findingsAsJson(const Findings& findings);
/// One row per condition, for other programs.
std::string findingsAsCsv(const Findings& findings);
/// A table for LaTeX that needs no package.
std::string findingsAsLatex(const Findings& findings);
/// Tables for people, with the warnings below them.
std::string findingsAsTable(const Findings& findings);

}  // namespace surefoot
