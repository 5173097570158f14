// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <atomic>

#include "core/lessons/reading/lesson_reading.h"
#include "core/life/lives_version.h"
#include "tests/core/experiment/test_setup.h"
#include "ui/lessons/driver/lesson_driver.h"

namespace surefoot {

inline const char* const kSteps =
    "title = \"a\"\ngoal = \"b\"\n[start]\nenvironment = \"cliff\"\nfeatures = \"table\"\nseed = 7\n"
    "set.policy.epsilon = 0.05\nshow = [\"world\", \"falls\", \"policy.epsilon\", \"run\", \"restart\", \"turbo\"]\n"
    "[[step]]\ntitle = \"s\"\nsay = \"{falls} falls\"\nrun = {for = \"100 episodes\", turbo = true}\nobserve = "
    "\"falls\"\n"
    "[[step]]\ntitle = \"s\"\nsay = \"It fell {observed(1)} times.\"\n"
    "[step.predict]\nkind = \"number\"\nquestion = \"?\"\nlow = 0\nhigh = 500\nof = \"falls\"\nafter = \"100 "
    "episodes\"\n"
    "then = [{set = \"policy.epsilon = 0.25\"}, {restart = true}]\n"
    "[[step]]\ntitle = \"s\"\nsay = \"{observed(2)} against {observed(1)}\"\n"
    "ask = {kind = \"choice\", question = \"?\", options = [\"x\", \"y\"], answer = 2}\n"
    "[[step]]\ntitle = \"s\"\nsay = \"a\"\ntask = \"t\"\ndone = \"episodes >= 50 and falls > 0 "
    "and policy.epsilon > 0.4\"\n"
    "attempt = \"60 episodes\"\n"
    "begin = [{set = \"policy.epsilon = 0\"}, {restart = true}]\n"
    "solution = [{set = \"policy.epsilon = 0.5\"}, {restart = true}, {run = \"60 episodes\"}]\n"
    "[[step]]\ntitle = \"s\"\nsay = \"a\"\nbegin = [{run = \"50 episodes\"}, {transfer = true}]\n"
    "lives = {count = 3, of = \"falls\", after = \"20 episodes\", ways = [{label = \"low\"}, {label = \"high\", first "
    "= "
    "[{set = \"policy.epsilon = 0.9\"}, {restart = true}]}]}\nask = {kind = \"compare\", question = \"?\"}\n"
    "[[step]]\ntitle = \"s\"\nsay = \"a\"\n"
    "ask = {kind = \"number\", question = \"?\", answer = \"1 + falls\", tolerance = 0.1}\n";

/// A lesson of every kind of step, being taken.
struct Taking {
  explicit Taking(HandIn before = {}) : registry(fullRegistry()) {
    std::vector<Complaint> complaints;
    auto read = readLesson(registry, kSteps, "a.toml", complaints);
    EXPECT_TRUE(read) << complaintText("a", complaints.empty() ? Complaint{} : complaints[0]);
    if (before.lesson.empty())
      before = {.lesson = "a", .student = {}, .lessonHash = read->hash, .seed = 7, .livesVersion = kLivesVersion};
    driver = std::make_unique<LessonDriver>(registry, *read, before);
    QObject::connect(driver.get(), &LessonDriver::refused,
                     [](const QString& sentence) { ADD_FAILURE() << sentence.toStdString(); });
  }
  bool opens(std::size_t number) {
    return QTest::qWaitFor([&] { return driver->number() == number && driver->phase() == LessonDriver::Phase::Open; },
                           20'000) &&
           QTest::qWaitFor([&] { return !driver->text().isEmpty(); }, 5'000);
  }
  std::uint64_t hash() {
    std::uint64_t value = 0;
    std::atomic<bool> seen = false;
    driver->session().life().visit([&](const Life& life) { value = life.hash(), seen = true; });
    EXPECT_TRUE(QTest::qWaitFor([&] { return seen.load(); }, 5'000));
    return value;
  }
  const Lesson& lesson() const { return driver->lesson(); }

  Registry registry;
  std::unique_ptr<LessonDriver> driver;
};

}  // namespace surefoot
