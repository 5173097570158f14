// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program.h"

namespace surefoot {

namespace {

const char* const kLesson =
    "title = \"Falls\"\ngoal = \"Say what ε does.\"\n[start]\nenvironment = \"cliff\"\nfeatures = \"table\"\nseed = 1\n"
    "[[step]]\ntitle = \"s\"\nsay = \"Look.\"\n"
    "predict = {kind = \"number\", question = \"?\", low = 0, high = 500, of = \"falls\", after = \"100 episodes\"}\n"
    "[[step]]\ntitle = \"s\"\nsay = \"Make it fall twice as often.\"\ntask = \"t\"\ndone = \"episodes >= 100 and falls "
    ">= 2 * observed(1)\"\n"
    "solution = [{set = \"policy.epsilon = 0.5\"}, {restart = true}, {run = \"100 episodes\"}]\n";

}  // namespace

class LessonsCommand : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.file(name)) << text;
    return folder_.file(name);
  }
  Folder folder_;
};

TEST_F(LessonsCommand, AGoodLessonIsWell) {
  const Finished run = surefoot("lessons check " + write("good.toml", kLesson));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("well, 2 steps lived through"), std::string::npos) << run.out;
}

TEST_F(LessonsCommand, WhatIsWrongIsToldWithItsPlaceAndAnExitCode) {
  std::string text = kLesson;
  text.replace(text.find("falls >= 2"), 10, "fals  >= 2");
  std::string lived = kLesson;
  lived.replace(lived.find("epsilon = 0.5"), 13, "epsilon = 0.0");
  const Finished run = surefoot("lessons check " + write("bad.toml", text) + " " + write("lived.toml", lived));
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.out.find("bad.toml, line 15, column 29: done: there is no \"fals\"; did you mean falls."),
            std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("lived.toml, line 11"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("its solution does not do the task"), std::string::npos) << run.out;
  EXPECT_NE(run.err.find("2 of 2 need mending"), std::string::npos) << run.err;
}

TEST_F(LessonsCommand, WhatAStudentReadsIsPrinted) {
  const Finished run = surefoot("lessons check --show " + write("good.toml", kLesson));
  EXPECT_NE(run.out.find("1. s (predict)\nLook.\n  observed: "), std::string::npos) << run.out;
}

TEST_F(LessonsCommand, TheProgramsLessonsAreListed) {
  const Finished run = surefoot("lessons");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("5 Exploring costs falls"), std::string::npos) << run.out;
}

TEST_F(LessonsCommand, WhatItTakesIsTold) {
  const Finished run = surefoot("lessons chekc a.toml");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("surefoot lessons check FILE"), std::string::npos) << run.err;
  EXPECT_EQ(surefoot("lessons check " + folder_.file("none.toml")).code, 3);
}

}  // namespace surefoot
