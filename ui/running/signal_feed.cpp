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

void SignalFeed::before(const Environment& environment, const ValuesOfState& here, Action action,
                        std::span<const double> pi) {
  const auto a = static_cast<std::size_t>(action);
  table_.before(environment, {.time = static_cast<double>(lived_++) * stepTime_,
                              .episode = episode_,
                              .q = here.q,
                              .risk = here.risk,
                              .action = action,
                              .probability = pi[a],
                              .explores = here.q[a] < *std::max_element(here.q.begin(), here.q.end())});
  table_.learn(discount_);
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
    add(step, policy);
    table_.after(step.outcome);
    if (step.outcome.ending == Ending::Terminal) table_.learn(discount_);
  }
  steps_ = now.steps;
  tentative_ = true;
  add({.steps = now.steps,
       .episode = now.totals.episodes + (now.action == kNoAction ? 0 : 1),
       .state = now.state,
       .signals = now.signals,
       .measures = now.measures,
       .q = now.q,
       .risk = now.risk,
       .losses = now.qNegative,
       .action = now.action,
       .outcome = {}},
      policy);
  trim();
}

void SignalFeed::add(const StepSeen& step, const Policy& policy) {
  const bool acts = step.action >= 0;
  here_.q = step.q, here_.risk = step.risk, here_.losses = step.losses;
  if (acts) policy.probabilities(here_.view(), pi_);
  const auto a = static_cast<std::size_t>(std::max(0, step.action));
  table_.before({.time = static_cast<double>(step.steps) * stepTime_,
                 .episode = step.episode,
                 .state = step.state,
                 .own = step.signals,
                 .measures = step.measures,
                 .q = step.q,
                 .risk = step.risk,
                 .action = step.action,
                 .probability = pi_[a],
                 .explores = acts && step.q[a] < *std::max_element(step.q.begin(), step.q.end())});
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
