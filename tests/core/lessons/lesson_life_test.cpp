// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/lesson_life.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/lessons/lesson_reading.h"
#include "core/register/register.h"

namespace surefoot {

namespace {

const Registry& coreOnly() {
  static const Registry all = [] {
    Registry r;
    registerCore(r);
    return r;
  }();
  return all;
}

Lesson lessonOf(const std::string& steps) {
  std::vector<Complaint> complaints;
  auto lesson = readLesson(coreOnly(),
                           "title = \"a\"\ngoal = \"b\"\n[start]\nenvironment = \"cliff\"\nfeatures = \"table\"\n"
                           "seed = \"student\"\nset.policy.epsilon = 0.05\n" +
                               steps,
                           "a.toml", complaints);
  EXPECT_TRUE(lesson) << complaintText("a", complaints.empty() ? Complaint{} : complaints[0]);
  return lesson ? *lesson : Lesson{};
}

std::string whatGoesWrong(const std::string& steps) {
  std::string all;
  for (const Complaint& c : liveThrough(coreOnly(), lessonOf(steps), 7)) all += c.sentence + "\n";
  return all;
}

const char* const kPredicts =
    "[[step]]\nsay = \"a\"\n"
    "predict = {kind = \"number\", low = 0, high = 500, of = \"falls\", after = \"100 episodes\"}\n";

}  // namespace

// The same life as makeLife's with the same actions: its numbers are those of the program.
TEST(LessonLife, IsTheLifeThatAHandWouldLive) {
  const Lesson lesson = lessonOf(kPredicts);
  auto lived = LessonLife::begin(coreOnly(), lesson, 7);
  ASSERT_TRUE(lived);
  ASSERT_TRUE(lived->act({.kind = LessonAction::Kind::Run, .amount = {100, LessonAmount::Unit::Episodes}}));
  ASSERT_TRUE(lived->act({.kind = LessonAction::Kind::Set, .key = "policy.epsilon", .value = "0.5"}));
  ASSERT_TRUE(lived->act({.kind = LessonAction::Kind::Run, .amount = {1000, LessonAmount::Unit::Steps}}));
  Configuration c = lesson.start;
  c.seed = 7;
  auto life = makeLife(coreOnly(), c, 0, false);
  ASSERT_TRUE(life);
  while ((*life)->log().totals().episodes < 100) (*life)->step();
  ASSERT_TRUE((*life)->set("policy.epsilon", 0.5));
  for (int i = 0; i < 1000; ++i) (*life)->step();
  EXPECT_EQ(lived->life().hash(), (*life)->hash());
}

TEST(LessonLife, QuantitiesAreThoseOfTheLife) {
  const Lesson lesson = lessonOf(std::string(kPredicts) +
                                 "[[step]]\nsay = \"a\"\ndone = \"falls == before.falls and episodes == 3 and "
                                 "policy.epsilon == 0.05 and observed(1) == 12 and predicted(1) == 9 and q(\\\"up\\\") "
                                 "== q(\\\"up\\\") and probability(\\\"up\\\") >= 0 and visits >= 0 and steps > 0 and "
                                 "average_reward < 0\"\nsolution = [{restart = true}]\n");
  auto lived = LessonLife::begin(coreOnly(), lesson, 7);
  ASSERT_TRUE(lived);
  const LessonAction run{.kind = LessonAction::Kind::Run, .amount = {3, LessonAmount::Unit::Episodes}};
  ASSERT_TRUE(lived->act(run));
  ASSERT_TRUE(lived->act({.kind = LessonAction::Kind::Restart}));
  ASSERT_TRUE(lived->act(run));
  EXPECT_FALSE(lived->holds(*lesson.steps[1].done)) << "nothing was predicted or observed yet";
  lived->predict(0, 9), lived->observe(0, 12);
  EXPECT_TRUE(lived->holds(*lesson.steps[1].done)) << "the same seed falls as often again";
}

TEST(LessonLife, ASolutionIsAcceptedAndNothingElse) {
  const std::string task = "[[step]]\nsay = \"a\"\ndone = \"episodes >= 100 and falls >= 2 * observed(1)\"\n";
  EXPECT_EQ(whatGoesWrong(kPredicts + task +
                          "solution = [{set = \"policy.epsilon = 0.5\"}, {restart = true}, {run = \"100 episodes\"}]\n"
                          "par = \"policy.epsilon <= 0.5\"\n"),
            "");
  EXPECT_NE(whatGoesWrong(kPredicts + task + "solution = [{restart = true}, {run = \"100 episodes\"}]\n")
                .find("step 2: its solution does not do the task"),
            std::string::npos);
  EXPECT_NE(whatGoesWrong(kPredicts + task +
                          "solution = [{set = \"policy.epsilon = 0.5\"}, {restart = true}, {run = \"100 episodes\"}]\n"
                          "par = \"policy.epsilon <= 0.2\"\n")
                .find("does not keep the par"),
            std::string::npos);
  EXPECT_NE(whatGoesWrong("[[step]]\nsay = \"a\"\ndone = \"falls >= 0\"\nsolution = [{run = \"1 episode\"}]\n")
                .find("done before anything is done"),
            std::string::npos);
  EXPECT_NE(
      whatGoesWrong("[[step]]\nsay = \"a\"\npredict = {kind = \"number\", low = 0, high = 1, of = \"falls\", after "
                    "= \"100 episodes\"}\n")
          .find("outside 0 to 1"),
      std::string::npos);
}

TEST(LessonLife, ANewTableComesWithTheRestart) {
  const Lesson lesson = lessonOf("[[step]]\nsay = \"a\"\n");
  auto lived = LessonLife::begin(coreOnly(), lesson, 7);
  ASSERT_TRUE(lived);
  EXPECT_FALSE(lived->act({.kind = LessonAction::Kind::Set, .key = "policy.epsilon", .value = "5"}));
  EXPECT_FALSE(lived->act({.kind = LessonAction::Kind::Policy, .key = "policy", .value = "nobody"}));
  ASSERT_TRUE(lived->act({.kind = LessonAction::Kind::Policy, .key = "policy", .value = "softmax"}));
  EXPECT_EQ(lived->life().policyName(), "softmax");
  ASSERT_TRUE(lived->act({.kind = LessonAction::Kind::Restart}));
  EXPECT_EQ(lived->life().policyName(), "softmax");
}

}  // namespace surefoot
