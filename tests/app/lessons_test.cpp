// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program.h"
#include "tests/core/lessons/taught.h"

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

// Thirty hand-ins, two of them edited and one damaged: the table is right, and those are told.
TEST_F(LessonsCommand, GradesLiveEveryHandInAgain) {
  write("05-taught.toml", kTaught);
  for (int i = 1; i <= 30; ++i) {
    const std::string student = "Student " + std::to_string(i);
    std::string text = handedIn(student, i % 3 == 0);
    const auto edit = [&](const std::string& from, const std::string& to) {
      ASSERT_NE(text.find(from), std::string::npos) << from;
      text.replace(text.find(from), from.size(), to);
    };
    if (i == 7) edit("\"value\":40", "\"value\":57");
    if (i == 12) edit("\"right\":false", "\"right\":true");
    if (i == 20) text.resize(text.size() / 2);
    write(student + " taught.jsonl", text);
  }
  const Finished run = surefoot("lessons grade " + folder_.file("") + " --out " + folder_.file("grades.csv"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("30 hand-ins, 3 to be looked at"), std::string::npos) << run.out;
  std::istringstream table(contentOf(folder_.file("grades.csv")));
  std::string line;
  std::getline(table, line);
  EXPECT_TRUE(line.starts_with("student,lesson,finished,")) << line;
  int lines = 0;
  while (std::getline(table, line)) {
    ++lines;
    const int i = std::stoi(line.substr(8));
    if (i == 7 || i == 12) {
      EXPECT_NE(line.find("edited: line "), std::string::npos) << line;
    } else if (i == 20) {
      EXPECT_NE(line.find("damaged: line "), std::string::npos) << line;
    } else {
      EXPECT_NE(line.find(i % 3 == 0 ? ",yes,5,5,2,1,2,1,1,1," : ",yes,5,5,2,2,2,1,1,1,"), std::string::npos) << line;
      EXPECT_TRUE(line.ends_with(",yes,")) << line << " was lived again and came out";
    }
  }
  EXPECT_EQ(lines, 30);
  EXPECT_EQ(surefoot("lessons grade " + folder_.file("") + " --out " + folder_.file("grades.csv")).code, 3)
      << "what is there is not written over";
  EXPECT_EQ(surefoot("lessons grade " + folder_.file("nowhere")).code, 3);
}

TEST_F(LessonsCommand, AHandOutIsAPdf) {
  write("05-taught.toml", kTaught);
  for (const char* solutions : {"", " --solutions"}) {
    const std::string pdf = folder_.file(std::string("a") + (*solutions ? "s" : "") + ".pdf");
    const Finished run = surefoot("lessons handout " + folder_.file("05-taught.toml") + " --out " + pdf + solutions);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(contentOf(pdf).starts_with("%PDF")) << pdf;
  }
  EXPECT_EQ(surefoot("lessons handout nothing --out " + folder_.file("b.pdf")).code, 2);
}

TEST_F(LessonsCommand, TheWindowsOptionsAreChecked) {
  expectRefusal("window --student Ada --class " + folder_.file("none"), 3, {"there is no folder"});
  expectRefusal("window --class " + folder_.file(""), 2, {"--student"});
  expectRefusal("window --student ../x --class " + folder_.file(""), 2, {"../x"});
  expectRefusal("window --lesson a --kiosk b", 2, {"exclude each other"});
  expectRefusal("window --reset-after 5", 2, {"--kiosk"});
}

}  // namespace surefoot
