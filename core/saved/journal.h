// SPDX-License-Identifier: GPL-3.0-or-later
// A record of everything done to a life, so that it can be lived again: JSON lines. The first line has the
// configuration at the beginning and the seed. Then comes one line for every change of a parameter or of the policy and
// every push, with its step. The last line says at which step the life was left, with its hash.
#pragma once

#include <string>

#include "core/experiment/configuration.h"
#include "core/experiment/experiment.h"
#include "core/saved/checkpoint.h"

namespace surefoot {

/// The life began with `configuration`.
std::string journalOf(const Configuration& configuration, const LifeResult& life);

struct Journal {
  Configuration configuration;  ///< with the commands and the loaded Q-function
  int life = 0;
  std::int64_t steps = 0;                ///< steps of the life when it was left
  std::uint64_t hash = 0;                ///< hash when it was left
  std::int64_t episodes = 0, falls = 0;  ///< until it was left
  int livesVersion = 0;                  ///< lives_version.h of its program; 0: not noted
  std::string program{};                 ///< the version of its program; empty: this one, or not noted

  /// Whether a life that was lived again came out the same.
  bool sameAs(const LifeResult& lived) const {
    return lived.hash == hash && lived.totals.episodes == episodes && lived.totals.falls == falls;
  }
};

/// Reads a journal from text; `name` is the journal's file. A Q-function that the life began with is read, too, from
/// the journal's folder or the current folder; it must still have the same values.
Result<Journal> parseJournal(const Registry& registry, const std::string& text, const std::string& name);
Result<Journal> readJournal(const Registry& registry, const std::string& path);

/// The journal of a saved life, with the commands that were still to come: by it the life can be lived again. `name` is
/// the file of the saved life.
Result<Journal> journalOf(const Registry& registry, const Resumed& saved, const std::string& name);
/// The same without the Q-functions that the life began with or was guarded by: to compare it, not to live it.
Journal toldTo(const Resumed& saved);

/// Lives it again, up to the step where it was left.
Result<LifeResult> replay(const Registry& registry, const Journal& journal, const RunOptions& options);

}  // namespace surefoot
