// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/register.h"

#include <numbers>

#include "core/environment_programs.h"
#include "physics/compass/compass.h"
#include "physics/leo/leo.h"
#include "physics/pendulum/pendulum.h"
#include "physics/robot/inspection/inspection.h"
#include "physics/robot/inspection/passive.h"
#include "physics/robot/robot_entry.h"

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

/// A preset with learning parameters that suit the compass walker; the thesis's values are for the pendulum.
AssignmentEntry compassPreset(const char* name, const char* title, const char* help, double slope) {
  AssignmentEntry entry{{name, title, help}, "compass", {{"environment.slope", slope}}};
  for (const std::string estimate : {"agent.", "positive.", "negative.", "risk."}) {
    entry.values.push_back({estimate + "step_size", 0.3});
    entry.values.push_back({estimate + "trace_decay", 0.95});
  }
  for (const std::string features : {"features.", "positive.", "negative."})
    entry.values.push_back({features + "initial_high", 0.01});
  entry.values.push_back({"agent.discount", 0.99});
  return entry;
}

using Values = std::vector<std::pair<std::string, double>>;

/// Adds the value for every estimate that a learning rule may have.
void addForEstimates(Values& values, const std::string& key, double value) {
  for (const char* estimate : {"agent.", "positive.", "negative.", "risk."}) values.push_back({estimate + key, value});
}
void addForFeatures(Values& values, const std::string& key, double value) {
  for (const char* features : {"features.", "positive.", "negative."}) values.push_back({features + key, value});
}

/// A preset with the learning parameters of wcaarls/grl's walker.
AssignmentEntry leoPreset(const char* name, const char* title, const char* help, const Values& changes) {
  AssignmentEntry entry{{name, title, help}, "leo", changes};
  addForEstimates(entry.values, "step_size", 0.2);
  addForEstimates(entry.values, "trace_decay", 0.8582);
  addForFeatures(entry.values, "initial_high", 0.01);
  addForFeatures(entry.values, "memory", 1 << 18);
  entry.values.push_back({"risk.memory", 1 << 18});
  entry.values.push_back({"risk.discount", 0.95});  // it falls in the end, always: two thirds of a second count
  entry.values.push_back({"agent.discount", 0.9962});
  return entry;
}

}  // namespace

void registerPhysics(Registry& r) {
  r.programs = std::make_shared<EnvironmentPrograms>();
  const auto parameters = [agents = r.agents, policies = r.policies](const Task& task) {
    Parameters all;
    for (const PolicyEntry& policy : policies) all.add(*policy.make(), "policy.");
    for (const AgentEntry& agent : agents)
      for (const char* features : {"tile-coder", "radial-basis"})
        static_cast<void>(static_cast<bool>(agent.declare(task, features, all)));
    return all;
  };
  const RobotTools tools = {inspectRobot, [](const RobotSpec& spec) { return passiveRobot(spec, 1); }, droppedRobot,
                            parameters};
  r.files = std::make_shared<EnvironmentLibrary>([tools, programs = r.programs](std::string_view text,
                                                                                const std::string& folder,
                                                                                std::vector<Complaint>& complaints) {
    return readRobotEntry(text, folder, complaints, tools, programs);
  });
  r.environments.push_back({{kPendulum, "Pendulum", "The thesis's inverted pendulum on a cart, in Box2D."},
                            [] { return std::make_unique<Pendulum>(); }});

  r.environments.push_back(
      {{"compass", "Compass walker", "Two straight legs and a hip: the simplest thing that walks."},
       [] { return std::make_unique<Compass>(); }});
  r.environments.push_back(
      {{"leo", "LEO walker", "The Delft robot on two legs, in Box2D."}, [] { return std::make_unique<Leo>(); }});
  r.presets.push_back(leoPreset("leo", "LEO", "The robot with motors of 8.6 Ω.", {}));
  r.presets.push_back(leoPreset("mismatched", "Mismatched LEO", "Another motor: 9.5 Ω, and more dry friction.",
                                {{"environment.resistance", 9.5}, {"environment.dry_friction", 0.27046}}));
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

  r.scenarios.push_back(
      scenario("actual", "Pendulum, actual system", "What the robot is meant to be.", 0.08, 0.0, 1.0));
  r.scenarios.push_back(scenario("1", "1 Realistic", "10 % more damping, a little friction.", 0.088, 0.03, 1.0));
  r.scenarios.push_back(
      scenario("2", "2 Half damping, low friction", "Half the damping, low friction.", 0.04, 0.02, 1.0));
  r.scenarios.push_back(scenario("3", "3 Low damping, high friction", "Low damping, high friction.", 0.01, 0.05, 1.0));
  r.scenarios.push_back(scenario("4", "4 More power", "Actions with increased power.", 0.08, 0.0, 2.5));
  r.scenarios.push_back(scenario("5", "5 Less power", "Actions with decreased power.", 0.08, 0.0, 0.5));
  r.scenarios.push_back(
      scenario("6", "6 Power + friction", "Increased power with the realistic errors of 1.", 0.088, 0.03, 2.5));
}

}  // namespace surefoot
