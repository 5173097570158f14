// SPDX-License-Identifier: GPL-3.0-or-later
// What the window knows of a life besides the life itself, which belongs to the learner's thread.
#pragma once

#include <QString>
#include <cstdint>

#include "core/experiment/configuration.h"

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

/// What a life can be saved as: to go on exactly, what it learned, or a small text by which it can be lived again.
enum class SavedAs { Session, QFunction, Journal };

struct KnownLife {
  Configuration configuration;  ///< as it is now
  Configuration began;          ///< as the life began
  Parameters base;              ///< the values under the chosen preset and scenario
  LifeFile file{};
  LifeProgress progress{};    ///< of the life that runs: until its first snapshot
  std::int64_t falls = 0;     ///< up to there
  std::uint64_t lineage = 1;  ///< changes that were made to one life are not undone in another
  std::size_t bytes = 0;      ///< of memory that what it learned takes, about
};

}  // namespace surefoot
