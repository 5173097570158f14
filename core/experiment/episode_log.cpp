// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/episode_log.h"

#include <algorithm>
#include <bit>

#include "core/random.h"

namespace surefoot {

void Hash64::add(std::uint64_t word) {
  state_ = mix64((state_ ^ word) + 0x9e3779b97f4a7c15ULL);
}
void Hash64::add(double value) {
  add(std::bit_cast<std::uint64_t>(value));
}

const EpisodeRow& EpisodeLog::finish(Ending ending, std::int64_t lifeSteps) {
  recent_[static_cast<std::size_t>(totals_.episodes % kAverageOver)] = current_.reward;
  ++totals_.episodes;
  totals_.falls += current_.falls;
  const bool failure = !current_.success && current_.falls > 0;
  totals_.successes += current_.success;
  totals_.failures += failure;
  if (current_.success) totals_.successSteps += current_.steps;
  if (failure) totals_.failureSteps += current_.steps;

  const auto count = std::min<std::int64_t>(totals_.episodes, kAverageOver);
  double sum = 0.0;
  for (std::int64_t i = 0; i < count; ++i) sum += recent_[static_cast<std::size_t>(i)];

  last_ = current_;
  last_.episode = totals_.episodes;
  last_.lifeSteps = lifeSteps;
  last_.ending = ending;
  last_.averageReward = sum / static_cast<double>(count);
  current_ = {};

  for (const auto word : {last_.episode, last_.steps, last_.lifeSteps, static_cast<std::int64_t>(last_.falls),
                          static_cast<std::int64_t>(last_.success), static_cast<std::int64_t>(last_.ending)})
    hash_.add(static_cast<std::uint64_t>(word));
  hash_.add(last_.reward);
  if (keepRows_) rows_.push_back(last_);
  return last_;
}

}  // namespace surefoot
