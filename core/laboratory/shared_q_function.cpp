// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/shared_q_function.h"

namespace surefoot {

void SharedQFunction::finish(std::shared_ptr<const TensorFile> q, const StoredPreLearning& facts) {
  const std::lock_guard lock(mutex_);
  q_ = std::move(q);
  facts_ = facts;
  done_.notify_all();
}

std::shared_ptr<const TensorFile> SharedQFunction::wait(const WorkPool& pool) {
  std::unique_lock lock(mutex_);
  while (!q_ && !pool.stopping()) done_.wait_for(lock, std::chrono::milliseconds(50));
  return q_;
}

bool SharedQFunction::used() {
  if (--uses_ > 0) return false;
  const std::lock_guard lock(mutex_);
  q_.reset();  // a few megabytes, of LEO a hundred
  return true;
}

std::shared_ptr<const TensorFile> SharedQFunction::inHand() const {
  const std::lock_guard lock(mutex_);
  return q_;
}

}  // namespace surefoot
