// SPDX-License-Identifier: GPL-3.0-or-later
// Reads any bytes as everything that files can be, and uses what the readers accept: a learner is made from it and
// lives for some steps. Whatever the bytes, this must return.
#pragma once

#include "core/saved/checkpoint.h"
#include "core/saved/journal.h"
#include "core/saved/q_file.h"

namespace surefoot {

inline void liveFor(Life& life, int steps) {
  for (int i = 0; i < steps && !life.finished(); ++i) life.step();
}

inline void useFile(const Registry& registry, const std::string& bytes) {
  const auto journal = parseJournal(registry, bytes, "file");
  if (journal && !journal->configuration.start)
    if (const auto life = makeLife(registry, journal->configuration, journal->life, false)) liveFor(**life, 20);

  auto parsed = TensorFile::parse(bytes, "file");
  if (!parsed) return;
  const auto file = std::make_shared<const TensorFile>(std::move(*parsed));
  if (checkKind(*file, {"q-function", "checkpoint"}))
    if (auto configuration = configurationOf(registry, *file)) {
      beginWith(*configuration, file);
      if (const auto life = makeLife(registry, *configuration, 0, false)) liveFor(**life, 20);
    }
  if (auto resumed = resume(registry, file, {})) liveFor(*resumed->life, 20);
}

}  // namespace surefoot
