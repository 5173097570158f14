// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/leo/leo_body.h"

#include "physics/world/walking.h"

namespace surefoot::leo {

namespace {

/// A parameter that few people change: shown only on request.
Parameter part(std::string key, std::string title, const char* unit, double low, double high, const char* help) {
  return {.key = std::move(key),
          .title = std::move(title),
          .unit = unit,
          .low = low,
          .high = high,
          .when = When::NextEpisode,
          .group = Group::Model,
          .help = help,
          .origin = kLeosim,
          .order = 3};
}

void declarePoint(Fields& f, Vec& v, const std::string& key, const std::string& title, const char* help) {
  f.real(v.x, part(key + "_x", title + " x", "m", -0.2, 0.2, help));
  f.real(v.y, part(key + "_y", title + " y", "m", -0.2, 0.2, help));
}

void declareMass(Fields& f, Mass& m, const std::string& key, const std::string& title) {
  Parameter mass =
      part(key + "_mass", title + " mass", "kg", 0.02, 10, "Of one such body; the torso's with boom and arm.");
  mass.order = key == "torso" ? 1 : 2;
  if (key == "torso") mass.symbol = "m";
  f.real(m.mass, mass);
  f.real(m.inertia, part(key + "_inertia", title + " inertia", "kg m²", 1e-5, 1, "About its centre of mass."));
  declarePoint(f, m.centre, key + "_centre", title + " centre", "Centre of mass, in the body's own frame.");
}

void declareJoint(Fields& f, JointKind& j, const std::string& key, const std::string& title) {
  declarePoint(f, j.inParent, key + "_in_parent", title + " above", "Where the joint is in the body above it.");
  declarePoint(f, j.inChild, key + "_in_child", title + " below", "Where the joint is in the body below it.");
  f.real(j.low, part(key + "_low", title + " low", "rad", -3.1, 0, "Where the joint's stop is, bent backwards."));
  f.real(j.high, part(key + "_high", title + " high", "rad", 0, 3.1, "Where the joint's stop is, bent forwards."));
  f.real(j.stopStiffness,
         part(key + "_stop_stiffness", title + " stop", "N m/rad", 0, 1000, "Stiffness of the joint's stops."));
  Parameter damping =
      part(key + "_stop_damping", title + " stop damping", "N m s/rad", 0, 100, "Damping of the joint's stops.");
  damping.label = title + " damper";
  f.real(j.stopDamping, damping);
}

void declareCircle(Fields& f, Circle& c, const std::string& key, const std::string& title) {
  declarePoint(f, c.centre, key, title, "Centre of a circle that meets the floor, in its body's frame.");
  f.real(c.radius, part(key + "_radius", title + " radius", "m", 0.001, 0.2, "Of a circle that meets the floor."));
}

}  // namespace

void Anatomy::declare(Fields& f) {
  declareMass(f, torso, "torso", "Torso");
  declareMass(f, thigh, "thigh", "Thigh");
  declareMass(f, shank, "shank", "Shank");
  declareMass(f, foot, "foot", "Foot");
  declareJoint(f, hip, "hip", "Hip");
  declareJoint(f, knee, "knee", "Knee");
  declareJoint(f, ankle, "ankle", "Ankle");
  declareCircle(f, heel, "heel", "Heel");
  declareCircle(f, toe, "toe", "Toe");
  declareCircle(f, kneeCap, "knee_cap", "Knee cap");
  declareCircle(f, seat, "seat", "Seat");
  declarePoint(f, boomPoint, "boom_point", "Boom point", "Where the boom's force acts on the torso.");
  constexpr std::array<std::pair<const char*, const char*>, kBodies> kNames = {{{"torso", "torso"},
                                                                                {"stance_thigh", "stance thigh"},
                                                                                {"swing_thigh", "swing thigh"},
                                                                                {"stance_shank", "stance shank"},
                                                                                {"swing_shank", "swing shank"},
                                                                                {"stance_foot", "stance foot"},
                                                                                {"swing_foot", "swing foot"}}};
  for (std::size_t body = 0; body < kBodies; ++body) {
    const std::string name = kNames[body].second;
    Parameter angle = part(std::string("start_") + kNames[body].first, "Start, " + name, "rad", -1.5, 1.5,
                           "Angle of the body when an episode begins, at rest.");
    angle.label = name;
    f.real(start[body], angle);
  }
}

}  // namespace surefoot::leo
