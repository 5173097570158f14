// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/register.h"

#include <numbers>

#include "physics/compass/compass.h"
#include "physics/pendulum/pendulum.h"

namespace surefoot {

namespace {

constexpr const char* kPendulum = "pendulum";

/// Table 4.1 of the thesis: damping [N m s/rad], dry friction [N m], torque scaling.
AssignmentEntry scenario(const char* name, const char* title, const char* help, double damping, double friction,
                         double torque) {
  return {{name, title, help},
          kPendulum,
          {{"environment.damping", damping}, {"environment.friction", friction}, {"environment.torque_scale", torque}}};
}

/// With the learning parameters that suit it; those of the thesis are the pendulum's.
AssignmentEntry compassPreset(const char* name, const char* title, const char* help, double slope) {
  AssignmentEntry entry{{name, title, help}, "compass", {{"environment.slope", slope}}};
  for (const std::string estimate : {"agent.", "positive.", "negative."}) {
    entry.values.push_back({estimate + "step_size", 0.3});
    entry.values.push_back({estimate + "trace_decay", 0.95});
  }
  for (const std::string features : {"features.", "positive.", "negative."})
    entry.values.push_back({features + "initial_high", 0.01});
  entry.values.push_back({"agent.discount", 0.99});
  return entry;
}

}  // namespace

void registerPhysics(Registry& r) {
  r.environments.push_back({{kPendulum, "Pendulum", "The thesis's inverted pendulum on a cart, in Box2D."},
                            [] { return std::make_unique<Pendulum>(); }});

  r.environments.push_back(
      {{"compass", "Compass walker", "Two straight legs and a hip: the simplest thing that walks."},
       [] { return std::make_unique<Compass>(); }});
  r.presets.push_back(compassPreset("level", "Level floor", "Learns to walk within a few simulated minutes.", 0.0));
  r.presets.push_back(compassPreset("uphill", "Uphill", "A floor that rises by 2 %: harder.", -0.02));

  r.presets.push_back(
      {{"thesis", "Thesis", "Constants calibrated to the episode lengths that the thesis reports."}, kPendulum, {}});
  r.presets.push_back({{"lab", "Delft lab file", "Constants of the same laboratory's published simulation."},
                       kPendulum,
                       {{"environment.pole_length", 0.4},
                        {"environment.pole_mass", 0.1},
                        {"environment.base_mass", 2.0},
                        {"environment.start_angle", 0.025 * std::numbers::pi},
                        {"environment.wheel_span", 2.0 * std::numbers::pi}}});

  r.scenarios.push_back(scenario("actual", "Actual system", "What the robot is meant to be.", 0.08, 0.0, 1.0));
  r.scenarios.push_back(scenario("1", "1 Realistic", "10 % more damping, a little friction.", 0.088, 0.03, 1.0));
  r.scenarios.push_back(scenario("2", "2 Half damping", "Half the damping, low friction.", 0.04, 0.02, 1.0));
  r.scenarios.push_back(scenario("3", "3 High friction", "Low damping, high friction.", 0.01, 0.05, 1.0));
  r.scenarios.push_back(scenario("4", "4 More power", "Actions with increased power.", 0.08, 0.0, 2.5));
  r.scenarios.push_back(scenario("5", "5 Less power", "Actions with decreased power.", 0.08, 0.0, 0.5));
  r.scenarios.push_back(
      scenario("6", "6 Power + friction", "Increased power with the realistic errors of 1.", 0.088, 0.03, 2.5));
}

}  // namespace surefoot
