// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/train_from.h"

#include <fmt/format.h>

#include "core/files/read_file.h"
#include "core/files/refused_tensor.h"
#include "core/saved/checkpoint.h"
#include "core/saved/journal.h"
#include "core/saved/q_file.h"

namespace surefoot {

namespace {

Result<LivedBefore> ofJournal(const Registry& registry, const std::string& text, const std::string& path) {
  auto journal = parseJournal(registry, text, path);
  if (!journal) return journal.error();
  if (journal->life != 0)
    return fileError(path,
                     fmt::format("it is of life {} of several; `surefoot replay` lives it again.", journal->life + 1));
  return LivedBefore{std::move(journal->configuration), journal->steps};
}

/// A session holds the life itself; the journal made from it tells how to repeat the life.
Result<LivedBefore> ofSession(const Registry& registry, std::shared_ptr<const TensorFile> file,
                              const std::string& path) {
  const auto resumed = resume(registry, file, {}, Versions::Any);
  if (!resumed) {
    const std::string program = otherProgramOf(*file);
    auto configuration = configurationOf(registry, *file);
    if (program.empty() || !configuration) return resumed.error();
    return LivedBefore{std::move(*configuration),
                       {},
                       fmt::format("{}: Surefoot {} wrote it; what was done to its life "
                                   "is left out.",
                                   path, program)};
  }
  auto journal = journalOf(registry, *resumed, path);
  if (!journal) return journal.error();
  return LivedBefore{std::move(journal->configuration), journal->steps};
}

}  // namespace

Result<LivedBefore> readLivedBefore(const Registry& registry, const std::string& path) {
  const auto head = readHead(path, 1);
  if (!head) return head.error();
  if (*head == "{") {
    const auto text = readText(path);
    return text ? ofJournal(registry, *text, path) : text.error();
  }
  auto file = readQFile(path);
  if (!file) return file.error();
  if ((*file)->about.value("kind", "") == "checkpoint") return ofSession(registry, std::move(*file), path);
  auto configuration = configurationOf(registry, **file);
  if (!configuration) return configuration.error();
  return LivedBefore{std::move(*configuration), {}};
}

}  // namespace surefoot
