// SPDX-License-Identifier: GPL-3.0-or-later
// Robots for tests: the files that come with the program, and texts.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include "core/experiment/configuration.h"
#include "physics/robot/reading/robot_reading.h"
#include "physics/robot/robot.h"
#include "physics/robot/robot_entry.h"
#include "tests/full_registry.h"

namespace surefoot {

inline std::string textOfFile(const std::string& path) {
  std::ifstream in(path);
  EXPECT_TRUE(in) << path;
  std::stringstream all;
  all << in.rdbuf();
  return all.str();
}

/// Robots that are compiled in, too, have another name as a file.
inline std::string fileOf(const std::string& name) {
  return name == "pendulum" || name == "compass" || name == "leo" ? name + "-file" : name;
}

inline std::string robotText(const std::string& name) {
  return textOfFile(std::string(SUREFOOT_SOURCE) + "/resources/robots/" + fileOf(name) + ".toml");
}

/// The robot of a text that is right.
inline std::shared_ptr<const RobotSpec> robotOf(const std::string& text) {
  std::vector<Complaint> complaints;
  auto spec = readRobot(text, complaints);
  for (const Complaint& c : complaints) ADD_FAILURE() << complaintLine("text", c);
  if (!spec) return nullptr;
  for (const Complaint& c : checkRobot(*spec)) ADD_FAILURE() << complaintLine("text", c);
  return spec;
}

inline Registry registryWith(const std::string& robot) {
  Registry registry = fullRegistry();
  auto spec = robotOf(robotText(robot));
  if (spec) addRobot(registry, robotEntry(spec->name, spec));
  return registry;
}

}  // namespace surefoot
