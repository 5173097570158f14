// SPDX-License-Identifier: GPL-3.0-or-later
// What two records of lives differ in. Lives are told what to do (a configuration, commands with their steps); what was
// told the same comes out the same, bit for bit, so only lives that were told otherwise are lived again, side by side,
// to the first step that differs. Logs are compared row by row. Any thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/basics/result.h"
#include "core/registry.h"

namespace surefoot {

enum class RecordKind { Journal, Checkpoint, Log };
/// "journal"; a session of the window is a checkpoint.
const char* nameOf(RecordKind kind);

/// What a thing is in the first and in the second record, as a person writes it.
struct TwoValues {
  std::string what, first, second;
};

/// Something that two lives were told: a setting at their beginning, or the first command that is another.
struct ToldOtherwise : TwoValues {
  std::optional<std::int64_t> step{};  ///< steps of the life before the command; none: at its beginning
};

/// The first place where two records part.
struct Parting : TwoValues {
  std::optional<std::int64_t> step{};     ///< so many steps of the life are the same; none: not known
  std::optional<std::int64_t> life{};     ///< of a log, from 0
  std::optional<std::int64_t> episode{};  ///< from 1
};

struct RecordDifference {
  RecordKind kind = RecordKind::Journal;
  std::vector<ToldOtherwise> told{};  ///< settings, and the first command
  std::optional<Parting> parting{};   ///< none: nothing that was lived differs, as far as it was compared
  std::int64_t same = 0;              ///< steps, or rows of a log, that are the same
  std::string note{};                 ///< what could not be compared, and why; empty: everything was

  bool differ() const { return !told.empty() || parting; }
};

/// Compares two journals, two checkpoints (sessions) or two logs of lives. Errors: a file that is none of these, is
/// broken, or is of another kind than the other; a life that cannot be lived again; `interrupted`, which anyone may
/// set.
Result<RecordDifference> differenceOf(const Registry& registry, const std::string& first, const std::string& second,
                                      const std::atomic<bool>* interrupted = nullptr);

/// For a person, each line of it one difference.
std::string differenceText(const RecordDifference& difference, const std::string& first, const std::string& second);
std::string differenceAsJson(const RecordDifference& difference);

}  // namespace surefoot
