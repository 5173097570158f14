// SPDX-License-Identifier: GPL-3.0-or-later
// Lives that were stopped in the middle, as checkpoints in a folder beside their store: "results.sqlite.lives". The
// next run of the store continues them bit for bit. A file's name identifies the life (a hash of everything that
// determines it), so that a life of another plan is never continued. The folder is removed with its last file.
//
// Calls may come from any thread; files are written one at a time, because a life may be as large as half the memory.
#pragma once

#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "core/saved/checkpoint.h"
#include "core/store/store.h"

namespace surefoot {

class KeptLives {
 public:
  explicit KeptLives(const std::string& storePath);

  /// The name of life number `life` of a condition, or of a Q-function that is learned before.
  static std::string nameOf(const Condition& condition, int life);
  static std::string nameOf(const PreLearning& preLearning, int qFunction);

  bool has(const std::string& name) const;
  Status keep(const std::string& name, TensorFile file);
  /// The kept file; nullptr: it is damaged, and is removed.
  std::shared_ptr<const TensorFile> read(const std::string& name);
  void drop(const std::string& name);
  /// Removes all files with other names, and the folder if it is empty.
  void keepOnly(const std::set<std::string>& names);
  /// How many files are in the folder.
  static int count(const std::string& storePath);

 private:
  std::string fileOf(const std::string& name) const;
  const std::string folder_;
  std::mutex mutex_;
};

/// The results of a Q-function's learning, to and from the description of a file.
Json asJson(const StoredPreLearning& facts);
std::optional<StoredPreLearning> preLearningFrom(const Json& json);

}  // namespace surefoot
