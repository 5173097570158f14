// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/robot/reading/robot_reading.h"

namespace surefoot {

namespace {

/// Where a start has no numbers, or is beyond all bounds, Box2D is not asked.
bool isSomewhere(const BodyPlacement& body) {
  constexpr double kFarthest = 1e5;  // [m], [rad], [m/s], [rad/s]
  for (const double x : {body.at.x, body.at.y, body.angle, body.velocity.x, body.velocity.y, body.rate})
    if (!(std::abs(x) < kFarthest)) return false;
  return true;
}

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

Robot::Robot(std::shared_ptr<const RobotSpec> spec)
    : spec_(std::move(spec)),
      values_(static_cast<std::size_t>(spec_->names.places()), 0.0),
      constantsAt_(placeOf(*spec_, NameKind::Constant)),
      memoriesAt_(placeOf(*spec_, NameKind::Memory)),
      statesAt_(placeOf(*spec_, NameKind::State)),
      stepAt_(static_cast<std::size_t>(spec_->names.placeOfStep())),
      whole_(spec_->parameters.size(), 0),
      live_(liveConstants(*spec_)) {
  std::copy(spec_->defaults.begin(), spec_->defaults.end(), values_.begin());
  for (std::size_t p = 0; p < whole_.size(); ++p) whole_[p] = static_cast<int>(spec_->defaults[p]);
  for (const MemorySpec& memory : spec_->memories) inSubsteps_ |= memory.substep;
  for (std::size_t a = 0; a < spec_->actuators.size(); ++a)
    if (!spec_->actuators[a].levels.empty()) driven_.push_back(a);
  rebuild();
}

Robot::~Robot() = default;

void Robot::declare(Fields& f) {
  for (std::size_t p = 0; p < spec_->parameters.size(); ++p) {
    if (spec_->parameters[p].kind == Kind::Integer)
      f.integer(whole_[p], spec_->parameters[p]);
    else
      f.real(values_[p], spec_->parameters[p]);
  }
}

void Robot::computeConstants() {
  for (std::size_t p = 0; p < whole_.size(); ++p)
    if (spec_->parameters[p].kind == Kind::Integer) values_[p] = whole_[p];
  for (std::size_t c = 0; c < spec_->constants.size(); ++c)
    values_[constantsAt_ + c] = spec_->constants[c].value(values_);
}

void Robot::rebuild() {
  computeConstants();
  std::vector<Complaint> complaints;
  RobotNumbers numbers = numbersOf(*spec_, values_, complaints);
  if (!complaints.empty()) return;  // check() tells it; what was possible before stays
  numbers_ = std::move(numbers);
  task_ = robotTask(*spec_, values_);
  maxSteps_ = static_cast<int>(std::clamp(spec_->maxSteps(values_), 1.0, 1e9));
  state_.assign(spec_->states.size(), 0.0);
  measures_.assign(spec_->measures.size(), 0.0);
  potentials_.assign(spec_->rewards.size(), 0.0);
  u_.assign(spec_->actuators.size(), 0.0);
  assembly_ = std::make_unique<Assembly>(*spec_, numbers_);
  world_.reset();
  begin(assembly_->settled(assembly_->drawing()));
}

void Robot::parametersChanged() {
  rebuild();
}

Status Robot::check() const {
  std::vector<double> values = values_;
  std::vector<Complaint> complaints;
  Robot copy(spec_);
  std::copy(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(whole_.size()), copy.values_.begin());
  copy.whole_ = whole_;
  copy.computeConstants();
  static_cast<void>(numbersOf(*spec_, copy.values_, complaints));
  if (complaints.empty()) return Done{};
  return Error{complaintLine(spec_->name, complaints.front())};
}

void Robot::reset(Random& random) {
  begin(assembly_->start(values_, random));
}

// Where nothing meets anything, bodies are put back, and the next substep begins without impulses of the past: the same
// bits as in a new world. Contacts keep more of the past, so there every episode has a new world.
void Robot::begin(const std::vector<BodyPlacement>& wanted) {
  nowhere_ = !std::all_of(wanted.begin(), wanted.end(), isSomewhere);
  const std::vector<BodyPlacement> bodies = nowhere_ ? assembly_->settled(assembly_->drawing()) : wanted;
  if (!world_ || (numbers_.anythingMeets && !nowhere_)) {
    world_ = std::make_unique<RobotWorld>(*spec_, numbers_);
    for (const MemorySpec& memory : spec_->memories)
      if (memory.substep) world_->alsoInSubstep(memory.each.expression);
  }
  world_->place(bodies);
  steps_ = 0;
  std::fill(u_.begin(), u_.end(), 0.0);
  values_[stepAt_] = 0.0;
  values_[stepAt_ + 1] = 0.0;
  for (std::size_t m = 0; m < spec_->memories.size(); ++m) values_[memoriesAt_ + m] = spec_->memories[m].start(values_);
  world_->readAll(values_, u_);
  for (std::size_t m = 0; m < spec_->memories.size(); ++m)
    if (!spec_->memories[m].substep && !spec_->memories[m].hasStart)
      values_[memoriesAt_ + m] = spec_->memories[m].each(values_);
  observe();
  for (std::size_t r = 0; r < potentials_.size(); ++r)
    if (spec_->rewards[r].potential) potentials_[r] = spec_->rewards[r].value(values_);
  measure(true);
}

void Robot::observe() {
  for (std::size_t s = 0; s < state_.size(); ++s) values_[statesAt_ + s] = state_[s] = spec_->states[s].value(values_);
}

void Robot::remember(bool substep) {
  for (std::size_t m = 0; m < spec_->memories.size(); ++m)
    if (spec_->memories[m].substep == substep) values_[memoriesAt_ + m] = spec_->memories[m].each(values_);
}

void Robot::measure(bool first) {
  for (std::size_t m = 0; m < measures_.size(); ++m) {
    const MeasureSpec& spec = spec_->measures[m];
    if (first && spec.adds)
      measures_[m] = 0.0;
    else
      measures_[m] = (spec.adds ? measures_[m] : 0.0) + spec.value(values_);
  }
}

void Robot::decide(Action action) {
  if (action == kHandMade) {
    for (const std::size_t a : driven_) {
      const ActuatorSpec& actuator = spec_->actuators[a];
      if (!actuator.handMade) continue;
      double low = kInfinity, high = -kInfinity;  // no controller commands more than a level can
      for (const Formula& level : actuator.levels)
        low = std::min(low, level(values_)), high = std::max(high, level(values_));
      u_[a] = std::clamp((*actuator.handMade)(values_), low, high);
    }
    return;
  }
  auto rest = static_cast<std::size_t>(action);
  for (auto a = driven_.rbegin(); a != driven_.rend(); ++a) {
    const auto& levels = spec_->actuators[*a].levels;
    u_[*a] = levels[rest % levels.size()](values_);
    rest /= levels.size();
  }
}

bool Robot::substeps() {
  const double h = numbers_.stepTime / numbers_.substeps;
  double& time = values_[stepAt_ + 1];
  const double begun = steps_ * numbers_.stepTime;
  for (int i = 0; i < numbers_.substeps; ++i) {
    time = begun + i * h;
    if (!world_->substep(values_, u_)) return false;
    if (!inSubsteps_) continue;
    world_->readForSubstep(values_, u_);
    remember(true);
  }
  return true;
}

Outcome Robot::step(Action action) {
  for (const std::size_t c : live_) values_[constantsAt_ + c] = spec_->constants[c].value(values_);
  decide(action);
  const bool whole = !nowhere_ && substeps();
  ++steps_;
  values_[stepAt_] = steps_;
  values_[stepAt_ + 1] = steps_ * numbers_.stepTime;
  if (!whole) {
    ++flewApart_;
    ++inARow_;
    lastEnding_ = -1;
    const std::vector<double> last = state_;
    if (!nowhere_) world_.reset();  // it holds numbers that are none
    begin(assembly_->settled(assembly_->drawing()));
    state_ = last;
    Outcome outcome;
    outcome.ending = Ending::Truncated;
    return outcome;
  }
  world_->readAll(values_, u_);
  remember(false);
  observe();
  measure(false);
  return judged();
}

Outcome Robot::judged() {
  using Ends = EndingSpec::Kind;
  Outcome outcome;
  const auto eventOf = [](Ends kind) {
    return kind == Ends::Fall ? Event::Fall : kind == Ends::Goal ? Event::Success : Event::None;
  };
  for (const EndingSpec& event : spec_->events)
    if (outcome.event == Event::None && event.when.expression.holds(values_)) outcome.event = eventOf(event.kind);
  int ending = -1;
  for (std::size_t e = 0; e < spec_->endings.size() && ending < 0; ++e)
    if (spec_->endings[e].when.expression.holds(values_)) ending = static_cast<int>(e);
  lastEnding_ = ending;
  if (ending >= 0) {
    const Ends kind = spec_->endings[static_cast<std::size_t>(ending)].kind;
    outcome.ending = kind == Ends::Time ? Ending::Truncated : Ending::Terminal;
    if (outcome.event == Event::None) outcome.event = eventOf(kind);
  } else if (steps_ >= maxSteps_) {
    outcome.ending = Ending::Truncated;
  }
  if (outcome.ending != Ending::None) inARow_ = 0;
  for (std::size_t r = 0; r < spec_->rewards.size(); ++r) {
    const RewardSpec& reward = spec_->rewards[r];
    const bool here =
        (!reward.ending || *reward.ending == ending) && (!reward.when || reward.when->expression.holds(values_));
    if (!here && !reward.potential) continue;
    const double value = valueOf(r);
    if (here) outcome.terms[r] = value;
    outcome.reward += outcome.terms[r];
  }
  return outcome;
}

double Robot::valueOf(std::size_t reward) {
  const RewardSpec& spec = spec_->rewards[reward];
  const double value = spec.value(values_);
  return spec.potential ? value - std::exchange(potentials_[reward], value) : value;
}

std::string Robot::failure() const {
  if (inARow_ < kMostInARow) return {};
  std::string changed;
  for (std::size_t p = 0; p < whole_.size(); ++p)
    if (values_[p] != spec_->defaults[p])
      changed +=
          fmt::format("{}environment.{} = {}", changed.empty() ? "" : ", ", spec_->parameters[p].key, values_[p]);
  return fmt::format("The robot {} flew apart in {} episodes in a row: {}.", spec_->name, kMostInARow,
                     changed.empty() ? "more substeps, weaker springs or smaller efforts may hold it together"
                                     : changed + " may be the cause");
}

bool Robot::push(double impulse) {
  if (spec_->push < 0 || !world_) return false;
  world_->push(spec_->push, impulse);
  return true;
}

std::vector<double> Robot::pose() const {
  std::vector<double> pose;
  for (std::size_t b = 0; b < spec_->bodies.size(); ++b) {
    const BodyPlacement body = world_->placement(static_cast<int>(b));
    pose.insert(pose.end(), {body.at.x, body.at.y, body.angle});
  }
  pose.insert(pose.end(), u_.begin(), u_.end());
  pose.insert(pose.end(), state_.begin(), state_.end());
  return pose;
}

}  // namespace surefoot
