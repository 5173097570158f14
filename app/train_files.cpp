// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/train_files.h"

#include "app/report.h"
#include "core/experiment/journal.h"
#include "core/experiment/q_file.h"

namespace surefoot {

Result<TrainFiles> TrainFiles::claim(const TrainRequest& request) {
  TrainFiles files(request);
  for (const auto& [name, path, file] :
       {std::tuple{"--log", &request.log, &files.log_}, std::tuple{"--save", &request.save, &files.save_},
        std::tuple{"--journal", &request.journal, &files.journal_}}) {
    if (!*path) continue;
    auto place = WholeFile::createNew(name, **path);
    if (!place) return place.error();
    file->emplace(std::move(*place));
  }
  if (request.checkpoint)
    if (const auto place = WholeFile::createOrReplace("--checkpoint", *request.checkpoint); !place)
      return place.error();
  return files;
}

std::int64_t TrainFiles::visitEvery() const {
  return request_->checkpoint ? request_->checkpointEvery : std::numeric_limits<std::int64_t>::max();
}

void TrainFiles::visit(const Life& life) {
  if (life.diverged()) return;  // nothing that anyone would want to go on from
  if (save_) learned_ = qFileOf(life, request_->configuration).write();
  if (!request_->checkpoint) return;
  const bool rows = keepRows();
  auto file = WholeFile::createOrReplace("--checkpoint", *request_->checkpoint);
  const Status written =
      file ? file->commit(checkpointOf(life, request_->configuration, rows).write()) : Status(file.error());
  if (!written) trouble_ = written;  // the old checkpoint is still there, and the life goes on
}

Status TrainFiles::finish(const std::vector<LifeResult>& lives, std::optional<double> stepTime) {
  Status status = trouble_;
  const auto commit = [&](std::optional<WholeFile>& file, const std::string& content) {
    if (!file) return;
    const Status written = file->commit(content);
    if (status && !written) status = written;
  };
  if (log_) commit(log_, logAsCsv(lives, stepTime));
  if (lives.empty()) return status;
  if (!learned_.empty()) commit(save_, learned_);
  if (journal_) commit(journal_, journalOf(request_->configuration, lives.front()));
  return status;
}

}  // namespace surefoot
