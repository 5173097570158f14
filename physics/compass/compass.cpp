// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/compass/compass.h"

#include <cmath>

namespace surefoot {

namespace {

enum RewardTerm { kFootstep, kFall, kTime };

StateVariable variable(const char* key, const char* title, const char* symbol, bool rate, double low, double high,
                       double width) {
  return {.key = key,
          .title = title,
          .symbol = symbol,
          .unit = rate ? "rad/s" : "rad",
          .low = low,
          .high = high,
          .span = 1.0,
          .spanText = rate ? "rad/s" : "rad",
          .perSpan = rate ? "s/rad" : "/rad",
          .resolution = 1.0 / width,
          .viewLow = low,
          .viewHigh = high};
}

Task makeTask(const CompassSettings& s) {
  constexpr double kMostStance = 0.5, kMostSwing = 1.0;  // [rad]: the range that tiles cover and maps show
  Task task;
  task.state = {variable("stance_angle", "stance angle", "θ", false, -kMostStance, kMostStance, 0.1),
                variable("stance_rate", "stance rate", "θ\u0307", true, -3.0, 0.6, 0.5),
                variable("swing_angle", "swing angle", "φ", false, -kMostSwing, kMostSwing, 0.2),
                variable("swing_rate", "swing rate", "φ\u0307", true, -6.0, 6.0, 1.5)};
  task.actions = {-s.torque, 0.0, s.torque};
  task.actionTitle = "hip torque";
  task.actionSymbol = "T";
  task.actionUnit = "N m";
  task.rewardTerms = {"footstep", "fall", "time"};
  task.timeReward = s.timeReward;
  task.measures = {{"distance", "distance", "m"}, {"net_footsteps", "net footsteps", ""}};
  task.testEvery = s.testEvery;
  task.stepTime = CompassWorld::kStepTime;
  task.lowestReturn = s.fallReward + s.timeReward * 100;
  task.highestReturn = s.footstepReward * 5;  // about 20 steps of 0.3 m in 20 s, less their time
  return task;
}

}  // namespace

Compass::Compass(const CompassSettings& settings) : settings_(settings), task_(makeTask(settings)) {
  resetTo({settings_.startStance, settings_.startRate, settings_.startSwing, 0.0});
}

void Compass::parametersChanged() {
  task_ = makeTask(settings_);
  resetTo({settings_.startStance, settings_.startRate, settings_.startSwing, 0.0});
}

void Compass::reset(Random& random) {
  const double noise = settings_.startNoise;
  const auto varied = [&](double value) { return value * random.uniform(1.0 - noise, 1.0 + noise); };
  CompassWorld::Posture p;
  p.stance = varied(settings_.startStance);
  p.stanceRate = varied(settings_.startRate);
  p.swing = varied(settings_.startSwing);
  p.swingRate = random.uniform(-noise, noise);
  resetTo(p);
}

void Compass::resetTo(const CompassWorld::Posture& posture) {
  world_ = std::make_unique<CompassWorld>(settings_, posture);
  steps_ = 0;
  torque_ = 0.0;
  start_ = world_->hipX();
  measures_ = {};
  observe();
}

void Compass::observe() {
  const CompassWorld::Posture p = world_->posture();
  state_ = {p.stance, p.stanceRate, p.swing, p.swingRate};
}

Outcome Compass::step(Action action) {
  torque_ = task_.actions[static_cast<std::size_t>(action)];
  const double footstep = world_->step(torque_);
  observe();
  ++steps_;
  measures_[0] = world_->hipX() - start_;
  if (footstep != 0.0) measures_[1] += footstep > 0 ? 1.0 : -1.0;

  Outcome outcome;
  outcome.terms[kTime] = settings_.timeReward;
  outcome.terms[kFootstep] = settings_.footstepReward * footstep;
  if (std::abs(state_[0]) > settings_.mostStance || std::abs(state_[2]) > settings_.mostSwing) {
    outcome.terms[kFall] = settings_.fallReward;
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Fall;
  } else if (steps_ >= settings_.maxSteps) {
    outcome.ending = Ending::Truncated;
  }
  outcome.reward = outcome.terms[kFootstep] + outcome.terms[kFall] + outcome.terms[kTime];
  return outcome;
}

bool Compass::push(double impulse) {
  world_->push(impulse);
  return true;
}

bool Compass::place(std::span<const double> state) {
  resetTo({state[0], state[1], state[2], state[3]});
  return true;
}

std::vector<double> Compass::poseAt(std::span<const double> state) const {
  return {world_->hipX(), state[0], state[1], state[2], state[3], 0.0, static_cast<double>(world_->stanceLeg())};
}

std::vector<Signal> Compass::signals() const {
  return {{.key = "hip_position", .title = "hip position", .symbol = "x", .unit = "m", .group = "motion"},
          {.key = "hip_height", .title = "hip height", .symbol = "y", .unit = "m", .group = "motion"},
          {.key = "torque", .title = "torque on the swing leg", .symbol = "T", .unit = "N m", .group = "motors"},
          {.key = "power", .title = "power of the hip", .symbol = "P", .unit = "W", .group = "motors"},
          {.key = "left_foot", .title = "left foot on the floor", .group = "contacts", .kind = Signal::Kind::OnOff},
          {.key = "right_foot", .title = "right foot on the floor", .group = "contacts", .kind = Signal::Kind::OnOff}};
}

void Compass::readSignals(std::span<double> values) const {
  values[0] = world_->hipX();
  values[1] = world_->hipY();
  values[2] = torque_;
  values[3] = torque_ * (state_[3] - state_[1]);
  values[4] = world_->stanceLeg() == 0;
  values[5] = world_->stanceLeg() == 1;
}

std::vector<double> Compass::pose() const {
  return {
      world_->hipX(), state_[0], state_[1], state_[2], state_[3], torque_, static_cast<double>(world_->stanceLeg())};
}

}  // namespace surefoot
