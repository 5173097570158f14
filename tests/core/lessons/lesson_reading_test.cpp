// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/reading/lesson_reading.h"

#include <gtest/gtest.h>

#include "core/register/register.h"

namespace surefoot {

namespace {

const char* const kGood = R"lesson(title = "Exploring costs falls"
goal = "Say what ε does to falls."
chapter = "Falling less"
minutes = 10
level = 2
needs = ["why-does-it-fall"]

[start]
environment = "cliff"
features = "table"
policy = "epsilon-greedy"
seed = "student"
set.policy.epsilon = 0.05
range.policy.epsilon = [0, 0.5]
show = ["world", "falls", "policy.epsilon", "run"]

[[step]]
title = "A step"
say = "One action in twenty is random."
predict = {kind = "number", question = "?", unit = "falls", low = 0, high = 200, of = "falls", after = "200 episodes"}

[[step]]
title = "A step"
say = "Now look."
run = {until = "episodes >= 200", turbo = true}
ask = {kind = "choice", question = "?", options = ["It learns slowly.", "By one action."], answer = 2, because = true}
hint = "What does it do when it does not take the best action?"

[[step]]
title = "A step"
say = "It fell {observed(1)} times. Make it fall twice as often."
show = ["world"]
task = "Twice as often."
expect = ["falls > 3"]
done = "episodes >= 200 and falls >= 2 * observed(1)"
solution = [{set = "policy.epsilon = 0.3"}, {restart = true}, {run = "200 episodes"}]
par = "policy.epsilon <= 0.2"

[[step]]
title = "A step"
say = "Which first?"
ask = {kind = "order", question = "Which?", options = ["a", "b", "c"], answer = [3, 1, 2]}

[[step]]
title = "A step"
say = "In your own words."
ask = {kind = "words", question = "Say it.", model = "It explores."}

[teacher]
notes = "Let them vote."
discuss = ["Why?"]
)lesson";

Registry registry() {
  Registry r;
  registerCore(r);
  return r;
}

/// What readLesson complains about, one a line.
std::string complaintsOf(std::string text, const std::string& from = "", const std::string& to = "") {
  if (!from.empty()) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  }
  std::vector<Complaint> complaints;
  const auto lesson = readLesson(registry(), text, "05-exploring-costs-falls.toml", complaints);
  EXPECT_EQ(lesson.has_value(), complaints.empty());
  std::string all;
  for (const Complaint& c : complaints) all += complaintText("lessons/05-x.toml", c) + "\n";
  return all;
}

}  // namespace

// Its texts are translated whole; what is computed, compared and kept is the same in every language.
TEST(Lesson, IsReadInALanguage) {
  const std::string text =
      kGood + std::string(
                  "\n[[step]]\ntitle = \"Lives\"\nsay = \"{least(\\\"a way\\\")}\"\n[step.lives]\nof = \"falls\"\n"
                  "after = \"5 episodes\"\nways = [{label = \"a way\"}]\n");
  std::vector<Complaint> complaints;
  const auto english = readLesson(registry(), text, "05-x.toml", complaints);
  ASSERT_TRUE(english) << complaintText("", complaints.at(0));
  const Translate marked = [](const std::string& of) { return "«" + of + "»"; };
  const auto lesson = readLesson(registry(), text, "05-x.toml", complaints, marked);
  ASSERT_TRUE(lesson) << complaintText("", complaints.at(0));
  EXPECT_EQ(lesson->title, "«Exploring costs falls»");
  EXPECT_EQ(lesson->line, lesson->goal) << "once, not twice";
  EXPECT_EQ(lesson->chapter, "«Falling less»");
  EXPECT_EQ(lesson->notes, "«Let them vote.»");
  EXPECT_EQ(lesson->discuss, std::vector<std::string>{"«Why?»"});
  const LessonStep& third = lesson->steps[2];
  EXPECT_EQ(third.say.between, (std::vector<std::string>{"«It fell ", " times. Make it fall twice as often.»"}));
  EXPECT_EQ(third.say.numbers[0].text, "observed(1)");
  EXPECT_EQ(third.task, "«Twice as often.»");
  EXPECT_EQ(lesson->steps[0].predict->unit, "«falls»");
  const auto& choice = std::get<ChoiceQuestion>(*lesson->steps[1].ask);
  EXPECT_EQ(choice.options[1], "«By one action.»");
  EXPECT_EQ(choice.remarks, std::get<ChoiceQuestion>(*english->steps[1].ask).remarks);
  const LessonLives::Way& way = lesson->steps.back().lives->ways[0];
  EXPECT_EQ(way.label, "a way") << "as expressions and kept answers have it";
  EXPECT_EQ(way.title, "«a way»");
  EXPECT_EQ(lesson->hash, english->hash);

  const auto own = readLesson(registry(), "language = \"nl\"\n" + text, "05-x.toml", complaints, marked);
  ASSERT_TRUE(own);
  EXPECT_EQ(own->title, "Exploring costs falls") << "it is in a language of its own";
}

TEST(Lesson, IsReadAsItIsWritten) {
  std::vector<Complaint> complaints;
  const auto lesson = readLesson(registry(), kGood, "05-exploring-costs-falls.toml", complaints);
  ASSERT_TRUE(lesson) << complaintText("", complaints.at(0));
  EXPECT_EQ(lesson->name, "exploring-costs-falls");
  EXPECT_EQ(lesson->level, 2);
  EXPECT_TRUE(lesson->seedOfStudent);
  EXPECT_EQ(lesson->start.names.environment, "cliff");
  EXPECT_EQ(lesson->start.parameters.get("policy.epsilon"), 0.05);
  EXPECT_EQ(lesson->ranges.at("policy.epsilon"), std::pair(0.0, 0.5)) << "the ends of its slider";
  ASSERT_EQ(lesson->steps.size(), 5u);
  EXPECT_EQ(lesson->steps[0].predict->after.value, 200);
  EXPECT_EQ(lesson->steps[1].show, lesson->steps[0].show) << "those of the step before";
  EXPECT_EQ(std::get<ChoiceQuestion>(*lesson->steps[1].ask).answer, 1u);
  EXPECT_EQ(lesson->steps[2].show, (std::vector<std::string>{"world"}));
  ASSERT_EQ(lesson->steps[2].solution.size(), 3u);
  EXPECT_EQ(lesson->steps[2].solution[0].key, "policy.epsilon");
  EXPECT_EQ(lesson->steps[2].solution[0].value, "0.3");
  EXPECT_EQ(std::get<OrderQuestion>(*lesson->steps[3].ask).answer, (std::vector<std::size_t>{2, 0, 1}));
  // falls 40 of episodes 200, observed(1) 20, ε 0.05, in the order in which they are named
  const auto& done = lesson->steps[2].done->expression;
  std::vector<double> values;
  for (const LessonQuantity& q : lesson->quantities)
    values.push_back(q.kind == LessonQuantity::Kind::Falls      ? 40
                     : q.kind == LessonQuantity::Kind::Episodes ? 200
                     : q.kind == LessonQuantity::Kind::Observed ? 20
                                                                : 0.05);
  EXPECT_TRUE(done.holds(values));
  for (double& v : values)
    if (v == 20) v = 21;
  EXPECT_FALSE(done.holds(values));
}

TEST(Lesson, EveryMistakeIsToldWithLineAndColumn) {
  const std::pair<std::pair<const char*, const char*>, const char*> kMistakes[] = {
      {{"title = \"Exploring costs falls\"\n", ""}, "title is missing."},
      {{"goal", "gaol"}, "line 2, column 1: there is no \"gaol\" here; did you mean goal"},
      {{"level = 2", "level = 4"}, "line 5, column 9: level: 4 is not allowed; it takes 1 to 3."},
      {{"minutes = 10", "minutes = \"ten\""}, "minutes: it takes a number."},
      {{"\"cliff\"", "\"clif\""}, "start: environment: there is no \"clif\", did you mean cliff"},
      {{"epsilon = 0.05", "epsilon = 5"}, "policy.epsilon"},
      {{"epsilon = [0, 0.5]", "epsilon = [0.5, 0.5]"}, "range.policy.epsilon takes the two ends of a slider: [0, 1]."},
      {{"epsilon = [0, 0.5]", "epsilon = [0, 2]"}, "range.policy.epsilon goes from 0 to 2; it takes"},
      {{"range.policy.epsilon", "range.policy.epsilom"}, "range: there is no parameter policy.epsilom here."},
      {{"\"falls\", after", "\"fals\", after"}, "of: there is no \"fals\"; did you mean falls."},
      {{"after = \"200 episodes\"", "after = \"200 minutes\""}, "after: this task has no clock"},
      {{"after = \"200 episodes\"", "after = \"long\""}, "after: it takes \"200 episodes\""},
      {{"high = 200", "high = -1"}, "high: -1 is not above low, 0."},
      {{"answer = 2", "answer = 3"}, "answer: 3 is not allowed; it takes 1 to 2."},
      {{"observed(1)\"", "observed(2)\""}, "done: step 2 observes nothing"},
      {{"falls >= 2 * observed(1)", "falls < 0"}, "done: this can never hold."},
      {{"episodes >= 200\", turbo", "episodes\", turbo"}, "until: a condition is wanted"},
      {{"{restart = true}", "{restart = 1}"}, "restart: it takes true or false."},
      {{"policy.epsilon = 0.3", "policy.epsilom = 0.3"}, "set: policy.epsilom"},
      {{"solution = [", "solutions = ["}, "done: a task needs its solution"},
      {{"answer = [3, 1, 2]", "answer = [3, 1, 1]"}, "answer: it names every option once"},
      {{"show = [\"world\"]", "show = [\"wrold\"]"}, "show: there is no panel or knob \"wrold\"; did you mean world"},
      {{"kind = \"words\"", "kind = \"essay\""}, "kind: there is no \"essay\"; it takes number, choice"},
      {{"minutes = 10", "minutes = 2026-01-01"}, "dates and times mean nothing here."},
      {{"title = \"Exploring", "title \"Exploring"}, "line 1, column"},
      {{"{observed(1)} times", "{observed(9)} times"}, "say, {observed(9)}: step 9 observes nothing"},
      {{"{observed(1)} times", "{observed(1) times"}, "say: a brace is not closed"},
      {{"Now look.", "![the sun](http://example.org/sun.png)"}, "say: it shows a picture"},
      {{"Now look.", "<img src=x>"}, "say: it holds HTML"},
      {{"Now look.", "[look](file:///etc/passwd)"}, "say: its links lead to lessons"},
      {{"task = \"Twice as often.\"\n", ""}, "done: a task is said in one sentence"},
      {{"falls > 3\"]", "falls > fals\"]"}, "expect: there is no \"fals\"; did you mean falls."},
      {{"{restart = true}", "{agent = \"sarza\"}"}, "agent: agent: there is no \"sarza\""},
      {{"{restart = true}", "{place = [99]}"}, "place: "},
      {{"{restart = true}", "{jump = true}"}, "there is no \"jump\" here"},
  };
  for (const auto& [change, sentence] : kMistakes) {
    const std::string told = complaintsOf(kGood, change.first, change.second);
    EXPECT_NE(told.find(sentence), std::string::npos) << change.second << " gives\n" << told;
  }
}

TEST(Lesson, KindsOfQuestionsAreReadWithAllTheirParts) {
  const std::string head = std::string(kGood).substr(0, std::string(kGood).find("[[step]]"));
  const std::string steps =
      "[[step]]\ntitle = \"a\"\nsay = \"{mean(\\\"low\\\")} against {most(\\\"high\\\")}\"\n"
      "lives = {count = 4, of = \"falls\", after = \"20 episodes\", ways = [{label = \"low\"}, {label = \"high\", "
      "first = "
      "[{set = \"policy.epsilon = 0.5\"}, {restart = true}]}]}\n"
      "ask = {kind = \"compare\", question = \"Which?\"}\n"
      "[[step]]\ntitle = \"b\"\nsay = \"b\"\nask = {kind = \"point\", question = \"Where?\", accept = \"column > 3 and "
      "q(\\\"up\\\") <= 0\", right = [5, 1], wrong = [1, 1]}\n"
      "[[step]]\ntitle = \"c\"\nsay = \"c\"\nask = {kind = \"number\", question = \"What?\", answer = \"10 * 0.5\", "
      "tolerance = 0.1}\n"
      "[[step]]\ntitle = \"d\"\nsay = \"d\"\nask = {kind = \"mistake\", question = \"What is wrong?\", options = "
      "[\"α\", "
      "\"γ\"], answer = 2}\n";
  std::vector<Complaint> complaints;
  const auto lesson = readLesson(registry(), head + steps, "07-x.toml", complaints);
  ASSERT_TRUE(lesson) << complaintText("", complaints.at(0));
  EXPECT_EQ(lesson->number, "7");
  EXPECT_EQ(lesson->ways, 2u);
  EXPECT_EQ(lesson->steps[0].lives->ways[1].first.size(), 2u);
  EXPECT_EQ(lesson->steps[0].say.numbers.size(), 2u);
  std::string kinds;
  for (const LessonStep& step : lesson->steps) kinds += kindOf(step) + ";";
  EXPECT_EQ(kinds, "compare;point;work out;find the mistake;");
  const auto refused = [&](std::string from, std::string to) { return complaintsOf(head + steps, from, to); };
  EXPECT_NE(refused("label = \"high\"", "label = \"low\"").find("another way of this lesson has this label"),
            std::string::npos);
  EXPECT_NE(refused("mean(\\\"low", "mean(\\\"lwo").find("no lives are called \"lwo\" up to this step"),
            std::string::npos);
  EXPECT_NE(refused("count = 4", "count = 1").find("count: 1 is not allowed"), std::string::npos);
  EXPECT_NE(refused("right = [5, 1], ", "").find("right is missing"), std::string::npos);
}

TEST(Lesson, AllMistakesAreToldAtOnce) {
  std::string text = kGood;
  text.replace(text.find("level = 2"), 9, "level = 9");
  text.replace(text.find("minutes = 10"), 12, "minutes = 0 ");
  const std::string told = complaintsOf(text);
  EXPECT_NE(told.find("level"), std::string::npos) << told;
  EXPECT_NE(told.find("minutes"), std::string::npos) << told;
}

TEST(Lesson, SizesAreLimited) {
  std::string words;
  for (int i = 0; i < 61; ++i) words += "word ";
  EXPECT_NE(complaintsOf(kGood, "Now look.", words).find("it has 61 words; a step has at most 60."), std::string::npos);
  EXPECT_NE(complaintsOf(std::string(300'000, '#')).find("at most 256 kB"), std::string::npos);
  EXPECT_NE(complaintsOf("title = \"a\"\ngoal = \"b\"\n").find("1 to 40 steps"), std::string::npos);
  EXPECT_NE(complaintsOf(std::string("a = ") + std::string(200, '[')), "");
}

TEST(Lesson, AmountsAreWhatPeopleWrite) {
  EXPECT_EQ(parseAmount("1 episode")->unit, LessonAmount::Unit::Episodes);
  EXPECT_EQ(parseAmount("1.5 minutes")->value, 1.5);
  for (const char* wrong : {"", "5", "five steps", "-1 steps", "0 episodes", "1.5 episodes", "2 hours", "1e30 steps"})
    EXPECT_FALSE(parseAmount(wrong)) << wrong;
}

}  // namespace surefoot
