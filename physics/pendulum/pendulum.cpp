// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/pendulum/pendulum.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "physics/pendulum/pendulum_world.h"

namespace surefoot {

namespace {

enum RewardTerm { kGoal, kFall, kTime };

Task makeTask(const PendulumSettings& s) {
  constexpr double pi = std::numbers::pi;
  const bool metres = std::abs(s.wheelSpan - 1.0 / s.wheelRadius) < 1e-9;
  Task task;
  task.state = {{.key = "pole_angle",
                 .title = "pole angle",
                 .symbol = "α",
                 .unit = "rad",
                 .low = -0.45 * pi,
                 .high = 0.45 * pi,
                 .span = 2 * pi,
                 .spanText = "2π rad",
                 .perSpan = "/2π",
                 .resolution = 12,
                 .viewLow = -0.45 * pi,
                 .viewHigh = 0.45 * pi},
                {.key = "pole_rate",
                 .title = "pole rate",
                 .symbol = "α\u0307",
                 .unit = "rad/s",
                 .low = -16.0,
                 .high = 16.0,
                 .span = 2 * pi,
                 .spanText = "2π rad/s",
                 .perSpan = "/2π",
                 .resolution = 6,
                 .viewLow = -12.0,
                 .viewHigh = 12.0},
                {.key = "wheel_rate",
                 .title = "wheel rate",
                 .symbol = "β\u0307",
                 .unit = "rad/s",
                 .low = -30.0,
                 .high = 30.0,
                 .span = s.wheelSpan,
                 .spanText = metres ? "m/s" : "2π rad/s",
                 .perSpan = metres ? "s/m" : "/2π",
                 .resolution = 6,
                 .viewLow = -20.0,
                 .viewHigh = 20.0}};
  task.actions = {-1.5, -0.75, 0.0, 0.75, 1.5};
  task.actionTitle = "torque";
  task.actionSymbol = "T";
  task.actionUnit = "N m";
  task.rewardTerms = {"goal", "fall", "time"};
  task.goalReward = s.goalReward;
  task.timeReward = s.timeReward;
  task.stepTime = PendulumWorld::kStepTime;
  task.lowestReturn = s.fallReward;
  task.highestReturn = s.goalReward;
  return task;
}

}  // namespace

Pendulum::Pendulum(const PendulumSettings& settings)
    : settings_(settings),
      task_(makeTask(settings)),
      world_(std::make_unique<PendulumWorld>(settings)) {}

Pendulum::~Pendulum() = default;

void Pendulum::parametersChanged() {
  task_ = makeTask(settings_);
  world_ = std::make_unique<PendulumWorld>(settings_);
}

Status Pendulum::check() const {
  const PendulumSettings& s = settings_;
  for (const auto& [key, angle] :
       {std::pair{"start_angle", s.startAngle}, std::pair{"balanced_angle", s.balancedAngle}})
    if (angle >= s.fallAngle)
      return Error{
          fmt::format("environment.{} = {} must be below environment.fall_angle = {}.", key, angle, s.fallAngle)};
  return Done{};
}

void Pendulum::reset(Random& random) {
  resetTo(random.uniform(-settings_.startAngle, settings_.startAngle), 0.0, 0.0);
}

void Pendulum::resetTo(double poleAngle, double poleRate, double wheelRate) {
  world_->place(poleAngle, poleRate, wheelRate);
  steps_ = 0;
  torque_ = 0.0;
  observe();
}

void Pendulum::advance(double torque) {
  torque_ = torque * settings_.torqueScale;
  world_->step(torque_);
  observe();
}

void Pendulum::observe() {
  state_ = {world_->poleAngle(), world_->poleRate(), world_->wheelRate()};
}

Outcome Pendulum::step(Action action) {
  advance(task_.actions[static_cast<std::size_t>(action)]);
  ++steps_;

  Outcome outcome;
  outcome.terms[kTime] = settings_.timeReward;
  if (std::abs(state_[0]) >= settings_.fallAngle) {
    outcome.terms[kFall] = settings_.fallReward;
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Fall;
  } else if (std::abs(state_[0]) <= settings_.balancedAngle && std::abs(state_[1]) <= settings_.balancedRate) {
    outcome.terms[kGoal] = settings_.goalReward;
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Success;
  } else if (steps_ >= settings_.maxSteps) {
    outcome.ending = Ending::Truncated;
  }
  outcome.reward = outcome.terms[kGoal] + outcome.terms[kFall] + outcome.terms[kTime];
  return outcome;
}

bool Pendulum::push(double impulse) {
  world_->push(impulse);
  return true;
}

bool Pendulum::place(std::span<const double> state) {
  resetTo(state[0], state[1], state[2]);
  return true;
}

std::vector<double> Pendulum::poseAt(std::span<const double> state) const {
  return {world_->x(), state[0], state[1], state[2], 0.0};
}

std::vector<Signal> Pendulum::signals() const {
  return {{.key = "cart_position", .title = "cart position", .symbol = "x", .unit = "m", .group = "motion"},
          {.key = "torque", .title = "torque of the wheel", .symbol = "T", .unit = "N m", .group = "motors"},
          {.key = "power", .title = "power of the wheel", .symbol = "P", .unit = "W", .group = "motors"},
          {.key = "energy", .title = "energy, 0 upright at rest", .symbol = "E", .unit = "J", .group = "motion"}};
}

void Pendulum::readSignals(std::span<double> values) const {
  values[0] = world_->x();
  values[1] = torque_;
  values[2] = torque_ * state_[2];
  values[3] = world_->energy();
}

std::vector<double> Pendulum::pose() const {
  return {world_->x(), state_[0], state_[1], state_[2], torque_};
}

}  // namespace surefoot
