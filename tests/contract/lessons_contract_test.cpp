// SPDX-License-Identifier: GPL-3.0-or-later
// Every lesson that comes with the program is lived through: its solutions are accepted, wrong answers are refused, and
// its texts say what holds.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/lessons/lesson_check.h"
#include "core/lessons/reading/lesson_library.h"
#include "core/lessons/reading/lesson_reading.h"
#include "core/lessons/verdict.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

const std::string kLessons = std::string(SUREFOOT_SOURCE) + "/resources/lessons";

std::vector<std::string> lessonFiles() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kLessons))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

const Registry& everything() {
  static const Registry all = fullRegistry();
  return all;
}

std::string told(const std::string& file, const std::vector<Complaint>& complaints) {
  std::string all;
  for (const Complaint& c : complaints) all += complaintText(file, c) + "\n";
  return all;
}

}  // namespace

class LessonContract : public ::testing::TestWithParam<std::string> {
 protected:
  LessonContract() {
    auto read = readLessonFile(everything(), kLessons + "/" + GetParam() + ".toml");
    EXPECT_TRUE(read);
    if (!read) return;
    EXPECT_TRUE(read->lesson) << told(GetParam(), read->complaints);
    if (read->lesson) lesson_ = std::move(*read->lesson);
  }
  Lesson lesson_;
};

// With the seeds of more students: tests/learning.
TEST_P(LessonContract, IsLivedThroughByItsSolutions) {
  const std::uint64_t seed = lesson_.seedOfStudent ? 1 : lesson_.start.seed;
  EXPECT_EQ(told(GetParam(), liveThrough(everything(), lesson_, seed)), "") << "seed " << seed;
}

TEST_P(LessonContract, RefusesWrongAnswers) {
  int asked = 0;
  for (const LessonStep& step : lesson_.steps) {
    asked += step.predict || step.ask || step.done;
    EXPECT_EQ(step.done.has_value(), !step.wrong.empty()) << step.title << ": a task has a way that does not do it";
    if (!step.ask) continue;
    if (const auto* choice = std::get_if<ChoiceQuestion>(&*step.ask)) {
      for (std::size_t i = 0; i < choice->options.size(); ++i)
        EXPECT_EQ(judge(*choice, i).right, i == choice->answer) << step.title;
      EXPECT_EQ(choice->remarks.size(), choice->options.size()) << step.title << ": a wrong option says where to look";
    }
    if (const auto* order = std::get_if<OrderQuestion>(&*step.ask)) {
      std::vector<std::size_t> wrong = order->answer;
      std::rotate(wrong.begin(), wrong.begin() + 1, wrong.end());
      EXPECT_FALSE(judge(*order, wrong).right) << step.title;
      EXPECT_TRUE(judge(*order, order->answer).right) << step.title;
    }
    if (const auto* number = std::get_if<NumberQuestion>(&*step.ask)) {
      for (const double off : {2 * number->tolerance + 0.1, -2 * number->tolerance - 0.1})
        EXPECT_FALSE(judge(*number, 5 + off, 5).right) << step.title;
      EXPECT_TRUE(judge(*number, 5, 5).right);
    }
  }
  EXPECT_GE(2 * asked, static_cast<int>(lesson_.steps.size())) << "a lesson asks more than it tells";
}

TEST_P(LessonContract, HelpsTheTeacher) {
  EXPECT_FALSE(lesson_.notes.empty());
  EXPECT_FALSE(lesson_.discuss.empty());
  EXPECT_FALSE(lesson_.about.empty());
  EXPECT_FALSE(lesson_.chapter.empty());
  double minutes = 0;
  for (const LessonStep& step : lesson_.steps) {
    EXPECT_GT(step.minutes, 0) << step.title;
    minutes += step.minutes;
  }
  EXPECT_NEAR(minutes, lesson_.minutes, 2.5) << "the steps' minutes are those of the lesson";
}

INSTANTIATE_TEST_SUITE_P(Shipped, LessonContract, ::testing::ValuesIn(lessonFiles()), [](const auto& lesson) {
  std::string name = lesson.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return "lesson_" + name;
});

TEST(LessonContract, TheTemplateIsALesson) {
  const auto read = readLessonFile(everything(), kLessons + "/template/my-lesson.toml");
  ASSERT_TRUE(read && read->lesson) << (read ? told("template", read->complaints) : "");
  EXPECT_EQ(told("template", liveThrough(everything(), *read->lesson, read->lesson->start.seed)), "");
}

TEST(LessonContract, TheLibraryIsComplete) {
  const auto all = lessonsIn(everything(), kLessons);
  int numbered = 0;
  double minutes = 0;
  for (const ShelvedLesson& one : all) {
    EXPECT_TRUE(one.complaints.empty()) << told(one.file(), one.complaints);
    ASSERT_TRUE(one.lesson) << one.path;
    if (one.lesson->number.empty()) continue;
    EXPECT_EQ(one.lesson->number, std::to_string(++numbered)) << "in order, none left out";
    minutes += one.lesson->minutes;
  }
  EXPECT_EQ(numbered, 13);
  EXPECT_EQ(all.size(), 14u);
  EXPECT_NEAR(minutes, 140, 15) << "a good two hours in all";
}

}  // namespace surefoot
