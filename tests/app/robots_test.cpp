// SPDX-License-Identifier: GPL-3.0-or-later
// Robots from files on the command line.
#include "tests/app/program.h"

namespace surefoot {

namespace {

const std::string kRobotFolder = std::string(SUREFOOT_SOURCE) + "/resources/robots/";

}  // namespace

TEST(RobotsCommand, CheckTellsRangesEnergyAndWhatIsDoubtful) {
  const Finished run = surefoot("check " + kRobotFolder + "hopper.toml");
  EXPECT_EQ(run.code, 0);
  for (const char* words : {"Hopper, 3 bodies, 2 joints, 7 state variables, 10 actions", "leg_angle", "endings: fall",
                            "loses", "(soft)", "scale = 10"})
    EXPECT_NE(run.out.find(words), std::string::npos) << words << run.out;
  const auto json = nlohmann::json::parse(surefoot("check " + kRobotFolder + "acrobot.toml --json").out);
  EXPECT_EQ(json["states"].size(), 4u);
  EXPECT_GT(json["loss_a_second"].get<double>(), json["loss_a_second_halved"].get<double>());
  EXPECT_TRUE(json["errors"].empty());
}

TEST(RobotsCommand, NewWritesARobotOfAnotherNameThatIsRight) {
  const Folder folder;
  const std::string file = folder.file("roller.toml"), roller = folder.file("roller");
  const Finished run = surefoot("new " + roller + " --like segway");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("surefoot check " + file), std::string::npos);
  const Finished check = surefoot("check " + file);
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_TRUE(check.out.starts_with(file + ": Roller, 2 bodies")) << check.out;
  EXPECT_EQ(surefoot("new " + roller).code, 3) << "it would be written over";
  EXPECT_EQ(surefoot("new Roller").code, 2);
  const Finished none = surefoot("new " + folder.file("other") + " --like segwy");
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("did you mean segway"), std::string::npos) << none.err;
}

TEST(RobotsCommand, AFileStandsWhereAnEnvironmentStands) {
  const Folder folder;
  const std::string file = folder.file("roller.toml");
  ASSERT_EQ(surefoot("new " + folder.file("roller") + " --like pendulum-file").code, 0);
  const std::string q = folder.file("q.safetensors"), journal = folder.file("j.jsonl");
  const auto result = run("train --environment " + file + " --minutes 0.5 --save " + q + " --journal " + journal);
  const std::string name = result["configuration"]["environment"];
  EXPECT_TRUE(name.starts_with("roller@")) << name;
  // Its text travels in the files: they can be used where the robot is not.
  ASSERT_EQ(std::remove(file.c_str()), 0);
  EXPECT_EQ(surefoot("replay " + journal + " --verify").code, 0);
  EXPECT_EQ(surefoot("query " + q + " --state '0;0;0'").code, 0);
  EXPECT_EQ(surefoot("train --load " + q + " --minutes 0.1").code, 0);
  const Finished gone = surefoot("train --environment " + file + " --minutes 0.1");
  EXPECT_EQ(gone.code, 3);
  EXPECT_NE(gone.err.find("roller.toml"), std::string::npos);
}

TEST(RobotsCommand, WhatWasLearnedGoesOnOnAnotherModelOfTheRobotButOnNoOtherRobot) {
  const Folder folder;
  const std::string file = folder.file("roller.toml"), q = folder.file("q.safetensors");
  ASSERT_EQ(surefoot("new " + folder.file("roller") + " --like pendulum-file").code, 0);
  run("train --environment " + file + " --minutes 0.5 --save " + q);
  const std::string text = contentOf(file);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    std::ofstream(file) << changed;
  };
  const std::string load = "train --load " + q + " --environment " + file + " --minutes 0.1";
  with("step_time", "# a comment makes no other robot\nstep_time");
  EXPECT_EQ(surefoot(load).err, "");
  with("wheel_mass = 0.5", "wheel_mass = 0.6");
  const Finished heavier = surefoot(load);
  EXPECT_EQ(heavier.code, 0) << heavier.err;
  EXPECT_NE(heavier.err.find("learned on roller@"), std::string::npos) << heavier.err;
  with("levels = [-1.5, -0.75, 0, 0.75, 1.5]", "levels = [-1.5, -0.5, 0, 0.5, 1.5]");
  expectRefusal(load, 3, {"-0.75", "-0.5", "in the configuration"});
  with("unit = \"rad/s\"", "unit = \"°/s\"");
  expectRefusal(load, 3, {"another robot", "the unit of pole_rate"});
  const std::string other = "train --load " + q + " --environment pendulum --minutes 0.1";
  expectRefusal(other, 3, {"learned with --environment roller@"});
  const Finished asked = surefoot(other + " --load-from-other");
  EXPECT_EQ(asked.code, 0) << asked.err;
  EXPECT_NE(asked.err.find("goes on on pendulum"), std::string::npos) << asked.err;
}

TEST(RobotsCommand, WhatIsWrongIsToldWithItsPlace) {
  const Folder folder;
  const std::string file = folder.file("roller.toml");
  ASSERT_EQ(surefoot("new " + folder.file("roller") + " --like pendulum-file").code, 0);
  std::string text = contentOf(file);
  text.replace(text.find("-pole.angle"), 11, "-pole.angel");
  text.replace(text.find("[\"base\", \"pole\"]"), 16, "[\"base\", \"pol\"]");
  std::ofstream(file) << text;
  const Finished check = surefoot("check " + file);
  EXPECT_EQ(check.code, 3);
  EXPECT_NE(check.err.find("roller.toml:128:20: there is no body \"pol\""), std::string::npos) << check.err;
  EXPECT_NE(check.err.find("roller.toml:151:11: value: \"pole\" has no \"angel\""), std::string::npos) << check.err;
  const Finished train = surefoot("train --environment " + file + " --minutes 1");
  EXPECT_EQ(train.code, 3);
  EXPECT_NE(train.err.find("There are more: surefoot check " + file), std::string::npos) << train.err;
}

TEST(RobotsCommand, AFileWithoutItsEndingIsProposed) {
  const Folder folder;
  std::filesystem::copy(kRobotFolder + "ball-beam.toml", folder.file("wobbly.toml"));
  const std::string file = folder.file("wobbly");
  expectRefusal("check " + file, 3, {"there is no " + file + ", but a file " + file + ".toml."});
  expectRefusal("train --minutes 1 --environment " + file, 3, {"but a file " + file + ".toml."});
}

TEST(RobotsCommand, AProgramIsStartedOnlyWhereThatIsAllowed) {
  const Folder folder;
  std::filesystem::copy(kRobotFolder + "child", folder.file("child"));
  const std::string car = folder.file("child/car.toml");
  expectRefusal("check " + car, 6,
                {"starts a program, python3 car.py", "Nobody has allowed it yet", "--allow-programs"});
  const Finished refused = surefoot("train --environment " + car + " --episodes 3");
  EXPECT_EQ(refused.code, 6);
  EXPECT_NE(refused.err.find("Nobody has allowed it yet"), std::string::npos) << refused.err;
  const Finished check = surefoot("check --allow-programs " + car);
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_NE(check.out.find("moved by python3 car.py, 2 state variables, 3 actions"), std::string::npos) << check.out;
}

TEST(RobotsCommand, AProgramsLifeGoesOnWhereItsFileLies) {
  const Folder folder;
  std::filesystem::copy(kRobotFolder + "child", folder.file("child"));
  const std::string train = "--allow-programs --environment " + folder.file("child/car.toml");
  const std::string checkpoint = folder.file("c.safetensors");
  const std::string whole = hashOf(train + " --episodes 20");
  hashOf(train + " --episodes 10 --checkpoint " + checkpoint);
  const std::string on = "train --resume " + checkpoint + " --episodes 20";
  expectRefusal(on, 6, {"Nobody has allowed it yet"});
  const auto life = run(on + " --allow-programs")["lives"][0];
  EXPECT_EQ(life["hash"], whole);
  EXPECT_EQ(life["same_bits"], "machine");
  std::ofstream(folder.file("child/car.py"), std::ios::app) << "# another program\n";
  expectRefusal(on + " --allow-programs", 3, {"the program of its robot was another one", "--other-version"});
  EXPECT_EQ(run(on + " --allow-programs --other-version")["lives"][0]["hash"], whole);
}

// glibc has sin, exp and pow in several versions, chosen by what the processor can do; none of them may be in a life.
TEST(RobotsCommand, LivesHaveTheSameBitsOnAProcessorWithoutFmaAndAvx2) {
  constexpr int kSteps = 4000;
  for (const auto& entry : std::filesystem::directory_iterator(kRobotFolder)) {
    if (entry.path().extension() != ".toml") continue;
    const std::string text = contentOf(entry.path().string()), key = "\nstep_time = ";
    const std::string value = text.substr(text.find(key) + key.size());
    const double stepTime = value.starts_with('"') ? 1.0 / 30 : std::stod(value);  // LEO's is an expression
    const std::string life = "--environment " + entry.path().string() + " --set policy.epsilon=1 --seed 3 --minutes " +
                             std::to_string(kSteps * stepTime / 60);
    const std::string here = hashOf(life);
    ASSERT_EQ(setenv("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX,-AVX512F,-AVX512VL", 1), 0);
    EXPECT_EQ(hashOf(life), here) << entry.path();
    ASSERT_EQ(unsetenv("GLIBC_TUNABLES"), 0);
  }
}

TEST(RobotsCommand, ALessonIsAboutARobotWhoseFileLiesBesideIt) {
  const Folder folder;
  std::string lesson = contentOf(std::string(SUREFOOT_SOURCE) + "/resources/lessons/01-why-does-it-fall.toml");
  const std::string compiled = "environment = \"pendulum\"";
  ASSERT_NE(lesson.find(compiled), std::string::npos);
  lesson.replace(lesson.find(compiled), compiled.size(), "environment = \"pendulum-file.toml\"");
  std::ofstream(folder.file("01-mine.toml")) << lesson;
  std::filesystem::copy(kRobotFolder + "pendulum-file.toml", folder.file("pendulum-file.toml"));
  const Finished check = surefoot("lessons check " + folder.file("01-mine.toml"));
  EXPECT_EQ(check.code, 0) << check.out << check.err;
}

}  // namespace surefoot
