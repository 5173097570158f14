// SPDX-License-Identifier: GPL-3.0-or-later
// What was done to a life, so that it can be lived again: JSON lines. The first holds the configuration that it began
// with and its seed, then follows a line for every parameter change, change of policy and push, with its step; the last
// tells where the life was left, with its hash.
#pragma once

#include <string>

#include "core/experiment/configuration.h"
#include "core/experiment/experiment.h"

namespace surefoot {

/// `configuration` is the one that the life began with.
std::string journalOf(const Configuration& configuration, const LifeResult& life);

struct Journal {
  Configuration configuration;  ///< with the commands, and what was loaded
  int life = 0;
  std::int64_t steps = 0;                ///< of the life when it was left
  std::uint64_t hash = 0;                ///< then
  std::int64_t episodes = 0, falls = 0;  ///< then
  int livesVersion = 0;                  ///< of the program that lived it (lives_version.h); 0: not noted

  /// Whether a life that was lived again came out the same.
  bool sameAs(const LifeResult& lived) const {
    return lived.hash == hash && lived.totals.episodes == episodes && lived.totals.falls == falls;
  }
};

/// Reads a journal from text; `name` is the file's. A Q-function that the life began with is read, too, from beside the
/// journal or the current folder, and must hold the values that it held.
Result<Journal> parseJournal(const Registry& registry, const std::string& text, const std::string& name);
Result<Journal> readJournal(const Registry& registry, const std::string& path);

/// Lives it again, up to the step where it was left.
Result<LifeResult> replay(const Registry& registry, const Journal& journal, const RunOptions& options);

}  // namespace surefoot
