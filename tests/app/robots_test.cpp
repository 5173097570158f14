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
  for (const char* words : {"Hopper, 3 bodies, 2 joints, 7 state variables, 6 actions", "leg_angle", "endings: fall",
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
  ASSERT_EQ(surefoot("new " + folder.file("roller") + " --like pendulum").code, 0);
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

TEST(RobotsCommand, WhatIsWrongIsToldWithItsPlace) {
  const Folder folder;
  const std::string file = folder.file("roller.toml");
  ASSERT_EQ(surefoot("new " + folder.file("roller") + " --like pendulum").code, 0);
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

}  // namespace surefoot
