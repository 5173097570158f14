// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/work_pool.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

namespace surefoot {

// We poll the flags instead of waiting for a notification: a signal handler sets one, and cannot notify a thread.
void WorkPool::waitWhilePaused() const {
  while (paused() && !stopping()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

Status WorkPool::run(std::int64_t count, const std::function<Status(std::int64_t)>& work,
                     const std::function<void()>& tick) {
  std::atomic<std::int64_t> next{0};
  std::atomic<bool> outOfMemory{false};
  std::mutex mutex;  // guards working and error
  std::condition_variable done;
  int working = 0;
  std::optional<Error> error;

  const auto toil = [&] {
    try {
      for (std::int64_t i = next++; i < count && !stopping(); i = next++) {
        waitWhilePaused();
        if (stopping()) break;
        const Status status = work(i);
        if (status) continue;
        const std::lock_guard lock(mutex);
        if (!error) error = status.error();
        failed_ = true;
      }
    } catch (const std::bad_alloc&) {
      outOfMemory = true;  // and nothing more here: even an error message would need some
      failed_ = true;
    } catch (const std::exception& e) {
      const std::lock_guard lock(mutex);
      if (!error) error = Error{std::string("Something went wrong that should not: ") + e.what() + "."};
      failed_ = true;
    }
    const std::lock_guard lock(mutex);
    --working;
    done.notify_one();
  };

  {
    std::vector<std::jthread> threads;
    const auto jobs = static_cast<int>(std::min<std::int64_t>(jobs_, count));
    working = jobs;
    try {
      for (int i = 0; i < jobs; ++i) threads.emplace_back(toil);
    } catch (const std::system_error&) {  // the work is done with fewer threads
      if (threads.empty()) return Error{"The system gives no thread to run on; are too many running already?"};
      const std::lock_guard lock(mutex);
      working -= jobs - static_cast<int>(threads.size());
    }
    std::unique_lock lock(mutex);
    while (!done.wait_for(lock, std::chrono::milliseconds(250), [&] { return working == 0; })) {
      if (!tick) continue;
      lock.unlock();
      tick();
      lock.lock();
    }
  }
  if (outOfMemory)
    return Error{"There is not enough memory for this; take fewer tiles, tilings or jobs, shorter lives, or no log."};
  if (error) return *error;
  if (tick) tick();
  return Done{};
}

}  // namespace surefoot
