// SPDX-License-Identifier: GPL-3.0-or-later
// A number of pieces of work on a few threads, and a stop that all of them see.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "core/result.h"

namespace surefoot {

class WorkPool {
 public:
  /// `interrupted` may be set by anyone at any time, or be null.
  WorkPool(int jobs, const std::atomic<bool>* interrupted) : jobs_(jobs), interrupted_(interrupted) {}
  WorkPool(const WorkPool&) = delete;

  /// Calls work(0) … work(count − 1) on the threads, begun in this order; meanwhile tick(), if there is one, about four
  /// times a second on the calling thread. No more is begun once stopping(). Returns the first error; an interruption
  /// is none. Call once.
  Status run(std::int64_t count, const std::function<Status(std::int64_t)>& work, const std::function<void()>& tick);

  /// Interrupted, or a piece of work failed: long ones should end early. Any thread.
  bool stopping() const {
    return failed_.load(std::memory_order_relaxed) || (interrupted_ && interrupted_->load(std::memory_order_relaxed));
  }

 private:
  int jobs_;
  const std::atomic<bool>* interrupted_;
  std::atomic<bool> failed_{false};
};

}  // namespace surefoot
