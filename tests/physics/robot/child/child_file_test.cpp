// SPDX-License-Identifier: GPL-3.0-or-later
// What a robot's file says of the program that moves it.
#include "physics/robot/inspection/inspection.h"
#include "tests/physics/robot/child/programs.h"
#include "tests/physics/robot/robot_files.h"

namespace surefoot {

namespace {

std::string withCommand(const std::string& before, const std::string& after, std::string text = kCliffFile) {
  text.replace(text.find("COMMAND"), 7, R"(["python3", "robot.py"])");
  const auto at = text.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return text.replace(at, before.size(), after);
}

std::string wrongOf(const std::string& text) {
  std::vector<Complaint> complaints;
  EXPECT_FALSE(readRobot(text, complaints));
  return complaints.empty() ? "" : complaintLine("f", complaints.front());
}

}  // namespace

TEST(ChildFile, IsComplainedOfWhereItIsWrong) {
  const auto expect = [](const std::string& before, const std::string& after, const std::string& words) {
    const std::string told = wrongOf(withCommand(before, after));
    EXPECT_NE(told.find(words), std::string::npos) << told;
  };
  expect("step_time = 1\n", "step_time = 1\ngravity = 9\n", "f:5:1: gravity: a robot has either a world of its own or");
  expect("[actuator.move]", "[body.b]\nmass = 1\ninertia = 1\n[actuator.move]", "body: a robot has either");
  expect(R"(["python3", "robot.py"])", R"("python3 robot.py")", "command: it takes a list of up to 32 words");
  expect(R"(["python3", "robot.py"])", "[]", "command: it takes a list");
  expect("child.terminated", "child.terminatd",
         "\"child\" has no \"terminatd\"; it has reward, terminated, truncated, "
         "column and row (did you mean terminated?)");
  expect("step_time = 1\n", "step_time = 1\nsends = [\"x\"]\n", "\"child\" has no \"column\"");
  expect("step_time = 1\n", "step_time = 1\nsends = [\"reward\"]\n", "\"reward\": it is sent already.");
  expect("levels = [0, 1, 2, 3]", "levels = [0, 1, 2, 3]\njoint = \"j\"", "there is no \"joint\" here");
  expect("child.reward != -100", "move.effort > 0", "\"move\" has no \"effort\"; it has u");
  std::string noCommand = kCliffFile;
  noCommand.replace(noCommand.find("command = COMMAND"), 17, "sends = [\"column\"]");
  EXPECT_NE(wrongOf(noCommand).find("sends: it belongs to a command."), std::string::npos);
}

TEST(ChildFile, NamesNumbersThatAreNoStates) {
  const std::string text = withCommand("step_time = 1\n", "step_time = 1\nsends = [\"column\", \"height\"]\n", [] {
    std::string all = kCliffFile;
    const std::string row = "key = \"row\"\n";
    return all.replace(all.find(row), row.size(), row + "value = \"2 * child.height + move.u\"\n");
  }());
  const auto spec = robotOf(text);
  ASSERT_TRUE(spec);
  EXPECT_EQ(helloText(*spec, 0.5),
            "surefoot child 1\nname cliff-child\nstep_time 0.5\nsends column height\nlevels move\nparameters \n");
}

// A program is told of its parameters when an episode begins: a reward that held at once would not be the program's.
TEST(ChildFile, ItsRewardsHoldFromTheNextEpisodeOn) {
  const std::string reward = "[[parameter]]\nkey = \"prize\"\nvalue = 1\nrange = [0, 9]\ngroup = \"rewards\"\n";
  const auto spec = robotOf(withCommand("[actuator.move]", reward + "[actuator.move]"));
  ASSERT_TRUE(spec);
  EXPECT_EQ(spec->parameters.front().when, When::NextEpisode);
  EXPECT_EQ(spec->parameters.front().group, Group::Rewards);
}

TEST(ChildFile, IsInspectedWhileItsProgramIsStartedAnewAndAgain) {
  const ProgramHouse house;
  const EnvironmentInspection found = house.file->inspect();
  EXPECT_EQ(found.unanswered, "");
  EXPECT_EQ(found.steps, 4000);
  EXPECT_EQ(found.states.front().seenLow, 0);
  EXPECT_FALSE(found.falls.empty());
  EXPECT_FALSE(found.drawing.shapes.empty());
  const ProgramHouse other(R"(["python3", "robot.py"])", kCliff, false);
  EXPECT_NE(other.file->inspect().unanswered.find("Nobody has allowed it"), std::string::npos);
}

TEST(ChildFile, ThePicturesPointsMoveWithTheNumbers) {
  std::string text = kCliffFile + R"(
[point.foot]
at = ["column", "row"]
[point.head]
at = ["column", "row + 1"]
[picture]
follow = "foot"
[[picture.line]]
from = "foot"
to = "head"
)";
  const ProgramHouse house;
  std::ofstream(house.folder.file("drawn.toml")) << withCommand("max_steps", "max_steps", text);
  const auto file = house.registry.files->open(house.folder.file("drawn.toml"));
  ASSERT_TRUE(file) << file.error().message;
  const auto robot = (*file)->entry.make();
  Random random(1);
  robot->reset(random);
  for (const Action move : {0, 3, 3}) robot->step(move);  // up, right, right
  Scene scene;
  robot->draw(robot->pose(), scene);
  EXPECT_EQ(scene.focus.x, 2);
  ASSERT_EQ(scene.shapes.size(), 1u);
  const auto& line = std::get<Polyline>(scene.shapes.front());
  EXPECT_EQ(line.points.at(1).x, 2);
  EXPECT_EQ(line.points.at(1).y, 2);
}

}  // namespace surefoot
