// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that all walkers share: the floor with its friction, and the declarations of rewards.
#pragma once

#include <box2d/box2d.h>

#include "core/parameters.h"

namespace surefoot {

/// Bodies of one group do not collide with each other; the floor is in no group.
inline constexpr std::int16_t kRobotGroup = -1;

/// A flat floor at height 0, 500 m to either side; `scale` is Box2D's units per metre.
inline b2Body* addFloor(b2World& world, double scale, double friction) {
  constexpr double kHalfLength = 500;  // [m]
  const b2BodyDef def;
  b2Body* floor = world.CreateBody(&def);
  b2PolygonShape box;
  box.SetAsBox(static_cast<float>(scale * kHalfLength), 1.0f, b2Vec2(0.0f, -1.0f), 0.0f);
  b2FixtureDef fixture;
  fixture.shape = &box;
  fixture.friction = static_cast<float>(friction);
  floor->CreateFixture(&fixture);
  return floor;
}

/// Where the constants of LEO and its task come from.
inline constexpr const char* kLeosim = "wcaarls/grl, addons/leosim";

/// How often the greedy policy is tested.
inline Parameter testParameter() {
  return {.key = "test_every",
          .title = "Greedy test every",
          .unit = "episodes",
          .low = 0,
          .high = 1e6,
          .sliderLow = 0,
          .sliderHigh = 100,
          .when = When::NextEpisode,
          .group = Group::Model,
          .help = "Episodes between two tests of the greedy policy, which are not counted; 0: none.",
          .origin = kLeosim,
          .order = 3};
}

/// A reward that applies at once; low and high are the slider's.
inline Parameter rewardParameter(const char* key, const char* title, double low, double high, const char* help,
                                 const char* origin, const char* unit = "") {
  return {.key = key,
          .title = title,
          .unit = unit,
          .low = -1e6,
          .high = 1e6,
          .sliderLow = low,
          .sliderHigh = high,
          .when = When::Now,
          .group = Group::Rewards,
          .help = help,
          .origin = origin};
}
inline Parameter fallParameter(const char* help, const char* origin) {
  Parameter p = rewardParameter("fall_reward", "Fall", kHardestFall, 0, help, origin);
  p.sliderBend = kBendOfFalls;
  return p;
}

}  // namespace surefoot
