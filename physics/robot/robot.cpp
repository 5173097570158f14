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

}  // namespace

Robot::Robot(std::shared_ptr<const RobotSpec> spec) : values_(std::move(spec)) {
  rebuild();
}

Robot::~Robot() = default;

void Robot::rebuild() {
  values_.computeConstants();
  std::vector<Complaint> complaints;
  RobotNumbers numbers = numbersOf(spec(), values_.row(), complaints);
  if (!complaints.empty()) return;  // check() tells it; what was possible before stays
  numbers_ = std::move(numbers);
  values_.renewTask();
  assembly_ = std::make_unique<Assembly>(spec(), numbers_);
  world_.reset();
  begin(assembly_->settled(assembly_->drawing()));
}

void Robot::parametersChanged() {
  rebuild();
}

Status Robot::check() const {
  RobotValues copy = values_;
  copy.computeConstants();
  std::vector<Complaint> complaints;
  static_cast<void>(numbersOf(spec(), copy.row(), complaints));
  if (complaints.empty()) return Done{};
  return Error{complaintLine(spec().name, complaints.front())};
}

void Robot::reset(Random& random) {
  begin(assembly_->start(values_.row(), random));
}

// Where nothing meets anything, bodies are put back, and the next substep begins without impulses of the past: the same
// bits as in a new world. Contacts keep more of the past, so there every episode has a new world.
void Robot::begin(const std::vector<BodyPlacement>& wanted) {
  nowhere_ = !std::all_of(wanted.begin(), wanted.end(), isSomewhere);
  const std::vector<BodyPlacement> bodies = nowhere_ ? assembly_->settled(assembly_->drawing()) : wanted;
  if (!world_ || (numbers_.anythingMeets && !nowhere_)) {
    world_ = std::make_unique<RobotWorld>(spec(), numbers_);
    for (const MemorySpec& memory : spec().memories)
      if (memory.substep) world_->alsoInSubstep(memory.each.expression);
  }
  world_->place(bodies);
  values_.startEpisode();
  world_->readAll(values_.row(), values_.levels());
  nowhere_ |= !values_.settle();
}

bool Robot::substeps() {
  const double h = numbers_.stepTime / numbers_.substeps;
  const double begun = values_.steps() * numbers_.stepTime;
  for (int i = 0; i < numbers_.substeps; ++i) {
    values_.setTime(begun + i * h);
    if (!world_->substep(values_.row(), values_.levels())) return false;
    if (!values_.remembersSubsteps()) continue;
    world_->readForSubstep(values_.row(), values_.levels());
    values_.remember(true);
  }
  return true;
}

Outcome Robot::step(Action action) {
  values_.decide(action);
  const bool whole = !nowhere_ && substeps();
  values_.tick();
  if (!whole) return flyApart();
  world_->readAll(values_.row(), values_.levels());
  Outcome outcome;
  if (!values_.judge(outcome)) return flyApart();
  if (outcome.ending != Ending::None) mishaps_.wentWell();
  return outcome;
}

Outcome Robot::flyApart() {
  const Outcome outcome = mishaps_.cutOff(values_);
  const std::vector<double> last(state().begin(), state().end());
  if (!nowhere_) world_.reset();  // it holds numbers that are none
  begin(assembly_->settled(assembly_->drawing()));
  values_.keepState(last);
  return outcome;
}

bool Robot::push(double impulse) {
  if (spec().push < 0 || !world_) return false;
  world_->push(spec().push, impulse);
  return true;
}

std::vector<double> Robot::pose() const {
  std::vector<double> pose;
  for (std::size_t b = 0; b < spec().bodies.size(); ++b) {
    const BodyPlacement body = world_->placement(static_cast<int>(b));
    pose.insert(pose.end(), {body.at.x, body.at.y, body.angle});
  }
  pose.insert(pose.end(), values_.levels().begin(), values_.levels().end());
  pose.insert(pose.end(), state().begin(), state().end());
  return pose;
}

}  // namespace surefoot
