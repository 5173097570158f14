// SPDX-License-Identifier: GPL-3.0-or-later
// A file that tells of a life: what it was told, and where it was left.
#pragma once

#include <memory>
#include <string>

#include "core/difference/difference.h"
#include "core/saved/journal.h"

namespace surefoot {

/// The kind of a file by its first bytes; an error if it is none of a life.
Result<RecordKind> kindOf(const std::string& path);

struct LifeRecordFile {
  std::string path{};
  Journal life{};
  std::shared_ptr<const TensorFile> checkpoint{};  ///< null: a journal
  std::string notLivable{};                        ///< why it cannot be lived again; empty: it can
};

/// A journal or a checkpoint, checked as a whole.
Result<LifeRecordFile> readRecord(const Registry& registry, const std::string& path, RecordKind kind);

}  // namespace surefoot
