// SPDX-License-Identifier: GPL-3.0-or-later
// Many lives with derived seeds on a pool of threads; the same bytes for any number of threads.
#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "core/calibration.h"
#include "core/experiment/configuration.h"
#include "core/experiment/final_greedy.h"
#include "core/experiment/meter.h"
#include "core/life/rule_of_thumb.h"

namespace surefoot {

/// The results of a life, when it is over.
struct LifeResult {
  int life = 0;  ///< from 0
  LifeTotals totals;
  std::int64_t steps = 0;
  double simulatedSeconds = 0.0;   ///< NaN: no clock
  double averageReward = 0.0;      ///< mean of the last 80 episodes
  std::int64_t statesOutside = 0;  ///< states outside the range that the features cover
  std::int64_t flewApart = 0;      ///< Environment::cutOffs
  double cpuSeconds = 0.0;         ///< CPU time of its thread for learning
  double testSeconds = 0.0;        ///< CPU time of its thread for greedy tests
  std::vector<MemoryUse> memory;   ///< memory of its tables
  std::optional<RuleOfThumb> ruleOfThumb;
  std::uint64_t hash = 0;
  std::string divergence;       ///< why it stopped, or empty
  std::string unanswered{};     ///< Life::unanswered: it stopped, and can go on
  std::vector<Change> changes;  ///< the changes made while it went on
  bool changesLeftOut = false;  ///< there were more changes than these
  bool complete = false;        ///< a limit was reached; false: diverged or interrupted
  std::vector<TaskMeasure> taskMeasures;
  int testEvery = 0;                                 ///< Task::testEvery
  double exploring = 0.0;                            ///< share of the steps whose action was not the best by q̂
  double guarded = 0.0;                              ///< share of the steps in which the guardian acted
  std::optional<Calibration::Report> calibration{};  ///< of the risk, if it is learned
  std::optional<double> priceOfFall{};               ///< at the end, of a falls budget
  bool mayRewind = false;                            ///< falls are taken back: totals.rewinds
  std::optional<FinalGreedy> final{};                ///< only where it was made
  std::vector<GreedyTest> greedyTests;
  std::vector<EpisodeRow> rows;  ///< only if asked for
};

LifeResult summarise(const Life& life, int index, double cpuSeconds);

/// A measure of a life by its name.
struct NamedValue {
  std::string name;
  double value = 0.0;
};
/// The values of lifeMeasures(), the share of exploring steps (`exploring`) and of the guardian's (`guarded`), whether
/// the risk holds (`risk_said`, `risk_fell`, `risk_error`: Calibration), Λ (`price_of_fall`), the falls that
/// were taken back (`rewinds`), and what the greedy policy, under its caution but without its guardian, does at the end
/// (`final_falls`, `final_reward`: from `final`, or from the last ten greedy tests); measures that a life does not
/// have, as without a clock or a greedy test, are left out.
std::vector<NamedValue> measuresOf(const LifeResult& result);

struct RunOptions {
  /// Makes life number `index`; if empty, makeLife does.
  std::function<Result<std::unique_ptr<Life>>(int index)> make{};
  /// Called on a life's thread when it is over, whatever ended it, and after every `visitEvery` steps if that is set;
  /// the life's inputs are kept then, so that it can be saved.
  std::function<void(const Life& life)> visit{};
  std::int64_t visitEvery = std::numeric_limits<std::int64_t>::max();
  int jobs = 1;           ///< threads
  bool keepRows = false;  ///< the episode log of every life
  /// With keepRows: takes the rows again and again while a life goes on, on its thread; its result has none then.
  std::function<void(int index, std::vector<EpisodeRow> rows)> takeRows{};
  const std::atomic<bool>* interrupted = nullptr;  ///< set by anyone: running lives stop where they are
  std::function<void(const Progress&)> progress;   ///< about four times a second, on the calling thread
};

/// Runs every life; the result is in order of their numbers. Lives never started (interrupted) are left out.
Result<std::vector<LifeResult>> runLives(const Registry& registry, const Configuration& configuration,
                                         const RunOptions& options);

}  // namespace surefoot
