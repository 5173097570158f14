// SPDX-License-Identifier: GPL-3.0-or-later
// Lives that were stopped in the middle, as checkpoints in a folder beside their store: "results.sqlite.lives". Whoever
// goes on with the store takes them up bit for bit. A file's name says which life it is (a hash of all that makes it),
// so that one that belongs to another plan is never taken up. The folder goes with its last file.
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

  /// Life number `life` of a condition; a Q-function that is learned before.
  static std::string nameOf(const Condition& condition, int life);
  static std::string nameOf(const PreLearning& preLearning, int qFunction);

  bool has(const std::string& name) const;
  Status keep(const std::string& name, TensorFile file);
  /// What was kept, if it is whole; nullptr: it is not, and is removed.
  std::shared_ptr<const TensorFile> read(const std::string& name);
  void drop(const std::string& name);
  /// Removes all that nobody will take up, and the folder if it is empty.
  void keepOnly(const std::set<std::string>& names);
  /// How many lie there.
  static int count(const std::string& storePath);

 private:
  std::string fileOf(const std::string& name) const;
  const std::string folder_;
  std::mutex mutex_;
};

/// What a Q-function's learning came to, in the description of a file, and back.
Json asJson(const StoredPreLearning& facts);
std::optional<StoredPreLearning> preLearningFrom(const Json& json);

}  // namespace surefoot
