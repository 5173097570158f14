// SPDX-License-Identifier: GPL-3.0-or-later
// A Q-function that lives of a plan wait for while it is learned.
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>

#include "core/experiment/work_pool.h"
#include "core/files/tensor_file.h"
#include "core/store/store.h"

namespace surefoot {

/// Calls may come from any thread.
class SharedQFunction {
 public:
  SharedQFunction(const PreLearning& preLearning, int qFunction) : what(preLearning), number(qFunction) {}

  const PreLearning& what;
  const int number;

  /// One more life needs it.
  void wanted() { ++uses_; }
  /// Whether the caller must learn it; true only for the first caller.
  bool take() { return !taken_.exchange(true); }
  void finish(std::shared_ptr<const TensorFile> q, const StoredPreLearning& facts);
  /// nullptr: the pool stopped before it was learned.
  std::shared_ptr<const TensorFile> wait(const WorkPool& pool);
  /// Valid once it is learned.
  const StoredPreLearning& facts() const { return facts_; }
  /// A life that needed it is stored; returns true for the last such life.
  bool used();
  /// The Q-function, while it is learned and still needed; else nullptr.
  std::shared_ptr<const TensorFile> inHand() const;

 private:
  std::atomic<int> uses_{0};
  std::atomic<bool> taken_{false};
  mutable std::mutex mutex_;
  std::condition_variable done_;
  std::shared_ptr<const TensorFile> q_;
  StoredPreLearning facts_;
};

}  // namespace surefoot
