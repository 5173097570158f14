// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/running/viewer.h"

#include <algorithm>

namespace surefoot {

namespace {
constexpr double kRest = 0.4;     // after an ending [s]
constexpr double kMostLag = 0.1;  // a window that was hidden does not catch up [s]
}  // namespace

Viewer::Viewer(std::unique_ptr<Environment> environment, std::unique_ptr<Policy> policy, std::uint64_t seed)
    : environment_(std::move(environment)),
      policy_(std::move(policy)),
      random_(seed) {
  now_.action = 0;
  pi_.resize(environment_->task().actions.size());
  if (environment_->answersAtOnce()) environment_->reset(random_);
}

void Viewer::choose(const ActionValueFunction& values) {
  now_.look(*environment_, values);
  policy_->probabilities(now_.view(), pi_);
  now_.action = sample(pi_, random_);
  if (feed_) feed_->before(now_, pi_);
}

void Viewer::advance(double seconds, const ActionValueFunction& values) {
  const double step = environment_->task().stepTime.value_or(0.05);
  time_ = std::min(time_ + seconds, kMostLag);
  for (; time_ >= step; time_ -= step) {
    if (rest_ > 0.0) {
      rest_ -= step;
      continue;
    }
    if (ended_) {
      environment_->reset(random_);
      choose(values);
      ended_ = false;
    }
    if (hand_.holds()) environment_->push(hand_.impulse(*environment_, step));
    const Outcome outcome = environment_->step(now_.action);
    if (feed_) feed_->after(outcome);
    falls_ += outcome.event == Event::Fall;
    ended_ = outcome.ending != Ending::None;
    if (ended_)
      rest_ = kRest;
    else
      choose(values);
  }
}

}  // namespace surefoot
