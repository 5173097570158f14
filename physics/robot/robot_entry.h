// SPDX-License-Identifier: GPL-3.0-or-later
// A robot from a file among the things that can be chosen by name.
#pragma once

#include <memory>
#include <string>

#include "core/environment_library.h"
#include "physics/robot/child/child_robot.h"
#include "physics/robot/spec/robot_spec.h"

namespace surefoot {

/// What can be done with a robot besides living.
struct RobotTools {
  /// With a child if a program moves it.
  std::function<EnvironmentInspection(const std::shared_ptr<const RobotSpec>&, std::unique_ptr<ChildRobot>)> inspect;
  std::function<std::shared_ptr<const RobotSpec>(const RobotSpec&)> passive, dropped;
  /// Every parameter of learning on a task, whichever rule learns.
  std::function<Parameters(const Task&)> parameters{};
};

/// The robot as an environment of this name. Its first preset is "as-built", which holds what [learning] says, unless
/// a preset of the file changes nothing itself; every other preset holds [learning], too. Scenarios likewise.
EnvironmentFile robotEntry(const std::string& name, std::shared_ptr<const RobotSpec> spec);

/// Reads a robot's text and checks all of it. It gets the name "hopper@3f2a91c0", which counts the files of its command
/// that lie in `folder`, too.
std::optional<EnvironmentFile> readRobotEntry(std::string_view text, const std::string& folder,
                                              std::vector<Complaint>& complaints, const RobotTools& tools,
                                              const std::shared_ptr<const EnvironmentPrograms>& programs);

/// A robot that comes with the program: by its own name.
void addRobot(Registry& registry, EnvironmentFile robot);

}  // namespace surefoot
