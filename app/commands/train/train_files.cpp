// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/train/train_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <limits>

#include "app/reports/report.h"
#include "core/saved/journal.h"
#include "core/saved/q_file.h"

namespace surefoot {

namespace {

/// A checkpoint holds the whole log, so that a resumed life can write it; then it is in memory as well. A log that
/// cannot fit is refused before the run, which may take a night.
Status checkMemory(const TrainRequest& request) {
  const Configuration& c = request.configuration;
  if (!request.log || !request.checkpoint || !c.episodes) return Done{};
  const double wanted = static_cast<double>(*c.episodes) * sizeof(EpisodeRow);
  const double there = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (there <= 0 || wanted <= there) return Done{};
  constexpr double kGigabyte = 1e9;
  return Error{
      fmt::format("--checkpoint with --log: {} episodes need {:.3g} GB of memory, and the machine has {:.3g}; "
                  "leave one of them out.",
                  *c.episodes, wanted / kGigabyte, there / kGigabyte)};
}

}  // namespace

Result<TrainFiles> TrainFiles::claim(const TrainRequest& request, const Task& task) {
  if (const Status s = checkMemory(request); !s) return s.error();
  TrainFiles files(request, task);
  for (const auto& [name, path, file] :
       {std::tuple{"--log", &request.log, &files.log_}, std::tuple{"--save", &request.save, &files.save_},
        std::tuple{"--journal", &request.journal, &files.journal_}}) {
    if (!*path) continue;
    auto place = WholeFile::createNew(name, **path);
    if (!place) return place.error();
    file->emplace(std::move(*place));
  }
  if (files.log_ && !request.checkpoint) {
    const auto folder = std::filesystem::path(*request.log).parent_path().string();
    files.spool_ = std::make_unique<EpisodeSpool>(folder.empty() ? "." : folder);
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
  if (life.diverged()) return;  // nobody would want to continue from a diverged life
  if (save_) learned_ = qFileOf(life, request_->configuration).write();
  if (!request_->checkpoint) return;
  std::string bytes = checkpointOf(life, request_->configuration, keepRows()).write();
  const bool written = static_cast<bool>(writeWhole("--checkpoint", *request_->checkpoint, bytes));
  checkpoint_ = written ? "" : std::move(bytes);  // an older one is still there, and the life goes on
}

namespace {

/// The place was free when the run began, but now it is taken or its folder is gone. So that the results are not lost,
/// writes beside it or in the current folder; the error says where.
Error rescue(const std::string& path, const TrainFiles::Write& write, const Error& why) {
  const std::filesystem::path wanted = path;
  const std::string name = fmt::format("{}-{}", wanted.filename().string(), getpid());
  for (const auto& place : {wanted.parent_path() / name, std::filesystem::path(name)}) {
    auto file = WholeFile::createNew("file", place.string());
    if (file && write(*file)) return {fmt::format("{} It is in {} instead.", why.message, place.string()), why.kind};
  }
  return {why.message + " It is lost.", why.kind};
}

}  // namespace

void TrainFiles::takeRows(int life, const std::vector<EpisodeRow>& rows) {
  spool_->append(life, logRows(life, rows, task_->measures, task_->stepTime, request_->mayRewind));
}

Status TrainFiles::writeLog(WholeFile& file, const std::vector<LifeResult>& lives) const {
  if (!spool_) return file.commit(logAsCsv(lives, task_->stepTime));
  if (const Status s = file.append(logHeads(task_->measures, request_->mayRewind)); !s) return s;
  if (const Status s = spool_->read([&](std::string_view part) { return file.append(part); }); !s) return s;
  return file.commit();
}

std::vector<Error> TrainFiles::finish(const std::vector<LifeResult>& lives) {
  std::vector<Error> missing;
  const auto put = [&](WholeFile& file, const std::string& path, const Write& write) {
    if (const Status written = write(file); !written) missing.push_back(rescue(path, write, written.error()));
  };
  const auto commit = [&](WholeFile& file, const std::string& path, const std::string& content) {
    put(file, path, [&](WholeFile& f) { return f.commit(content); });
  };
  if (log_) put(*log_, *request_->log, [&](WholeFile& f) { return writeLog(f, lives); });
  if (save_ && !learned_.empty()) commit(*save_, *request_->save, learned_);
  if (journal_ && !lives.empty())
    commit(*journal_, *request_->journal, journalOf(request_->configuration, lives.front()));
  if (!checkpoint_.empty())
    if (const Status written = writeWhole("--checkpoint", *request_->checkpoint, checkpoint_); !written)
      missing.push_back(rescue(
          *request_->checkpoint, [&](WholeFile& f) { return f.commit(checkpoint_); }, written.error()));
  return missing;
}

}  // namespace surefoot
