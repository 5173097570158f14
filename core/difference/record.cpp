// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/difference/record.h"

#include "core/basics/typed_json.h"
#include "core/files/read_file.h"
#include "core/saved/checkpoint.h"
#include "core/saved/q_file.h"

namespace surefoot {

namespace {

constexpr std::string_view kLogHead = "life,episode,";

Result<LifeRecordFile> readCheckpoint(const Registry& registry, const std::string& path) {
  auto file = readQFile(path);
  if (!file) return file.error();
  if (const Status s = checkKind(**file, {"checkpoint"}); !s) return s.error();
  auto resumed = resume(registry, *file, {}, Versions::Any);
  if (!resumed) return resumed.error();
  LifeRecordFile record{.path = path};
  record.checkpoint = *file;
  auto journal = journalOf(registry, *resumed, path);
  if (!journal) {  // the file that the life began with is not at hand, say
    record.notLivable = journal.error().message;
    journal = toldTo(*resumed);
  }
  record.life = std::move(*journal);
  return record;
}

}  // namespace

Result<RecordKind> kindOf(const std::string& path) {
  const auto head = readHead(path, kLogHead.size());
  if (!head) return head.error();
  if (head->starts_with('{')) return RecordKind::Journal;
  if (*head == kLogHead) return RecordKind::Log;
  if (head->size() == kLogHead.size() && (*head)[8] == '{') return RecordKind::Checkpoint;  // safetensors
  return fileError(path, "it is no journal, no checkpoint (or session) and no log of lives.");
}

Result<LifeRecordFile> readRecord(const Registry& registry, const std::string& path, RecordKind kind) {
  if (kind == RecordKind::Checkpoint) return readCheckpoint(registry, path);
  auto journal = readJournal(registry, path);
  if (!journal) return journal.error();
  return LifeRecordFile{.path = path, .life = std::move(*journal)};
}

}  // namespace surefoot
