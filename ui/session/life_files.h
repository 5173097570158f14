// SPDX-License-Identifier: GPL-3.0-or-later
// Writes lives to files, and begins them from files.
#pragma once

#include <QObject>
#include <optional>
#include <string>

#include "ui/session/new_lives.h"
#include "ui/support/call_queue.h"

namespace surefoot {

/// The life of a checkpoint, to go on with; one that another version lived has a remark. Any thread.
Result<NewLives::Made> lifeOf(const Registry& registry, const std::shared_ptr<const TensorFile>& checkpoint);

class LifeFiles final : public QObject {
  Q_OBJECT

 public:
  LifeFiles(RunningLife& life, NewLives& newLives) : life_(life), newLives_(newLives) {}

  using Then = NewLives::Then;
  /// Writes the life that runs; `then` is called when it is written, or could not be.
  void save(SavedAs what, const std::string& path, Then then);
  /// Writes a life that is kept for undo.
  void saveKept(const KeptLife& kept, const std::string& path, Then then);
  using Function = Result<std::shared_ptr<const TensorFile>>;
  /// A copy of what the life that runs has learned, as its file would hold it.
  void copyFunction(std::function<void(const Function&)> then);
  /// The life's progress when save() wrote it last; nothing if that was another life.
  const std::optional<LifeProgress>& written() const { return written_; }
  /// The progress of the life that save() wrote last, whichever it was.
  const LifeProgress& lastWritten() const { return lastWritten_; }

  /// A saved session goes on, a new life begins with a Q-function, a journal is lived again; `then` is called when the
  /// life has begun, or could not.
  void open(const std::string& path, const Then& then);

 private:
  NewLives::Make makeOfFile(const std::string& path) const;
  NewLives::Make makeOfJournal(const std::string& path) const;

  RunningLife& life_;
  NewLives& newLives_;
  std::optional<LifeProgress> written_;
  LifeProgress lastWritten_;
  CallQueue calls_;  // of the learner's thread
};

}  // namespace surefoot
