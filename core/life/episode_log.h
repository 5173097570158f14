// SPDX-License-Identifier: GPL-3.0-or-later
// The log of a life, episode by episode.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "core/basics/hash64.h"
#include "core/environment.h"
#include "core/files/archive.h"
#include "core/life/end_of_learning.h"

namespace surefoot {

/// Lower than every reward, but finite, so that files can hold it.
inline constexpr double kNoReward = -1e300;

/// One finished episode.
struct EpisodeRow {
  std::int64_t episode = 0;    ///< from 1
  std::int64_t steps = 0;      ///< transitions of this episode
  std::int64_t lifeSteps = 0;  ///< transitions of the life up to its end
  double reward = 0.0;         ///< total, undiscounted
  int falls = 0;
  bool success = false;  ///< it ended in a success
  Ending ending = Ending::None;
  double averageReward = 0.0;  ///< over the last 80 episodes, this one included
  EpisodeMeasures measures{};  ///< Task::measures
  double highest = kNoReward;  ///< highest reward of one transition
  int rewinds = 0;             ///< falls that were taken back (rewinding.h), which are not among `falls`
};

/// Counts and sums over a whole life; episodes cut by the end of the life are not counted.
struct LifeTotals {
  std::int64_t episodes = 0, falls = 0, successes = 0, failures = 0;
  std::int64_t successSteps = 0, failureSteps = 0;         ///< transitions of the successful and of the failed episodes
  std::int64_t successesAfter = 0, successStepsAfter = 0;  ///< successes after learning ended; their transitions
  EpisodeMeasures measures{};                              ///< TaskMeasure::ofALife; of a mean: the sum
  double highestReward = kNoReward;                        ///< highest reward of one transition
  std::int64_t rewinds = 0;                                ///< falls that were taken back
};

class EpisodeLog {
 public:
  static constexpr int kAverageOver = 80;  ///< episodes (thesis, section 4.2.1)

  /// `keepRows`: rows() holds every episode. Otherwise memory does not grow with the life.
  explicit EpisodeLog(bool keepRows = false, const std::vector<TaskMeasure>& measures = {});

  /// One transition of the episode in hand.
  void add(const Outcome& outcome) {
    ++current_.steps;
    current_.reward += outcome.reward;
    current_.highest = std::max(current_.highest, outcome.reward);
    current_.falls += outcome.event == Event::Fall;
    current_.success |= outcome.event == Event::Success;
  }
  /// The last transition was a fall that is taken back: it counts as a rewind.
  void takeFallBack() {
    --current_.falls;
    ++current_.rewinds;
  }
  /// The episode in hand is over. Returns its row.
  /// `bestReturn` is the highest reward of an episode, for the end of learning; `measures` are its Task::measures.
  const EpisodeRow& finish(Ending ending, std::int64_t lifeSteps, double bestReturn = kInfinity,
                           std::span<const double> measures = {});

  const LifeTotals& totals() const { return totals_; }
  /// Mean total reward of the last 80 episodes, or of those so far; 0 before the first.
  double averageReward() const { return last_.averageReward; }
  const EpisodeRow& last() const { return last_; }
  /// Forgets the current episode; its steps still count as steps of the life.
  void giveUp() { current_ = {}; }
  const EpisodeRow& current() const { return current_; }
  const EndOfLearning& endOfLearning() const { return end_; }
  const std::vector<EpisodeRow>& rows() const { return rows_; }
  /// Takes the rows kept so far out of the log.
  std::vector<EpisodeRow> takeRows() { return std::exchange(rows_, {}); }
  const Hash64& hash() const { return hash_; }

  /// The whole log, to a file or from one.
  void transfer(Archive& archive);

 private:
  bool keepRows_;
  std::array<TaskMeasure::OfALife, kMaxMeasures> ofALife_{};
  EpisodeRow current_, last_;
  LifeTotals totals_;
  std::array<double, kAverageOver> recent_{};  // a ring of total rewards
  std::vector<EpisodeRow> rows_;
  EndOfLearning end_;
  Hash64 hash_;
};

}  // namespace surefoot
