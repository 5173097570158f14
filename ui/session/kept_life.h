// SPDX-License-Identifier: GPL-3.0-or-later
// A life that gave way to another one, with everything that the window knew of it: undo brings it back as it was.
#pragma once

#include <QString>
#include <deque>
#include <memory>
#include <optional>
#include <utility>

#include "core/experiment/configuration.h"
#include "core/live/learner_thread.h"
#include "ui/session/run_curves.h"

namespace surefoot {

/// How far a life has come.
struct LifeProgress {
  std::int64_t episodes = 0, steps = 0;
  /// From `before` on something was learned that a person would miss: an episode is over, or kManySteps are made.
  bool learnedSince(const LifeProgress& before) const {
    return episodes > before.episodes || steps >= before.steps + kManySteps;
  }
  static constexpr std::int64_t kManySteps = 1000;
};

/// The file that Save writes a life to, and how far the life had come when it was written last.
struct LifeFile {
  QString path;  ///< empty: none yet
  LifeProgress saved{};
};

struct KeptLife {
  std::shared_ptr<LifeAside> aside;  ///< null: it had to make room for others
  Configuration configuration, began;
  Parameters base;
  LifeFile file;
  LifeProgress progress;
  std::uint64_t lineage = 0;
  std::size_t bytes = 0;            ///< of memory, about
  int curve = 0;                    ///< its number among the curves
  std::string curvesIn;             ///< the environment of the curves
  std::optional<RunCurves> curves;  ///< those beside it, where the life after it is in another environment
  std::deque<Fall> falls;
  std::deque<std::pair<std::int64_t, std::shared_ptr<const ActionValueFunction>>> valuesThen;

  bool unsaved() const { return aside && progress.learnedSince(file.saved); }
};

/// Memory that can still be had on this machine [bytes]; nothing where it does not tell.
std::optional<std::size_t> availableMemory();

}  // namespace surefoot
