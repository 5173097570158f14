// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Leo that tells what moves.
#include "physics/leo/leo.h"

namespace surefoot {

using namespace leo;

namespace {

constexpr const char* kJointNames[] = {"left hip", "right hip", "left knee", "right knee", "left ankle", "right ankle"};
constexpr const char* kLegNames[] = {"left", "right"};

std::string keyOf(std::string title) {
  for (char& c : title)
    if (c == ' ') c = '_';
  return title;
}

}  // namespace

std::vector<Signal> Leo::signals() const {
  std::vector<Signal> all;
  const auto add = [&](const std::string& title, const char* unit, const char* group, Signal::Kind kind) {
    all.push_back({.key = keyOf(title), .title = title, .symbol = {}, .unit = unit, .group = group, .kind = kind});
  };
  add("hip position", "m", "motion", Signal::Kind::Number);
  add("hip height", "m", "motion", Signal::Kind::Number);
  add("hip speed", "m/s", "motion", Signal::Kind::Number);
  for (const char* leg : kLegNames)
    for (const char* part : {"heel", "toe"}) add(std::string(leg) + " " + part, "", "contacts", Signal::Kind::OnOff);
  add("right leg stands", "", "gait", Signal::Kind::OnOff);
  for (const char* joint : kJointNames)
    for (const auto& [what, unit, group] : {std::tuple{"angle", "rad", "motion"},
                                            {"rate", "rad/s", "motion"},
                                            {"voltage", "V", "motors"},
                                            {"current", "A", "motors"},
                                            {"power", "W", "motors"}})
      add(std::string(joint) + " " + what, unit, group, Signal::Kind::Number);
  add("power of all motors", "W", "motors", Signal::Kind::Number);
  return all;
}

void Leo::readSignals(std::span<double> values) const {
  const LeoWorld& w = *world_;
  std::size_t i = 0;
  values[i++] = w.hip().x;
  values[i++] = w.hip().y;
  values[i++] = w.hipSpeed();
  for (int leg = 0; leg < 2; ++leg)
    for (const bool heel : {true, false}) values[i++] = w.touches(leg, heel);
  values[i++] = stance_;
  double power = 0.0;
  for (int j = 0; j < kJoints; ++j) {
    const auto joint = static_cast<Joint>(j);
    for (const double value :
         {w.jointAngle(joint), w.jointRate(joint), w.voltage(joint), w.current(joint), w.power(joint)})
      values[i++] = value;
    power += w.power(joint);
  }
  values[i++] = power;
}

}  // namespace surefoot
