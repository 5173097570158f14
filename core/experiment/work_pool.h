// SPDX-License-Identifier: GPL-3.0-or-later
// A number of pieces of work on a few threads, and a stop that all of them see.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "core/basics/result.h"

namespace surefoot {

class WorkPool {
 public:
  /// `interrupted` and `paused` may be set by anyone at any time, or be null.
  WorkPool(int jobs, const std::atomic<bool>* interrupted, const std::atomic<bool>* paused = nullptr)
      : jobs_(jobs),
        interrupted_(interrupted),
        paused_(paused) {}
  WorkPool(const WorkPool&) = delete;

  /// Calls work(0) … work(count − 1) on the threads, begun in this order; meanwhile tick(), if there is one, about four
  /// times a second on the calling thread. No more is begun once stopping(). Returns the first error; an interruption
  /// is none. Call once.
  Status run(std::int64_t count, const std::function<Status(std::int64_t)>& work, const std::function<void()>& tick);

  /// Interrupted, or a piece of work failed: long ones should end early. Any thread.
  bool stopping() const {
    return failed_.load(std::memory_order_relaxed) || (interrupted_ && interrupted_->load(std::memory_order_relaxed));
  }

  /// Set when somebody wants all to end; null: nobody can.
  const std::atomic<bool>* interrupted() const { return interrupted_; }

  /// Running work stands still, and no more is begun. Any thread.
  bool paused() const { return paused_ && paused_->load(std::memory_order_relaxed); }
  /// Stands still for as long as it is paused, or until everything stops.
  void waitWhilePaused() const;

 private:
  int jobs_;
  const std::atomic<bool>* interrupted_;
  const std::atomic<bool>* paused_;
  std::atomic<bool> failed_{false};
};

}  // namespace surefoot
