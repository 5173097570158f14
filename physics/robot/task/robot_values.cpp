// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/task/robot_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace surefoot {

namespace {

std::size_t placeOf(const RobotSpec& spec, NameKind kind) {
  return static_cast<std::size_t>(spec.names.placeOf(kind, 0));
}

/// Constants that use a parameter of the rewards, or another such constant.
std::vector<std::size_t> liveConstants(const RobotSpec& spec) {
  std::vector<std::size_t> live;
  std::vector<int> moving;
  for (std::size_t p = 0; p < spec.parameters.size(); ++p)
    if (spec.parameters[p].when == When::Now) moving.push_back(static_cast<int>(p));
  for (std::size_t c = 0; c < spec.constants.size(); ++c) {
    const auto uses = spec.constants[c].value.expression.variables();
    const auto one = [&](int place) { return std::find(moving.begin(), moving.end(), place) != moving.end(); };
    if (std::none_of(uses.begin(), uses.end(), one)) continue;
    live.push_back(c);
    moving.push_back(spec.names.placeOf(NameKind::Constant, static_cast<int>(c)));
  }
  return live;
}

}  // namespace

RobotValues::RobotValues(std::shared_ptr<const RobotSpec> spec)
    : spec_(std::move(spec)),
      row_(static_cast<std::size_t>(spec_->names.places()), 0.0),
      constantsAt_(placeOf(*spec_, NameKind::Constant)),
      memoriesAt_(placeOf(*spec_, NameKind::Memory)),
      statesAt_(placeOf(*spec_, NameKind::State)),
      stepAt_(static_cast<std::size_t>(spec_->names.placeOfStep())),
      whole_(spec_->parameters.size(), 0),
      live_(liveConstants(*spec_)) {
  std::copy(spec_->defaults.begin(), spec_->defaults.end(), row_.begin());
  for (std::size_t p = 0; p < whole_.size(); ++p) whole_[p] = static_cast<int>(spec_->defaults[p]);
  for (const MemorySpec& memory : spec_->memories) inSubsteps_ |= memory.substep;
  for (std::size_t a = 0; a < spec_->actuators.size(); ++a)
    if (!spec_->actuators[a].levels.empty()) driven_.push_back(a);
}

void RobotValues::declare(Fields& f) {
  for (std::size_t p = 0; p < spec_->parameters.size(); ++p) {
    if (spec_->parameters[p].kind == Kind::Integer)
      f.integer(whole_[p], spec_->parameters[p]);
    else
      f.real(row_[p], spec_->parameters[p]);
  }
}

void RobotValues::takeParametersOf(const RobotValues& other) {
  std::copy_n(other.row_.begin(), whole_.size(), row_.begin());
  whole_ = other.whole_;
}

void RobotValues::computeConstants() {
  for (std::size_t p = 0; p < whole_.size(); ++p)
    if (spec_->parameters[p].kind == Kind::Integer) row_[p] = whole_[p];
  for (std::size_t c = 0; c < spec_->constants.size(); ++c) row_[constantsAt_ + c] = spec_->constants[c].value(row_);
}

void RobotValues::renewTask() {
  task_ = robotTask(*spec_, row_);
  maxSteps_ = static_cast<int>(std::clamp(spec_->maxSteps(row_), 1.0, 1e9));
  state_.assign(spec_->states.size(), 0.0);
  measures_.assign(spec_->measures.size(), 0.0);
  potentials_.assign(spec_->rewards.size(), 0.0);
  u_.assign(spec_->actuators.size(), 0.0);
}

void RobotValues::startEpisode() {
  steps_ = 0;
  std::fill(u_.begin(), u_.end(), 0.0);
  row_[stepAt_] = 0.0;
  setTime(0.0);
  for (std::size_t m = 0; m < spec_->memories.size(); ++m) row_[memoriesAt_ + m] = spec_->memories[m].start(row_);
}

bool RobotValues::settle() {
  notFinite_.clear();
  for (std::size_t m = 0; m < spec_->memories.size(); ++m)
    if (!spec_->memories[m].substep && !spec_->memories[m].hasStart)
      row_[memoriesAt_ + m] = spec_->memories[m].each(row_);
  const bool seen = observe();
  for (std::size_t r = 0; r < potentials_.size(); ++r)
    if (spec_->rewards[r].potential) potentials_[r] = spec_->rewards[r].value(row_);
  return measure(true) && seen;
}

void RobotValues::decide(Action action) {
  for (const std::size_t c : live_) row_[constantsAt_ + c] = spec_->constants[c].value(row_);
  if (action == kHandMade) {
    for (const std::size_t a : driven_) u_[a] = handMade(a);
    return;
  }
  auto rest = static_cast<std::size_t>(action);
  for (auto a = driven_.rbegin(); a != driven_.rend(); ++a) {
    const auto& levels = spec_->actuators[*a].levels;
    u_[*a] = levels[rest % levels.size()](row_);
    rest /= levels.size();
  }
}

double RobotValues::handMade(std::size_t actuator) const {
  const ActuatorSpec& spec = spec_->actuators[actuator];
  if (!spec.handMade) return u_[actuator];
  double low = kInfinity, high = -kInfinity;  // no controller commands more than a level can
  for (const Formula& level : spec.levels) low = std::min(low, level(row_)), high = std::max(high, level(row_));
  return std::clamp((*spec.handMade)(row_), low, high);
}

Action RobotValues::handMadeAction() const {
  std::size_t action = 0;
  for (const std::size_t a : driven_) {
    const auto& levels = spec_->actuators[a].levels;
    const double wanted = handMade(a);
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < levels.size(); ++i)
      if (std::abs(levels[i](row_) - wanted) < std::abs(levels[nearest](row_) - wanted)) nearest = i;
    action = action * levels.size() + nearest;
  }
  return static_cast<Action>(action);
}

void RobotValues::remember(bool substep) {
  for (std::size_t m = 0; m < spec_->memories.size(); ++m)
    if (spec_->memories[m].substep == substep) row_[memoriesAt_ + m] = spec_->memories[m].each(row_);
}

void RobotValues::tick() {
  ++steps_;
  row_[stepAt_] = steps_;
  setTime(steps_ * *task_.stepTime);
}

bool RobotValues::observe() {
  double none = 0.0;  // until a number is none
  for (std::size_t s = 0; s < state_.size(); ++s) {
    const double value = row_[statesAt_ + s] = spec_->states[s].value(row_);
    none += value - value;
    if (none != 0.0) return notFinite_ = "the state " + spec_->states[s].words.key, false;
  }
  std::copy_n(row_.begin() + static_cast<std::ptrdiff_t>(statesAt_), state_.size(), state_.begin());
  return true;
}

bool RobotValues::measure(bool first) {
  for (std::size_t m = 0; m < measures_.size(); ++m) {
    const MeasureSpec& spec = spec_->measures[m];
    const double value = first && spec.adds ? 0.0 : spec.value(row_);
    if (!std::isfinite(value)) return notFinite_ = "the measure " + spec.words.key, false;
    measures_[m] = first || !spec.adds ? value : measures_[m] + value;
  }
  return true;
}

bool RobotValues::judge(Outcome& outcome) {
  using Ends = EndingSpec::Kind;
  remember(false);
  if (!observe() || !measure(false)) return false;
  const auto eventOf = [](Ends kind) {
    return kind == Ends::Fall ? Event::Fall : kind == Ends::Goal ? Event::Success : Event::None;
  };
  for (const EndingSpec& event : spec_->events)
    if (outcome.event == Event::None && event.when.expression.holds(row_)) outcome.event = eventOf(event.kind);
  lastEnding_ = -1;
  for (std::size_t e = 0; e < spec_->endings.size() && lastEnding_ < 0; ++e)
    if (spec_->endings[e].when.expression.holds(row_)) lastEnding_ = static_cast<int>(e);
  if (lastEnding_ >= 0) {
    const Ends kind = spec_->endings[static_cast<std::size_t>(lastEnding_)].kind;
    outcome.ending = kind == Ends::Time ? Ending::Truncated : Ending::Terminal;
    if (outcome.event == Event::None) outcome.event = eventOf(kind);
  } else if (steps_ >= maxSteps_) {
    outcome.ending = Ending::Truncated;
  }
  return reward(outcome);
}

bool RobotValues::reward(Outcome& outcome) {
  for (std::size_t r = 0; r < spec_->rewards.size(); ++r) {
    const RewardSpec& reward = spec_->rewards[r];
    const bool here =
        (!reward.ending || *reward.ending == lastEnding_) && (!reward.when || reward.when->expression.holds(row_));
    if (!here && !reward.potential) continue;
    const double value = valueOf(r);
    if (here) outcome.terms[r] = value;
    outcome.reward += outcome.terms[r];
    if (!std::isfinite(value)) return notFinite_ = "the reward " + spec_->rewards[r].name, false;
  }
  return true;
}

double RobotValues::valueOf(std::size_t reward) {
  const RewardSpec& spec = spec_->rewards[reward];
  const double value = spec.value(row_);
  return spec.potential ? value - std::exchange(potentials_[reward], value) : value;
}

}  // namespace surefoot
