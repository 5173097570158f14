// SPDX-License-Identifier: GPL-3.0-or-later
// The files that a run leaves: their places are claimed before it, they are written whole when it is over, and the
// checkpoint again and again meanwhile.
#pragma once

#include <optional>

#include "app/command_line.h"
#include "core/experiment/experiment.h"
#include "core/files/whole_file.h"

namespace surefoot {

class TrainFiles {
 public:
  static Result<TrainFiles> claim(const TrainRequest& request);

  bool keepRows() const { return log_.has_value() || (request_->resumed && request_->log); }
  /// Whether visit() wants to be called, and after how many steps.
  bool wantsVisits() const { return save_ || request_->checkpoint; }
  std::int64_t visitEvery() const;
  /// Saves what is learned so far. On the life's thread.
  void visit(const Life& life);
  /// Writes what is left to write. What is not in its place in the end, one sentence a file: it says where the file is
  /// instead, or that it is lost.
  std::vector<Error> finish(const std::vector<LifeResult>& lives, std::optional<double> stepTime);

 private:
  explicit TrainFiles(const TrainRequest& request) : request_(&request) {}

  const TrainRequest* request_;
  std::optional<WholeFile> log_, save_, journal_;
  std::string learned_;     // the bytes of the Q-function
  std::string checkpoint_;  // the bytes of the newest checkpoint, if it could not be written
};

}  // namespace surefoot
