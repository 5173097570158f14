// SPDX-License-Identifier: GPL-3.0-or-later
// A small lesson, and the file of a student who did all of it.
#pragma once

#include <gtest/gtest.h>

#include "core/lessons/handed_in/hand_in.h"
#include "core/lessons/lesson_life.h"
#include "core/lessons/reading/lesson_reading.h"
#include "core/life/lives_version.h"
#include "core/register/register.h"

namespace surefoot {

inline const char* const kTaught =
    "title = \"a\"\ngoal = \"b\"\n[start]\nenvironment = \"cliff\"\nfeatures = \"table\"\nseed = \"student\"\n"
    "set.policy.epsilon = 0.05\nshow = [\"falls\", \"policy.epsilon\"]\n"
    "[[step]]\ntitle = \"s\"\nsay = \"a\"\n"
    "predict = {kind = \"number\", question = \"?\", low = 0, high = 500, of = \"falls\", after = \"100 episodes\"}\n"
    "[[step]]\ntitle = \"s\"\nsay = \"a\"\nask = {kind = \"choice\", question = \"?\", options = [\"x\", \"y\"], "
    "answer = 2}\n"
    "[[step]]\ntitle = \"s\"\nsay = \"a\"\nask = {kind = \"number\", question = \"?\", answer = \"falls\", tolerance = "
    "0.5}\n"
    "[[step]]\ntitle = \"s\"\nsay = \"a\"\ntask = \"t\"\ndone = \"episodes >= 50 and falls > before.falls\"\n"
    "par = \"policy.epsilon <= 0.3\"\n"
    "solution = [{set = \"policy.epsilon = 0.3\"}, {restart = true}, {run = \"100 episodes\"}]\n"
    "[[step]]\ntitle = \"s\"\nsay = \"a\"\nask = {kind = \"words\", question = \"?\", model = \"m\"}\n";

inline const Registry& registryOfCore() {
  static const Registry all = [] {
    Registry r;
    registerCore(r);
    return r;
  }();
  return all;
}

inline const Lesson& taught() {
  static const Lesson lesson = [] {
    std::vector<Complaint> complaints;
    auto read = readLesson(registryOfCore(), kTaught, "05-taught.toml", complaints);
    EXPECT_TRUE(read) << complaintText("a", complaints.empty() ? Complaint{} : complaints[0]);
    return read.value_or(Lesson{});
  }();
  return lesson;
}

inline std::shared_ptr<const LifeRecord> recorded(LessonLife& lived) {
  return std::make_shared<const LifeRecord>(lived.record());
}

/// The file of a student who did everything; `wrongFirst`: the choice was wrong once.
inline std::string handedIn(const std::string& student, bool wrongFirst = false) {
  using Does = LessonMark::Kind;
  HandIn handIn{.lesson = taught().name,
                .student = student,
                .lessonHash = taught().hash,
                .seed = seedOf(taught(), student),
                .livesVersion = kLivesVersion};
  auto lived = LessonLife::begin(registryOfCore(), taught(), handIn.seed);
  EXPECT_TRUE(lived);
  HandInWriter writer;
  std::string text = writer.header(handIn);
  const auto add = [&](LessonMark mark) { text += writer.line(mark); };
  add({.kind = Does::Arrived, .step = 0, .seconds = 0, .life = recorded(*lived)});
  add({.kind = Does::Said, .step = 0, .value = 40, .seconds = 60});
  lived->run(taught().steps[0].predict->after);
  const double falls = lived->valueOf(taught().steps[0].predict->of);
  add({.kind = Does::Observed, .step = 0, .value = falls, .seconds = 60, .life = recorded(*lived)});
  add({.kind = Does::Arrived, .step = 1, .seconds = 0, .life = recorded(*lived)});
  if (wrongFirst) add({.kind = Does::Answered, .step = 1, .right = false, .text = "1", .seconds = 30});
  add({.kind = Does::Answered, .step = 1, .right = true, .text = "2", .because = "so", .seconds = 60});
  add({.kind = Does::Arrived, .step = 2, .seconds = 0, .life = recorded(*lived)});
  add({.kind = Does::Answered, .step = 2, .right = true, .text = std::to_string(falls), .life = recorded(*lived)});
  add({.kind = Does::Arrived, .step = 3, .seconds = 0, .life = recorded(*lived)});
  const auto before = recorded(*lived);
  EXPECT_TRUE(lived->act(taught().steps[3].solution));
  add({.kind = Does::Done, .step = 3, .right = true, .seconds = 60, .life = recorded(*lived), .before = before});
  add({.kind = Does::Arrived, .step = 4, .seconds = 0, .life = recorded(*lived)});
  add({.kind = Does::Words, .step = 4, .right = true, .text = "\"=cmd\", she said", .seconds = 60});
  add({.kind = Does::Finished, .step = 4, .seconds = 60});
  return text;
}

}  // namespace surefoot
