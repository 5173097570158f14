// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis's measures, from the episodes of a store. Episodes count from 1; the average reward is the mean of the
// last 80 episodes, or of all so far if there are fewer.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/statistics/mean_estimate.h"
#include "core/store/store.h"

namespace surefoot {

/// All lives of a condition that did not diverge.
struct ConditionRecord {
  StoredCondition condition;
  std::vector<StoredLife> lives;
  std::vector<std::vector<StoredEpisode>> episodes;  ///< [life][episode]
  std::vector<std::vector<StoredMeasure>> measures;  ///< [life]; measures of greedy tests are included
  std::vector<StoredPreLearning> preLearned;
  int diverged = 0;     ///< lives left out
  bool paired = false;  ///< life i has the same seeds in every condition

  /// Number of episodes of the shortest life.
  std::size_t shortest() const;
};

/// All conditions of a store, in order.
Result<std::vector<ConditionRecord>> readConditions(const Store& store);

/// The average reward after every episode of a life.
std::vector<double> averageRewards(const std::vector<StoredEpisode>& episodes);
/// A(k): their mean over lives, up to the end of the shortest; [k − 1].
std::vector<double> meanAverageRewards(const ConditionRecord& record);

/// End of learning (thesis, section 4.2.1): the first episode k ≥ 330 with |A(k) − A(k − 250)| < 3 (of a goal reward of
/// 200: 1.5 % of it, so that another goal has the same end; 3 where there is no goal) and (ours, because the flat start
/// would count) A(k) > 0.75·goal. Empty: it never ended.
std::optional<std::size_t> endOfLearning(const std::vector<double>& a, double goalReward);
/// The largest |A(k) − A(k − 250)| behind episode `end`; 0 if there is nothing behind it.
double largestChangeAfter(const std::vector<double>& a, std::size_t end);

/// Mean transitions of successful and of failed episodes; NaN where there are none.
struct Lengths {
  double success = 0.0, failure = 0.0;
};

inline constexpr std::array kFixedMinutes = {1.0, 3.0, 6.0};
inline constexpr std::size_t kFixedEpisodes = 330;

/// One life, measured up to the end of its condition's learning.
struct LifeMeasures {
  double falls = 0.0;             ///< during learning
  double minutes = 0.0;           ///< simulated minutes of learning; NaN without a clock
  double allFalls = 0.0;          ///< falls of the whole life
  double endPerformance = 0.0;    ///< falls per episode over the last 500
  double averageReward = 0.0;     ///< at the end of the life
  double lifeReward = 0.0;        ///< reward of an episode, over all of the life
  double firstTransitions = 0.0;  ///< transitions per episode, over the first 80
  /// Falls of the episodes that were over by a fixed moment, whenever learning ended: kFixedMinutes, or episode
  /// kFixedEpisodes. NaN: the life is shorter, by its steps, to which an unfinished last episode belongs.
  std::array<double, 3> fallsByMinute{};
  double fallsByEpisode = 0.0;
  std::vector<StoredMeasure> own{};  ///< measures of its task (measuresOf)
  Lengths during, after;
};

/// `end`: the last episode of learning; the whole life if it never ended.
std::vector<LifeMeasures> measure(const ConditionRecord& record, std::optional<std::size_t> end);

/// Falls of every life up to an episode.
std::vector<double> fallsUntil(const ConditionRecord& record, std::size_t episode);

/// The independent units: lives; or, where lives share several Q-functions, the Q-functions, in order.
Units unitsOf(const ConditionRecord& record);
/// The values of lives, one group per Q-function, in the order of the Q-functions; one group if there was none.
Groups byQFunction(const ConditionRecord& record, Sample values);

/// A curve over lives with its 95 % band; for one life without a band.
struct Curve {
  std::vector<double> x;
  std::vector<Interval> y;
};
/// Average reward against simulated minutes, at `points` moments up to the end of the shortest life. Moments before all
/// lives have finished an episode are left out. Where the task has no clock: against episodes.
Curve learningCurve(const ConditionRecord& record, std::size_t points);
/// Average reward after the f-th fall; a life with fewer falls keeps its last value.
Curve rewardAgainstFalls(const ConditionRecord& record);
/// Falls so far against simulated minutes.
Curve cumulativeFalls(const ConditionRecord& record, std::size_t points);

}  // namespace surefoot
