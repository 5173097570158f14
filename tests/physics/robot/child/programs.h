// SPDX-License-Identifier: GPL-3.0-or-later
// Robots that programs move, written for a test into a folder of their own.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/environment_library.h"
#include "core/environment_programs.h"
#include "core/experiment/configuration.h"
#include "physics/robot/child/child_robot.h"
#include "tests/folder.h"
#include "tests/full_registry.h"

namespace surefoot {

/// A walk over the cells of the cliff (Sutton & Barto, example 6.6), as core/environments/cliff.cpp has it.
inline const std::string kCliff = R"(
import surefoot_child
class Cliff:
    def reset(self, random, parameters):
        self.at = [0, 0]
        return self.at
    def step(self, levels):
        right, up = [(0, 1), (0, -1), (-1, 0), (1, 0)][int(levels["move"])]
        self.at = [min(max(self.at[0] + right, 0), 11), min(max(self.at[1] + up, 0), 3)]
        fell = self.at[1] == 0 and 0 < self.at[0] < 11
        if fell:
            self.at = [0, 0]
        return self.at, -100 if fell else -1, self.at == [11, 0], False
surefoot_child.serve(Cliff())
)";

inline const std::string kCliffFile = R"(surefoot = "robot 1"
name = "cliff-child"
command = COMMAND
step_time = 1
max_steps = 100000
return = [-100, 0]
[actuator.move]
levels = [0, 1, 2, 3]
[[state]]
key = "column"
range = [0, 11]
resolution = 1
whole = true
[[state]]
key = "row"
range = [0, 3]
resolution = 1
whole = true
[[ending]]
kind = "goal"
when = "child.terminated"
[[event]]
kind = "fall"
when = "child.reward == -100"
[[reward]]
name = "time"
value = -1
when = "child.reward != -100"
[[reward]]
name = "fall"
value = -100
when = "child.reward == -100"
)";

/// A registry, and a folder with a robot and its program.
struct ProgramHouse {
  /// `command`: as in the file, ["python3", "robot.py"].
  explicit ProgramHouse(const std::string& command = R"(["python3", "robot.py"])", const std::string& program = kCliff,
                        bool allow = true)
      : registry(fullRegistry()) {
    registry.programs->setModules(std::string(SUREFOOT_SOURCE) + "/resources/robots/child");
    std::string text = kCliffFile;
    text.replace(text.find("COMMAND"), 7, command);
    std::ofstream(folder.file("robot.toml")) << text;
    std::ofstream(folder.file("robot.py")) << program;
    const auto opened = registry.files->open(folder.file("robot.toml"));
    EXPECT_TRUE(opened) << (opened ? "" : opened.error().message);
    if (!opened) return;
    file = *opened;
    if (allow) registry.programs->allow(file->program);
  }
  std::unique_ptr<ChildRobot> robot() const {
    auto made = file->entry.make();
    return std::unique_ptr<ChildRobot>(static_cast<ChildRobot*>(made.release()));
  }
  Configuration configuration(const std::string& environment) const {
    auto c = configure(registry, {.environment = environment, .agent = "sarsa", .features = "table"},
                       {{"policy.epsilon", "0.1"}, {"agent.step_size", "0.5"}});
    EXPECT_TRUE(c) << (c ? "" : c.error().message);
    return *c;
  }
  std::unique_ptr<Life> life(const std::string& environment = "") const {
    auto life = makeLife(registry, configuration(environment.empty() ? file->entry.name : environment), 0, false);
    EXPECT_TRUE(life) << (life ? "" : life.error().message);
    return life ? std::move(*life) : nullptr;
  }

  Folder folder;
  Registry registry;
  std::shared_ptr<const EnvironmentFile> file;
};

}  // namespace surefoot
