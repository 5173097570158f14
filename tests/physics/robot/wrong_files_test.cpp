// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of files that are wrong: each is the pendulum with one change.
#include "core/experiment/configuration.h"
#include "core/files/whole_file.h"
#include "tests/folder.h"
#include "tests/full_registry.h"
#include "tests/physics/robot/robot_files.h"

namespace surefoot {

namespace {

struct WrongFile {
  const char *from, *to;
  const char* complaint;  ///< "line:column: sentence"
};

std::string firstComplaint(const std::string& text) {
  std::vector<Complaint> complaints;
  const auto spec = readRobot(text, complaints);
  if (spec) complaints = checkRobot(*spec);
  return complaints.empty() ? "" : complaintLine("p", complaints.front());
}

/// The pendulum with one place changed, and the line of this place.
std::string changed(const std::string& from, const std::string& to, int& line) {
  std::string text = robotText("pendulum");
  const auto at = text.find(from);
  if (at == std::string::npos) return ADD_FAILURE() << from, text;
  line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  return text.replace(at, from.size(), to);
}

std::string deep(int levels) {
  std::string text = "1";
  for (int i = 0; i < levels; ++i) text = "1+(1*" + text + ")";
  return "when = \"" + text + "\"";
}

}  // namespace

TEST(WrongRobots, TellThePlaceAndTheReason) {
  const char* when = "when = \"abs(pole_angle) >= fall_angle\"";
  const std::string nested = deep(100);
  const std::vector<WrongFile> files = {
      {"\nmass = \"pole_mass\"", "\nmas = \"pole_mass\"", "+1:1: there is no \"mas\" here; did you mean mass."},
      {"M_e + pole_mass", "M_e + pole_mas", ":14: M_t: there is no \"pole_mas\"; did you mean pole_mass."},
      {"base.vx / R\"\nrange", "bse.vx / R\"\nrange",
       ":10: value: there is no body, point, joint, shape or actuator \"bse\" (did you mean base?)."},
      {"-pole.angle", "-pole.angel",
       ":11: value: \"pole\" has no \"angel\"; it has x, y, angle, vx, vy, rate, height and touches (did you mean "
       "angle?)."},
      {"[\"base\", \"pole\"]", "[\"base\", \"pol\"]", ":20: there is no body \"pol\" (did you mean pole?)."},
      {"mass = \"pole_mass\"", "mass = \"pole.angle\"",
       ":9: mass: \"pole.angle\" changes while the robot moves; here only parameters and constants can stand."},
      {"value = \"-pole.angle\"", "value = \"-pole.angle + uniform(0,1)\"", ":24: value: there is no chance here."},
      {when, "when = \"0 <= pole_angle <= fall_angle\"", ":25: when: comparisons do not chain; write a < b and b < c."},
      {when, "when = \"pole_angle = 1\"", ":20: when: compare with ==."},
      {when, "when = \"abs(pole_angle >= fall_angle\"", ":37: when: the parenthesis of abs… is not closed."},
      {when, nested.c_str(), ":87: when: this is nested too deep."},
      {when, "when = \"system(\"rm\")\"",
       ":17: behind a value nothing but a comment is expected; a text that holds quotes goes between single quotes."},
      {"inertia_at_origin = \"pole_mass * pole_length * pole_length / 3\"", "",
       "-2:8: [body.pole] has a mass but no inertia [kg m²] about its centre; give it, or density, or rotates = "
       "false."},
      {"range = [-16, 16]", "range = [16, -16]", ":9: range: the lowest, 16, must be below the highest, -16."},
      {"value = 0.08", "value = 80", ":9: value: 80 lies outside its range 0 … 10."},
      {"on = \"goal\"", "on = \"gaol\"", ":6: there is no [[ending]] named \"gaol\" (did you mean goal?)."},
      {"mass = \"pole_mass\"", "mass = \"pole_mass * 1e300\"",
       ":8: [body.pole]: mass = 1e+300; allowed is 0.000001 … 1,000,000 kg."},
      {"step_time = 0.005", "test_every = 5\nstep_time = 0.005",
       ":1: test_every: a test of the greedy policy tells the robot's measures, and it has none; add a [[measure]], "
       "such as the distance."},
      {"step_time = 0.005", "step_time = \"5 ms\"",
       ":16: step_time: a sign is missing before \"ms\"; units are not written."},
      {"step_time = 0.005", "step_time = 0", ":13: step_time = 0; allowed is 0.00001 … 10 s."},
      {"1 / (R * (1 + 0.005", "1 / (R - R) * (R * (1 + 0.005",
       ":14: per_torque: it comes to inf, which is no finite number."},
      {"[body.pole]", "[body.pole", ":11: a heading stands in brackets, [body.leg] or [[state]]."},
      {"[joint.rail]", "[[joint]]", ":3: it is written [joint.NAME]."},
      {"\nheight = 0.25", "\nheight = \"-R\"", "+1:10: height = -0.05; allowed is 0.001 … 10000 m."},
      {"[point.tip]", "[point.pole]",
       ":8: there is another \"pole\" already; bodies, points, joints, actuators, "
       "states and constants share one space of names."},
      {"name = \"pendulum-file\"", "name = \"../up\"",
       ":8: name: a robot's name has letters a to z, digits and hyphens only, at most 40 (did you mean up?)."},
      {"value = \"-pole.angle\"", "value = \"30deg\"", ":12: value: angles are in rad: 30 degrees are 30 * pi / 180."},
      {"value = \"-pole.angle\"", "value = \"fabs(-pole.angle)\"",
       ":10: value: there is no function \"fabs\"; there are abs, min, max, sign, floor, round, sqrt, sin, cos, exp, "
       "square, "
       "clamp, wrap, hypot and uniform (did you mean abs?)."},
  };
  for (const WrongFile& file : files) {
    int line = 0;
    const std::string text = changed(file.from, file.to, line);
    std::string wanted = file.complaint;
    if (wanted[0] == '+' || wanted[0] == '-') {
      const auto colon = wanted.find(':');
      line += std::stoi(wanted.substr(0, colon));
      wanted = wanted.substr(colon);
    }
    EXPECT_EQ(firstComplaint(text), "p:" + std::to_string(line) + wanted);
  }
}

/// The first complaint about the pendulum's file with some lines behind it.
std::string firstWith(const std::string& lines) {
  return firstComplaint(robotText("pendulum") + lines);
}

TEST(WrongRobots, AHeadingThatIsThereAlreadyIsTold) {
  EXPECT_NE(firstWith("[body.pole]\nmass = 1\n").find("[body.pole] stands in line "), std::string::npos);
  EXPECT_NE(firstWith("[state]\nkey = \"x\"\n").find(" says [[state]]; write [[state]] for each of several."),
            std::string::npos);
}

TEST(WrongRobots, NamesOfTheLearnersOwnRewardsAreRefused) {
  const std::string reward = "\n[[reward]]\nname = \"price_of_fall\"\nvalue = \"-1\"\n";
  EXPECT_NE(firstWith(reward).find("price_of_fall is what the learner calls a reward of its own."), std::string::npos)
      << firstWith(reward);
}

TEST(WrongRobots, AListThatIsNotClosedIsTold) {
  const std::string told = firstWith("[view]\nlist = [1,\nother = 3\n");
  EXPECT_NE(told.find("is not closed."), std::string::npos) << told;
}

// As many lines as a robot's file may have: what is before a mistake is looked through once, not once a line.
TEST(WrongRobots, AMistakeBehindManyLinesIsToldAtOnce) {
  const std::string told = firstComplaint("[view]\nlist = [1\n" + std::string(250'000, '\n') + "other = = 3\n");
  EXPECT_NE(told.find("the [ of line 2 is not closed."), std::string::npos) << told;
}

TEST(WrongRobots, WhatLearningCannotHaveIsToldInItsLine) {
  const Folder folder;
  const std::string file = folder.file("learning.toml");
  ASSERT_TRUE(writeWhole("robot", file, robotText("pendulum") + "[learning]\ndiscount = 97\n"));
  const Registry registry = fullRegistry();
  const auto c = configure(registry, {.environment = file}, {});
  ASSERT_FALSE(c);
  EXPECT_NE(c.error().message.find("agent.discount: 97 is not allowed"), std::string::npos) << c.error().message;
  EXPECT_NE(c.error().message.find("learning.toml:"), std::string::npos) << c.error().message;
}

TEST(WrongRobots, HaveAtMostTwentyComplaintsInTheOrderOfTheFile) {
  std::string text = robotText("pendulum");
  for (std::size_t at = 0; (at = text.find("help =", at)) != std::string::npos;) text.replace(at, 4, "hlep");
  for (std::size_t at = 0; (at = text.find("order =", at)) != std::string::npos;) text.replace(at, 5, "orded");
  for (std::size_t at = 0; (at = text.find("unit =", at)) != std::string::npos;) text.replace(at, 4, "unti");
  std::vector<Complaint> complaints;
  EXPECT_FALSE(readRobot(text, complaints));
  ASSERT_EQ(complaints.size(), kMostComplaints);
  for (std::size_t i = 1; i < complaints.size(); ++i) EXPECT_LE(complaints[i - 1].at.line, complaints[i].at.line);
}

TEST(WrongRobots, AreToldUnderTheValuesThatAPersonChose) {
  Registry registry = fullRegistry();
  std::string text = robotText("pendulum");
  text.replace(text.find("range = [0.001, 100]"), 20, "range = [0, 100]");
  const auto file = registry.files->add(text, "p.toml");
  ASSERT_TRUE(file) << file.error().message;
  Names names;
  names.environment = (*file)->entry.name;
  const auto heavy = configure(registry, names, {});
  ASSERT_TRUE(heavy);
  EXPECT_TRUE(makeEnvironment(registry, *heavy));
  const auto none = configure(registry, names, {{"environment.pole_mass", "0"}});
  ASSERT_TRUE(none);
  const auto made = makeEnvironment(registry, *none);
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().message.find("mass = 0; allowed is"), std::string::npos) << made.error().message;
}

}  // namespace surefoot
