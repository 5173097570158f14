// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/lesson_check.h"
#include "core/lessons/life_record.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/lessons/reading/lesson_reading.h"
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
    "[[step]]\ntitle = \"s\"\nsay = \"a\"\n"
    "predict = {kind = \"number\", question = \"?\", low = 0, high = 500, of = \"falls\", after = \"100 episodes\"}\n";

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

// What was done last is known to whoever takes the life over, also when it was placed somewhere since.
TEST(LessonLife, KnowsItsLastStep) {
  const Lesson lesson = lessonOf(kPredicts);
  auto lived = LessonLife::begin(coreOnly(), lesson, 7);
  ASSERT_TRUE(lived);
  ASSERT_TRUE(lived->act({.kind = LessonAction::Kind::Place, .state = {0, 1}}));
  const Action next = lived->life().nextAction();
  ASSERT_TRUE(lived->act({.kind = LessonAction::Kind::Run, .amount = {1, LessonAmount::Unit::Steps}}));
  ASSERT_TRUE(lived->act({.kind = LessonAction::Kind::Place, .state = {0, 2}}));
  const StepTaken last = lived->take().last;
  EXPECT_EQ(last.state, (std::vector<double>{0, 1}));
  EXPECT_EQ(last.action, next);
}

TEST(LessonLife, QuantitiesAreThoseOfTheLife) {
  const Lesson lesson = lessonOf(
      std::string(kPredicts) +
      "[[step]]\ntitle = \"s\"\nsay = \"a\"\ntask = \"t\"\ndone = \"falls == before.falls and episodes == 3 and "
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
  lived->values().predict(0, 9), lived->values().observe(0, 12);
  EXPECT_TRUE(lived->holds(*lesson.steps[1].done)) << "the same seed falls as often again";
}

TEST(LessonLife, ASolutionIsAcceptedAndNothingElse) {
  const std::string task =
      "[[step]]\ntitle = \"s\"\nsay = \"a\"\ntask = \"t\"\ndone = \"episodes >= 100 and falls >= 2 * observed(1)\"\n";
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
  EXPECT_NE(whatGoesWrong("[[step]]\ntitle = \"s\"\nsay = \"a\"\ntask = \"t\"\ndone = \"falls >= 0\"\nsolution = [{run "
                          "= \"1 episode\"}]\n")
                .find("done before anything is done"),
            std::string::npos);
  EXPECT_NE(whatGoesWrong("[[step]]\ntitle = \"s\"\nsay = \"a\"\npredict = {kind = \"number\", question = \"?\", low = "
                          "0, high = 1, of = \"falls\", after "
                          "= \"100 episodes\"}\n")
                .find("outside 0 to 1"),
            std::string::npos);
}

TEST(LessonLife, ANewTableComesWithTheRestart) {
  const Lesson lesson = lessonOf("[[step]]\ntitle = \"s\"\nsay = \"a\"\n");
  auto lived = LessonLife::begin(coreOnly(), lesson, 7);
  ASSERT_TRUE(lived);
  EXPECT_FALSE(lived->act({.kind = LessonAction::Kind::Set, .key = "policy.epsilon", .value = "5"}));
  EXPECT_FALSE(lived->act({.kind = LessonAction::Kind::Policy, .key = "policy", .value = "nobody"}));
  ASSERT_TRUE(lived->act({.kind = LessonAction::Kind::Policy, .key = "policy", .value = "softmax"}));
  EXPECT_EQ(lived->life().policyName(), "softmax");
  ASSERT_TRUE(lived->act({.kind = LessonAction::Kind::Restart}));
  EXPECT_EQ(lived->life().policyName(), "softmax");
}

TEST(LessonLife, AWrongWayThatDoesTheTaskIsTold) {
  const std::string task =
      "[[step]]\ntitle = \"s\"\nsay = \"a\"\ntask = \"t\"\ndone = \"episodes >= 10\"\nsolution = [{run = \"10 "
      "episodes\"}]\n";
  EXPECT_EQ(whatGoesWrong(task + "wrong = [{run = \"9 episodes\"}]\n"), "");
  EXPECT_NE(whatGoesWrong(task + "wrong = [{run = \"11 episodes\"}]\n").find("its wrong way does the task"),
            std::string::npos);
}

TEST(LessonLife, WhatATextSaysMustHold) {
  const std::string step =
      "[[step]]\ntitle = \"s\"\nsay = \"a\"\nrun = {for = \"10 episodes\"}\nexpect = [\"episodes == ";
  EXPECT_EQ(whatGoesWrong(step + "10\"]\n"), "");
  EXPECT_NE(whatGoesWrong(step + "11\"]\n").find("the text says what does not hold: episodes == 11."),
            std::string::npos);
}

TEST(LessonLife, NumbersInATextAreThoseOfTheLife) {
  const Lesson lesson = lessonOf("[[step]]\ntitle = \"s\"\nsay = \"{episodes} episodes, {episodes / 3}, {-1234.5}\"\n");
  auto lived = LessonLife::begin(coreOnly(), lesson, 7);
  ASSERT_TRUE(lived);
  ASSERT_TRUE(lived->act({.kind = LessonAction::Kind::Run, .amount = {10, LessonAmount::Unit::Episodes}}));
  EXPECT_EQ(lived->values().text(lesson.steps[0].say, lived->life()), "10 episodes, 3.33, −1234");
}

TEST(LessonLife, LivesOfAWayAreThoseOfTheProgram) {
  const Lesson lesson = lessonOf(
      "[[step]]\ntitle = \"s\"\nsay = \"a\"\nlives = {count = 3, of = \"falls\", after = \"50 episodes\", ways = "
      "[{label = \"low\"}, {label = \"high\", first = [{set = \"policy.epsilon = 0.5\"}, {restart = true}]}]}\n"
      "expect = [\"most(\\\"low\\\") < least(\\\"high\\\")\"]\n");
  Configuration c = lesson.start;
  c.seed = 7;
  for (const int jobs : {1, 2}) {
    const auto lived = liveWays(coreOnly(), lesson, *lesson.steps[0].lives, c, LessonValues(lesson), jobs);
    ASSERT_TRUE(lived);
    for (int life = 0; life < 3; ++life) {
      auto alone = makeLife(coreOnly(), c, life, false);
      ASSERT_TRUE(alone);
      while ((*alone)->log().totals().episodes < 50) (*alone)->step();
      EXPECT_EQ((*lived)[0][static_cast<std::size_t>(life)], static_cast<double>((*alone)->log().totals().falls));
    }
  }
  EXPECT_TRUE(liveThrough(coreOnly(), lesson, 7).empty());
}

// What is handed in is lived again, from what was written down alone.
TEST(LessonLife, ARecordedLifeIsLivedAgain) {
  const Lesson lesson = lessonOf("[[step]]\ntitle = \"s\"\nsay = \"a\"\n");
  auto lived = LessonLife::begin(coreOnly(), lesson, 7);
  ASSERT_TRUE(lived);
  const LessonAction run{.kind = LessonAction::Kind::Run, .amount = {500, LessonAmount::Unit::Steps}};
  const auto act = [&](LessonAction action) { ASSERT_TRUE(lived->act(action)); };
  act(run);
  act({.kind = LessonAction::Kind::Set, .key = "policy.epsilon", .value = "0.3"});
  act(run);
  act({.kind = LessonAction::Kind::Transfer});
  act(run);
  act({.kind = LessonAction::Kind::Policy, .key = "policy", .value = "softmax"});
  act(run);
  act({.kind = LessonAction::Kind::Set, .key = "policy.temperature", .value = "3"});
  const LifeRecord record = lived->record();

  const auto read = lifeRecordOf(Json::parse(asJson(record).dump()));
  ASSERT_TRUE(read) << read.error().message;
  const auto again = relive(coreOnly(), lesson, *read);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_TRUE(again->learnedFrom);
  EXPECT_EQ(again->life->hash(), lived->life().hash());
  EXPECT_EQ(again->life->parameters().get("policy.temperature"), 3) << "what was done after the last step";
  EXPECT_EQ(again->life->policyName(), "softmax");

  LifeRecord edited = *read;
  edited.changes[0].value = "greedy";
  const auto otherwise = relive(coreOnly(), lesson, edited);
  ASSERT_FALSE(otherwise);
  EXPECT_NE(otherwise.error().message.find("comes out otherwise"), std::string::npos);
}

TEST(LessonLife, ExploringIsTheShareOfActionsThatAreNotTheBest) {
  const Lesson lesson = lessonOf(
      "[[step]]\ntitle = \"s\"\nsay = \"a\"\nbegin = [{set = \"policy.epsilon = 0.4\"}, {restart = true}]\nrun = {for "
      "= "
      "\"20000 steps\"}\nexpect = [\"abs(exploring - 0.4 * 3 / 4) < 0.02\"]\n");
  EXPECT_TRUE(liveThrough(coreOnly(), lesson, 7).empty()) << "ε of the steps, and one of four actions is the best";
}

}  // namespace surefoot
