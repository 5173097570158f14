// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/running/signal_feed.h"

#include <algorithm>

namespace surefoot {

void SignalFeed::begin(const Environment& environment, bool hasRisk, double discount) {
  first_ = last() + 1;
  table_ = SignalTable(environment, hasRisk);
  stepTime_ = environment.task().stepTime.value_or(1.0);
  discount_ = discount;
  hasRisk_ = hasRisk;
  on_ = true;
  steps_ = -1;
  lived_ = 0;
  episode_ = 1;
  tentative_ = false;
  pi_.resize(environment.task().actions.size());
}

void SignalFeed::end() {
  on_ = false;
  first_ = last() + 1;
  table_ = {};
}

void SignalFeed::before(const MomentSeen& now, std::span<const double> pi) {
  add(now, lived_++, episode_, pi);
  trim();
}

void SignalFeed::after(const Outcome& outcome) {
  if (table_.rows() == 0) return;
  table_.after(outcome);
  if (outcome.ending == Ending::Terminal) table_.learn(discount_);
  episode_ += outcome.ending != Ending::None;
}

void SignalFeed::see(const Snapshot& now, const Policy& policy) {
  if (now.steps == steps_) return;
  if (tentative_) table_.dropLast();
  for (const StepSeen& step : now.seen) {
    if (step.steps < steps_) continue;  // it is written down already
    add(step, step.steps, step.episode, piOf(step, policy));
    after(step.outcome);
  }
  steps_ = now.steps;
  tentative_ = true;
  add(now, now.steps, now.totals.episodes + (now.action == kNoAction ? 0 : 1), piOf(now, policy));
  trim();
}

std::span<const double> SignalFeed::piOf(const MomentSeen& moment, const Policy& policy) {
  if (moment.action >= 0) policy.probabilities(moment.view(), pi_);
  return pi_;
}

void SignalFeed::add(const MomentSeen& m, std::int64_t steps, std::int64_t episode, std::span<const double> pi) {
  const bool acts = m.action >= 0;
  const auto a = static_cast<std::size_t>(std::max(0, m.action));
  table_.before({.time = static_cast<double>(steps) * stepTime_,
                 .episode = episode,
                 .state = m.state,
                 .own = m.signals,
                 .measures = m.measures,
                 .q = m.q,
                 .risk = m.risk,
                 .action = m.action,
                 .probability = pi[a],
                 .explores = acts && m.q[a] < *std::max_element(m.q.begin(), m.q.end())});
  if (acts) table_.learn(discount_);
}

void SignalFeed::trim() {
  const auto most = static_cast<std::size_t>(kKept / (stepTime_ < 1.0 ? stepTime_ : 0.05));
  if (table_.rows() < most + most / 4) return;
  const std::size_t old = table_.rows() - most;
  table_.dropFirst(old);
  first_ += static_cast<std::int64_t>(old);
}

}  // namespace surefoot
