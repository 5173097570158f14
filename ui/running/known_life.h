// SPDX-License-Identifier: GPL-3.0-or-later
// The window's own data about a life; the life itself belongs to the learner's thread.
#pragma once

#include <QString>
#include <cstdint>

#include "core/experiment/configuration.h"
#include "core/learned_step.h"

namespace surefoot {

/// How far a life has come.
struct LifeProgress {
  std::int64_t episodes = 0, steps = 0;
  /// Since `before`, enough was learned to be worth saving: an episode is over, or kManySteps were made.
  bool learnedSince(const LifeProgress& before) const {
    return episodes > before.episodes || steps >= before.steps + kManySteps;
  }
  static constexpr std::int64_t kManySteps = 1000;
};

/// The file that Save writes a life to, and how far the life had come when it was written last.
struct LifeFile {
  QString path;  ///< empty: none yet
  LifeProgress saved{};
  bool followed = false;  ///< another process lives this life and writes it; here it is only looked at
};

/// The kinds of files: a session goes on exactly, a Q-function holds the learned values, a journal repeats the life.
enum class SavedAs { Session, QFunction, Journal, PolicyInC };

struct KnownLife {
  Configuration configuration;  ///< as it is now
  Configuration began;          ///< as the life began
  Parameters base;              ///< the values under the chosen preset and scenario
  LifeFile file{};
  LifeProgress progress{};    ///< for the life that runs: valid until its first snapshot
  std::int64_t falls = 0;     ///< at this progress
  std::uint64_t lineage = 1;  ///< says which life it is: undo changes only the life where a change was made
  std::size_t bytes = 0;      ///< approximate memory of the learned values
  StepTaken last{};           ///< the last step, where it was made elsewhere and is known
};

}  // namespace surefoot
