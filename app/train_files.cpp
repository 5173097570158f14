// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/train_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <limits>

#include "app/report.h"
#include "core/experiment/journal.h"
#include "core/experiment/q_file.h"

namespace surefoot {

namespace {

/// The rows of a log are in memory until it is written: what cannot fit is refused before a night is spent on it.
Status checkMemory(const TrainRequest& request) {
  const Configuration& c = request.configuration;
  if (!request.log || !c.episodes) return Done{};
  const double wanted = static_cast<double>(*c.episodes) * c.lives * sizeof(EpisodeRow);
  const double there = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (there <= 0 || wanted <= there) return Done{};
  constexpr double kGigabyte = 1e9;
  return Error{fmt::format("--log: {} episodes of {} {} need {:.3g} GB of memory, and the machine has {:.3g}; log fewer.",
                           *c.episodes, c.lives, c.lives == 1 ? "life" : "lives", wanted / kGigabyte,
                           there / kGigabyte)};
}

}  // namespace

Result<TrainFiles> TrainFiles::claim(const TrainRequest& request) {
  if (const Status s = checkMemory(request); !s) return s.error();
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
  std::string bytes = checkpointOf(life, request_->configuration, keepRows()).write();
  const bool written = static_cast<bool>(writeWhole("--checkpoint", *request_->checkpoint, bytes));
  checkpoint_ = written ? "" : std::move(bytes);  // an older one is still there, and the life goes on
}

namespace {

/// The place was free when the run began and is not any more, or its folder is gone: what was lived must not be lost
/// for that. Beside it, or in the current folder; the error says where.
Error rescue(const std::string& path, const std::string& content, const Error& why) {
  const std::filesystem::path wanted = path;
  const std::string name = fmt::format("{}-{}", wanted.filename().string(), getpid());
  for (const auto& place : {wanted.parent_path() / name, std::filesystem::path(name)}) {
    auto file = WholeFile::createNew("file", place.string());
    if (file && file->commit(content))
      return {fmt::format("{} It is in {} instead.", why.message, place.string()), why.kind};
  }
  return {why.message + " It is lost.", why.kind};
}

}  // namespace

std::vector<Error> TrainFiles::finish(const std::vector<LifeResult>& lives, std::optional<double> stepTime) {
  std::vector<Error> missing;
  const auto commit = [&](WholeFile& file, const std::string& path, const std::string& content) {
    if (const Status written = file.commit(content); !written)
      missing.push_back(rescue(path, content, written.error()));
  };
  if (log_) commit(*log_, *request_->log, logAsCsv(lives, stepTime));
  if (save_ && !learned_.empty()) commit(*save_, *request_->save, learned_);
  if (journal_ && !lives.empty())
    commit(*journal_, *request_->journal, journalOf(request_->configuration, lives.front()));
  if (!checkpoint_.empty())
    if (const Status written = writeWhole("--checkpoint", *request_->checkpoint, checkpoint_); !written)
      missing.push_back(rescue(*request_->checkpoint, checkpoint_, written.error()));
  return missing;
}

}  // namespace surefoot
