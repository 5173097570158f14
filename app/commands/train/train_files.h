// SPDX-License-Identifier: GPL-3.0-or-later
// The files that a run leaves: their places are claimed before it, they are written whole when it is over, and the
// checkpoint again and again meanwhile.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/commands/train/episode_spool.h"
#include "app/requests/command_line.h"
#include "core/experiment/experiment.h"
#include "core/files/whole_file.h"

namespace surefoot {

class TrainFiles {
 public:
  /// The request and the task outlive this.
  static Result<TrainFiles> claim(const TrainRequest& request, const Task& task);
  using Write = std::function<Status(WholeFile&)>;

  bool keepRows() const { return log_.has_value() || (request_->resumed && request_->log); }
  /// Whether visit() wants to be called, and after how many steps.
  bool wantsVisits() const { return save_ || request_->checkpoint; }
  std::int64_t visitEvery() const;
  /// Saves the learned values so far. On the life's thread.
  void visit(const Life& life);
  /// Whether takeRows() wants the rows while lives go on.
  bool wantsRows() const { return spool_ != nullptr; }
  void takeRows(int life, const std::vector<EpisodeRow>& rows);
  /// Writes the remaining files. Returns one error for each file that is not in its place: it says where the file is
  /// instead, or that it is lost.
  std::vector<Error> finish(const std::vector<LifeResult>& lives);

 private:
  TrainFiles(const TrainRequest& request, const Task& task) : request_(&request), task_(&task) {}
  Status writeLog(WholeFile& file, const std::vector<LifeResult>& lives) const;

  const TrainRequest* request_;
  const Task* task_;
  std::optional<WholeFile> log_, save_, journal_;
  std::unique_ptr<EpisodeSpool> spool_;  // the rows of the log so far
  std::string learned_;                  // the bytes of the Q-function
  std::string checkpoint_;               // the bytes of the newest checkpoint, if it could not be written
};

}  // namespace surefoot
