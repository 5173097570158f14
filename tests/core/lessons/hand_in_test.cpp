// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/handed_in/hand_in.h"

#include <gtest/gtest.h>

#include "core/lessons/handed_in/grading.h"
#include "tests/core/lessons/taught.h"

namespace surefoot {

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

Grade gradedText(const std::string& text) {
  const auto handIn = parseHandIn(text);
  EXPECT_TRUE(handIn) << (handIn ? "" : handIn.error().message);
  return handIn ? gradeOf(registryOfCore(), taught(), *handIn) : Grade{};
}

}  // namespace

TEST(HandIn, WhatIsWrittenIsRead) {
  std::uint64_t check = 0;
  const auto handIn = parseHandIn(handedIn("Ada"), &check);
  ASSERT_TRUE(handIn) << handIn.error().message;
  EXPECT_EQ(handIn->student, "Ada");
  EXPECT_EQ(handIn->marks.size(), 12u);
  EXPECT_TRUE(handIn->edited.empty());
  EXPECT_TRUE(handIn->damaged.empty());
  EXPECT_TRUE(handIn->finished());
  EXPECT_EQ(handIn->last(LessonMark::Kind::Words, 4)->text, "\"=cmd\", she said");
  // Whoever goes on writes lines that fit.
  HandInWriter writer(check);
  const auto more = parseHandIn(handedIn("Ada") + writer.line({.kind = LessonMark::Kind::HintTaken, .step = 1}));
  ASSERT_TRUE(more);
  EXPECT_TRUE(more->edited.empty());
}

TEST(HandIn, IsGradedByLivingItAgain) {
  const Grade ada = gradedText(handedIn("Ada"));
  EXPECT_TRUE(ada.trusted) << (ada.remarks.empty() ? "" : ada.remarks[0]);
  EXPECT_TRUE(ada.finished);
  EXPECT_EQ(ada.questions, 2);
  EXPECT_EQ(ada.rightAtOnce, 2);
  EXPECT_EQ(ada.tasksDone, 1);
  EXPECT_EQ(ada.pars, 1);
  EXPECT_DOUBLE_EQ(ada.minutes, 4.0);
  const Grade bob = gradedText(handedIn("Bob", true));
  EXPECT_EQ(bob.rightAtOnce, 1);
  EXPECT_EQ(bob.rightAtLast, 2);
  EXPECT_NE(seedOf(taught(), "Ada"), seedOf(taught(), "Bob")) << "numbers of his own";
}

// An edited line is told; and if its check was forged as well, its life comes out otherwise.
TEST(HandIn, WhatWasEditedIsTold) {
  const std::string text = handedIn("Ada");
  const auto remarks = [](const std::string& edited) {
    const Grade grade = gradedText(edited);
    EXPECT_FALSE(grade.trusted);
    std::string all;
    for (const std::string& remark : grade.remarks) all += remark + "\n";
    return all;
  };
  EXPECT_NE(remarks(replaced(text, "\"value\":40", "\"value\":41")).find("edited: line 3"), std::string::npos);
  EXPECT_NE(
      remarks(replaced(text, "\"student\":\"Ada\"", "\"student\":\"Eve\"")).find("its seed is not this student's"),
      std::string::npos);
  EXPECT_NE(remarks(replaced(text, "{\"because\"", "{\"becaus\"")).find("edited"), std::string::npos);
  const auto line = text.find("\"what\":\"said\"");
  const auto from = text.rfind('\n', line) + 1;
  EXPECT_NE(remarks(text.substr(0, from) + text.substr(text.find('\n', from) + 1)).find("edited: line 3"),
            std::string::npos)
      << "a line that was left out";
  EXPECT_NE(remarks(text + "{\"what\": \"done\"\n").find("damaged: line 14"), std::string::npos);

  // Forged with a right check:
  const auto forge = [&](const std::function<void(LessonMark&)>& change) {
    auto handIn = parseHandIn(text);
    EXPECT_TRUE(handIn);
    HandInWriter writer;
    std::string forged = writer.header(*handIn);
    for (LessonMark mark : handIn->marks) {
      change(mark);
      forged += writer.line(mark);
    }
    return remarks(forged);
  };
  const auto ofLife = [](LessonMark& mark, const std::function<void(LifeRecord&)>& change) {
    if (!mark.life) return;
    LifeRecord record = *mark.life;
    change(record);
    mark.life = std::make_shared<const LifeRecord>(record);
  };
  EXPECT_NE(forge([](LessonMark& m) { m.value += m.kind == LessonMark::Kind::Observed; }).find("its life came to"),
            std::string::npos);
  EXPECT_NE(forge([&](LessonMark& m) {
              ofLife(m, [](LifeRecord& r) { r.steps += r.steps > 0; });
            }).find("comes out otherwise"),
            std::string::npos);
  EXPECT_NE(forge([&](LessonMark& m) {
              ofLife(m, [](LifeRecord& r) { r.set.push_back({"agent.discount", "0.5"}); });
            }).find("agent.discount was set, which the lesson does not offer"),
            std::string::npos);
  EXPECT_NE(forge([](LessonMark& m) {
              if (m.kind == LessonMark::Kind::Answered) m.right = true, m.text = "1";
            }).find("it says right, and it is wrong"),
            std::string::npos);
  EXPECT_NE(forge([](LessonMark& m) {
              if (m.kind == LessonMark::Kind::Done) m.life = m.before;
            }).find("step 4"),
            std::string::npos)
      << "a life that does not do the task";
}

TEST(HandIn, AClockThatJumpsCountsForLittle) {
  auto handIn = parseHandIn(handedIn("Ada"));
  ASSERT_TRUE(handIn);
  for (LessonMark& mark : handIn->marks) mark.seconds = mark.step == 0 ? 1e12 : -5;
  EXPECT_LE(gradeOf(registryOfCore(), taught(), *handIn).minutes, 60) << "an hour a step at most";
}

TEST(HandIn, WhateverIsInAFileIsASentence) {
  for (const char* text : {"", "{}", "not JSON", "{\"surefoot_lesson\":\"2.0\"}", "{\"surefoot_lesson\":\"1.0\"}",
                           "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[["})
    EXPECT_FALSE(parseHandIn(text)) << text;
  std::string text = handedIn("Ada");
  for (std::size_t i = 7; i < text.size(); i += 97) text[i] = static_cast<char>(i % 251);
  const auto handIn = parseHandIn(text);
  EXPECT_TRUE(!handIn || !gradeOf(registryOfCore(), taught(), *handIn).trusted);
}

TEST(HandIn, CellsOfTheTableAreNoFormulas) {
  Grade grade{.student = "=HYPERLINK(\"x\")", .lesson = "a", .remarks = {"a, b"}};
  EXPECT_TRUE(asCsv(grade).starts_with("\"'=HYPERLINK(\"\"x\"\")\",a,no")) << asCsv(grade);
}

}  // namespace surefoot
