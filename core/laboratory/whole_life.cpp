// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/whole_life.h"

#include <thread>

namespace surefoot {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::int64_t kStretch = 1 << 16;           // [steps] between two looks at the clock
constexpr auto kPatience = std::chrono::seconds(2);  // a shorter pause writes nothing to the disk
constexpr auto kLook = std::chrono::milliseconds(20);
constexpr int kShareOfKeeping = 50;  // keeping takes at most this part of the time: 1/kShareOfKeeping

class Keeper {
 public:
  Keeper(const Life& life, std::chrono::duration<double> every, const std::function<void()>& keep)
      : life_(life),
        wanted_(std::chrono::duration_cast<Clock::duration>(every)),
        every_(wanted_),
        keep_(keep),
        keptAt_(life.steps()) {}

  void keepNow() {
    if (life_.steps() == keptAt_) return;
    const auto before = Clock::now();
    keep_();
    last_ = Clock::now();
    keptAt_ = life_.steps();
    every_ = std::max<Clock::duration>(wanted_, kShareOfKeeping * (last_ - before));
  }
  void keepIfDue() {
    if (Clock::now() - last_ >= every_) keepNow();
  }

 private:
  const Life& life_;
  Clock::duration wanted_, every_;
  const std::function<void()>& keep_;
  Clock::time_point last_ = Clock::now();
  std::int64_t keptAt_;  // step at which it was continued, or last kept
};

}  // namespace

void liveWhole(Life& life, Meter& meter, const WorkPool& pool, std::chrono::duration<double> every,
               const std::function<void()>& keep) {
  Keeper keeper(life, every, keep);
  meter.update(life);
  while (!life.finished()) {
    live(life, life.steps() + kStretch, pool, meter);
    if (!life.unanswered().empty()) return keeper.keepNow();
    if (life.finished()) return;
    if (pool.stopping()) return keeper.keepNow();
    keeper.keepIfDue();
    const auto since = Clock::now();
    while (pool.paused() && !pool.stopping()) {
      if (Clock::now() - since > kPatience) keeper.keepNow();
      std::this_thread::sleep_for(kLook);
    }
  }
}

std::unique_ptr<Life> takeUp(const Registry& registry, std::shared_ptr<const TensorFile> file, bool keepRows) {
  if (!file) return nullptr;
  auto resumed = resume(registry, std::move(file), {});
  if (!resumed || resumed->keepRows != keepRows) return nullptr;
  return std::move(resumed->life);
}

}  // namespace surefoot
