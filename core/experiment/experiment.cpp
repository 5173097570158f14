// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/experiment.h"

#include <time.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>

namespace surefoot {

namespace {

double threadCpuSeconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// How far a life is, on a cache line of its own: its thread writes, the calling thread reads now and then.
struct alignas(64) Meter {
  std::atomic<std::int64_t> steps{0}, falls{0};
  std::atomic<double> share{0.0};
};

double shareOf(const Life& life) {
  const auto part = [](std::int64_t done, std::int64_t limit) {
    return static_cast<double>(done) / static_cast<double>(limit);
  };
  return std::min(1.0, std::max(part(life.steps(), life.limits().steps),
                                part(life.log().totals().episodes, life.limits().episodes)));
}

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

class Pool {
 public:
  Pool(const Registry& registry, const Configuration& configuration, const RunOptions& options)
      : registry_(registry),
        configuration_(configuration),
        options_(options),
        results_(static_cast<std::size_t>(configuration.lives)),
        meters_(results_.size()) {}

  Result<std::vector<LifeResult>> run() {
    {
      std::vector<std::jthread> threads;
      const int jobs = std::min(options_.jobs, configuration_.lives);
      working_ = jobs;
      try {
        for (int i = 0; i < jobs; ++i) threads.emplace_back([this] { work(); });
      } catch (const std::system_error&) {  // fewer threads do the same work
        if (threads.empty()) return Error{"The system gives no thread to run on; are too many running already?"};
        const std::lock_guard lock(mutex_);
        working_ -= jobs - static_cast<int>(threads.size());
      }
      std::unique_lock lock(mutex_);
      while (!done_.wait_for(lock, std::chrono::milliseconds(250), [this] { return working_ == 0; }))
        if (options_.progress) options_.progress(progress());
    }
    if (outOfMemory_)
      return Error{"There is not enough memory for this; take fewer tiles, tilings or jobs, shorter lives, or no log."};
    if (error_) return *error_;
    if (options_.progress) options_.progress(progress());
    std::vector<LifeResult> lives;
    for (auto& result : results_)
      if (result) lives.push_back(std::move(*result));
    return lives;
  }

 private:
  bool interrupted() const {
    return givenUp_.load(std::memory_order_relaxed) ||
           (options_.interrupted && options_.interrupted->load(std::memory_order_relaxed));
  }

  void work() {
    try {
      for (int index = next_++; index < configuration_.lives && !interrupted(); index = next_++) live(index);
    } catch (const std::bad_alloc&) {
      outOfMemory_ = true;  // and nothing more here: even an error message would need some
      givenUp_ = true;
    }
    const std::lock_guard lock(mutex_);
    --working_;
    done_.notify_one();
  }

  void live(int index) {
    const double start = threadCpuSeconds();
    Result<std::unique_ptr<Life>> made =
        options_.make ? options_.make(index) : makeLife(registry_, configuration_, index, options_.keepRows);
    if (!made) return giveUp(made.error());
    Life& life = **made;
    if (options_.visitEvery != kNever) life.keepInputs();
    std::int64_t nextVisit = after(life.steps());
    Meter& meter = meters_[static_cast<std::size_t>(index)];
    while (!life.finished() && !interrupted()) {
      const std::int64_t batch = std::min<std::int64_t>(4096, nextVisit - life.steps());
      for (std::int64_t i = 0; i < batch && !life.finished(); ++i) life.step();
      if (life.steps() >= nextVisit && !life.finished()) {
        if (options_.visit) options_.visit(life);
        nextVisit = after(life.steps());
      }
      meter.steps.store(life.steps(), std::memory_order_relaxed);
      meter.falls.store(life.log().totals().falls, std::memory_order_relaxed);
      meter.share.store(shareOf(life), std::memory_order_relaxed);
    }
    meter.share.store(1.0, std::memory_order_relaxed);
    if (options_.visit) options_.visit(life);
    results_[static_cast<std::size_t>(index)] = summarise(life, index, threadCpuSeconds() - start);
    ++livesDone_;
  }

  /// The step of the next visit.
  std::int64_t after(std::int64_t steps) const {
    return options_.visitEvery == kNever ? kNever : (steps / options_.visitEvery + 1) * options_.visitEvery;
  }

  void giveUp(Error error) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::move(error);
    givenUp_ = true;
  }

  Progress progress() const {
    Progress p;
    for (const Meter& meter : meters_) {
      p.steps += meter.steps.load(std::memory_order_relaxed);
      p.falls += meter.falls.load(std::memory_order_relaxed);
      p.share += meter.share.load(std::memory_order_relaxed) / static_cast<double>(meters_.size());
    }
    p.livesDone = livesDone_;
    return p;
  }

  const Registry& registry_;
  const Configuration& configuration_;
  const RunOptions& options_;
  std::vector<std::optional<LifeResult>> results_;
  std::vector<Meter> meters_;
  std::atomic<int> next_{0}, livesDone_{0};
  std::atomic<bool> givenUp_{false}, outOfMemory_{false};
  std::mutex mutex_;  // guards working_ and error_
  std::condition_variable done_;
  int working_ = 0;
  std::optional<Error> error_;
};

}  // namespace

LifeResult summarise(const Life& life, int index, double cpuSeconds) {
  LifeResult r;
  r.life = index;
  r.totals = life.log().totals();
  r.steps = life.steps();
  r.simulatedSeconds = life.simulatedSeconds();
  r.averageReward = life.log().averageReward();
  r.statesOutside = life.agent().statesOutside();
  r.cpuSeconds = cpuSeconds;
  r.hash = life.hash();
  if (life.diverged()) r.divergence = life.divergence();
  r.complete = life.finished() && !life.diverged();
  r.changes = life.changes();
  r.changesLeftOut = life.changesLeftOut();
  r.memory = life.agent().values().memoryUse();
  r.ruleOfThumb = ruleOfThumbOf(life);
  r.rows = life.log().rows();
  return r;
}

Result<std::vector<LifeResult>> runLives(const Registry& registry, const Configuration& configuration,
                                         const RunOptions& options) {
  return Pool(registry, configuration, options).run();
}

}  // namespace surefoot
