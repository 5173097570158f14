// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/leo/leo.h"

#include <algorithm>
#include <cmath>

namespace surefoot {

using namespace leo;

namespace {

enum RewardTerm { kTime, kEnergy, kFootstep, kFall };
enum Measure { kDistance, kNetFootsteps, kEnergyTaken };

StateVariable angle(const char* key, const char* title, const char* symbol, double low, double high, double width) {
  return {.key = key,
          .title = title,
          .symbol = symbol,
          .unit = "rad",
          .low = low,
          .high = high,
          .span = 1.0,
          .spanText = "rad",
          .perSpan = "/rad",
          .resolution = 1.0 / width,
          .viewLow = std::max(low, -1.5),
          .viewHigh = std::min(high, 1.5)};
}

StateVariable rate(const char* key, const char* title, const char* symbol, double most, double width) {
  return {.key = key,
          .title = title,
          .symbol = symbol,
          .unit = "rad/s",
          .low = -most,
          .high = most,
          .span = 1.0,
          .spanText = "rad/s",
          .perSpan = "s/rad",
          .resolution = 1.0 / width,
          .viewLow = -0.5 * most,
          .viewHigh = 0.5 * most};
}

ActionVariable voltage(const char* key, const char* title, const char* symbol, const LeoSettings& s) {
  ActionVariable v{.key = key, .title = title, .symbol = symbol, .unit = "V", .levels = {}, .resolution = 1.0 / 6.67};
  for (int i = 0; i < s.levels; ++i) v.levels.push_back(s.voltage * (2.0 * i / (s.levels - 1) - 1.0));
  return v;
}

Task makeTask(const LeoSettings& s) {
  constexpr double kBeyond = 0.2;  // [rad]: stops yield
  const JointKind &hip = s.anatomy.hip, &knee = s.anatomy.knee;
  Task task;
  task.state = {angle("torso", "torso", "ψ", -1.2, 1.2, 0.2),
                rate("torso_rate", "torso rate", "ψ\u0307", 15.0, 7.1),
                angle("stance_hip", "stance hip", "h", hip.low - kBeyond, hip.high + kBeyond, 0.4),
                rate("stance_hip_rate", "stance hip rate", "h\u0307", 30.0, 14.3),
                angle("swing_hip", "swing hip", "H", hip.low - kBeyond, hip.high + kBeyond, 0.4),
                rate("swing_hip_rate", "swing hip rate", "H\u0307", 30.0, 14.3),
                angle("stance_knee", "stance knee", "k", knee.low - kBeyond, knee.high + kBeyond, 0.4),
                rate("stance_knee_rate", "stance knee rate", "k\u0307", 30.0, 14.3),
                angle("swing_knee", "swing knee", "K", knee.low - kBeyond, knee.high + kBeyond, 0.4),
                rate("swing_knee_rate", "swing knee rate", "K\u0307", 30.0, 14.3)};
  task.actionVariables = {voltage("stance_hip_voltage", "stance hip voltage", "U_h", s),
                          voltage("swing_hip_voltage", "swing hip voltage", "U_H", s),
                          voltage("swing_knee_voltage", "swing knee voltage", "U_K", s)};
  const int actions = s.levels * s.levels * s.levels;
  for (int a = 0; a < actions; ++a) task.actions.push_back(a);
  task.actionTitle = "voltages";
  task.actionSymbol = "U";
  task.actionUnit = "V";
  task.rewardTerms = {"time", "energy", "footstep", "fall"};
  task.timeReward = s.timeReward;
  task.measures = {{"distance", "distance", "m"}, {"net_footsteps", "net footsteps", ""}, {"energy", "energy", "J"}};
  task.testEvery = s.testEvery;
  task.stepTime = LeoWorld::kStepTime;
  task.handMade = true;
  task.lowestReturn = 2 * s.fallReward;
  task.highestReturn = 14 * s.footstepReward;  // about the return of the hand-made controller in 25 s
  return task;
}

}  // namespace

Leo::Leo(const LeoSettings& settings) : settings_(settings), task_(makeTask(settings)) {
  begin(settings_.anatomy.start, {});
}

void Leo::parametersChanged() {
  task_ = makeTask(settings_);
  begin(settings_.anatomy.start, {});
}

void Leo::reset(Random&) {
  begin(settings_.anatomy.start, {});
}

void Leo::begin(const LeoWorld::Angles& angles, const LeoWorld::Angles& rates) {
  world_ = std::make_unique<LeoWorld>(settings_, angles, rates);
  stance_ = steps_ = sinceFootstep_ = 0;
  swingsForward_ = false;
  command_ = {};
  distance_ = ankleDistance();
  start_ = world_->hip().x;
  measures_ = {};
  observe();
}

double Leo::ankleDistance() const {
  return world_->ankle(1 - stance_).x - world_->ankle(stance_).x;
}

int Leo::supportingLeg() const {
  const bool left = world_->onFloor(0), right = world_->onFloor(1);
  if (left && right) return world_->ankle(0).x >= world_->ankle(1).x ? 0 : 1;
  return left ? 0 : right ? 1 : stance_;
}

void Leo::observe() {
  const auto stance = [&](Joint leftJoint) { return static_cast<Joint>(leftJoint + stance_); };
  const auto swing = [&](Joint leftJoint) { return static_cast<Joint>(leftJoint + 1 - stance_); };
  const LeoWorld& w = *world_;
  state_ = {w.angle(kTorso),
            w.rate(kTorso),
            w.jointAngle(stance(kLeftHip)),
            w.jointRate(stance(kLeftHip)),
            w.jointAngle(swing(kLeftHip)),
            w.jointRate(swing(kLeftHip)),
            w.jointAngle(stance(kLeftKnee)),
            w.jointRate(stance(kLeftKnee)),
            w.jointAngle(swing(kLeftKnee)),
            w.jointRate(swing(kLeftKnee))};
}

Action Leo::handMadeAction() const {
  std::array<std::size_t, 3> levels{};
  const Command command = handMade();
  for (std::size_t v = 0; v < levels.size(); ++v) levels[v] = nearestLevel(task_.actionVariables[v].levels, command[v]);
  return actionOf(task_, levels);
}

Leo::Command Leo::commandOf(Action action) const {
  const auto levels = static_cast<std::size_t>(settings_.levels), a = static_cast<std::size_t>(action);
  const auto& v = task_.actionVariables;
  return {v[0].levels[a / (levels * levels)], v[1].levels[a / levels % levels], v[2].levels[a % levels]};
}

// The laboratory's: the hips swing against each other towards a target, the torso is held a little forward, the knee is
// bent after a footstep and then stretched. All voltages are limited by the world.
Leo::Command Leo::handMade() const {
  constexpr double kGain = 14.0 / 3.3, kTorsoTarget = -0.09, kBend = 0.184;  // [V/rad], [rad], [s]
  const double torso = state_[0], stanceHip = state_[2], swingHip = state_[4], swingKnee = state_[8];
  const double inter = 4.0 * (settings_.hipTarget - (swingHip - stanceHip));
  const bool bending = swingsForward_ && sinceFootstep_ * LeoWorld::kStepTime < kBend;
  return {kGain * (-0.2 * inter - 14.0 * (kTorsoTarget - torso)), kGain * inter,
          bending ? -14.0 : 65.0 * (0.0 - swingKnee)};
}

LeoWorld::Voltages Leo::voltagesFor(const Command& c) const {
  LeoWorld::Voltages u{};
  const auto stance = static_cast<std::size_t>(stance_), swing = static_cast<std::size_t>(1 - stance_);
  u[kLeftHip + stance] = c[0];
  u[kLeftHip + swing] = c[1];
  u[kLeftKnee + swing] = c[2];
  u[kLeftKnee + stance] = settings_.stanceKneeGain * (0.0 - state_[6]);
  for (int leg = 0; leg < 2; ++leg) {
    const auto ankle = static_cast<Joint>(kLeftAnkle + leg);
    u[ankle] = settings_.ankleGain * (settings_.ankleTarget - world_->jointAngle(ankle));
  }
  return u;
}

Outcome Leo::step(Action action) {
  command_ = action == kHandMade ? handMade() : commandOf(action);
  for (double& volts : command_) volts = std::clamp(volts, -settings_.voltage, settings_.voltage);
  const double energy = world_->step(voltagesFor(command_));
  ++steps_;
  ++sinceFootstep_;

  // The step that ends in a footstep still counts for the leg that swung; the next one begins at −L.
  const double parted = ankleDistance() - distance_;
  distance_ += parted;
  if (const int leg = supportingLeg(); leg != stance_) {
    stance_ = leg;
    const bool forward = distance_ > 0;
    distance_ = -distance_;
    if (forward) sinceFootstep_ = 0, swingsForward_ = true;
    measures_[kNetFootsteps] += forward ? 1.0 : -1.0;
  }
  measures_[kDistance] = world_->hip().x - start_;
  measures_[kEnergyTaken] += energy;
  observe();

  Outcome outcome;
  outcome.terms[kTime] = settings_.timeReward;
  outcome.terms[kEnergy] = settings_.energyReward * energy;
  outcome.terms[kFootstep] = settings_.footstepReward * parted;
  if (std::abs(state_[0]) > settings_.mostTorso || std::abs(state_[0] + state_[2]) > settings_.mostStanceThigh) {
    outcome.terms[kFall] = settings_.fallReward;
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Fall;
  } else if (steps_ >= settings_.maxSteps) {
    outcome.ending = Ending::Truncated;
  }
  for (const double term :
       {outcome.terms[kTime], outcome.terms[kEnergy], outcome.terms[kFootstep], outcome.terms[kFall]})
    outcome.reward += term;
  return outcome;
}

bool Leo::push(double impulse) {
  world_->push(impulse);
  return true;
}

namespace {

/// The angles of all bodies from the state. It has no ankles: they stand at their own target. The left leg stands.
LeoWorld::Angles bodiesOf(std::span<const double> v, std::size_t rate, double ankleAngle) {
  LeoWorld::Angles b{};
  b[kTorso] = v[0 + rate];
  b[kLeftThigh] = b[kTorso] + v[2 + rate];
  b[kRightThigh] = b[kTorso] + v[4 + rate];
  b[kLeftShank] = b[kLeftThigh] + v[6 + rate];
  b[kRightShank] = b[kRightThigh] + v[8 + rate];
  const double ankle = rate == 0 ? ankleAngle : 0.0;
  b[kLeftFoot] = b[kLeftShank] + ankle;
  b[kRightFoot] = b[kRightShank] + ankle;
  return b;
}

}  // namespace

bool Leo::place(std::span<const double> state) {
  begin(bodiesOf(state, 0, settings_.ankleTarget), bodiesOf(state, 1, 0.0));
  return true;
}

std::vector<double> Leo::poseAt(std::span<const double> state) const {
  const LeoWorld there(settings_, bodiesOf(state, 0, settings_.ankleTarget), {}, world_->hip().x);
  std::vector<double> pose = {there.hip().x, there.hip().y};
  for (int body = 0; body < kBodies; ++body) pose.push_back(there.angle(static_cast<Body>(body)));
  pose.insert(pose.end(), 8, 0.0);
  return pose;
}

std::vector<double> Leo::pose() const {
  std::vector<double> pose = {world_->hip().x, world_->hip().y};
  for (int body = 0; body < kBodies; ++body) pose.push_back(world_->angle(static_cast<Body>(body)));
  pose.insert(pose.end(), command_.begin(), command_.end());
  pose.push_back(stance_);
  for (int leg = 0; leg < 2; ++leg) pose.push_back(world_->onFloor(leg));
  pose.push_back(measures_[kNetFootsteps]);
  pose.push_back(steps_ > 0 ? measures_[kDistance] / (steps_ * LeoWorld::kStepTime) : 0.0);
  return pose;
}

}  // namespace surefoot
