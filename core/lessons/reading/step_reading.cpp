// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/reading/step_reading.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/lessons/reading/lesson_reading.h"
#include "core/lessons/reading/question_reading.h"
#include "core/text/printable.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

class StepReader {
 public:
  StepReader(ReadingParts& parts, const TomlNode& table, Lesson& lesson)
      : parts_(parts),
        table_(table),
        reader_(table, parts.complaints()),
        lesson_(lesson) {}

  LessonStep read() {
    LessonStep step{.at = table_.at};
    LessonWords::Known& known = parts_.words().known();
    known.predicts.push_back(table_.find("predict") != nullptr);
    known.observes.push_back(known.predicts.back() || table_.find("observe") != nullptr);
    step.title = parts_.neededSaid(reader_, "title");
    step.show = reader_.texts("show");
    checkShown(step.show);
    step.minutes = reader_.number("minutes", 0, 180, 0);
    step.begin = parts_.actions(reader_, "begin");
    step.lives = lives();
    step.say = parts_.text(reader_, table_, "say");
    step.hint = parts_.said(reader_, "hint");
    step.predict = prediction();
    step.run = run();
    step.ask = readQuestion(parts_, reader_);
    step.observe = parts_.condition(reader_, table_, "observe", ValueKind::Number);
    step.expect = parts_.conditions(reader_, table_, "expect");
    readTask(step);
    if (step.predict && (step.ask || step.done)) reader_.complain("predict", "a step asks for one thing.");
    if (step.ask && step.done) reader_.complain("ask", "a step asks for one thing.");
    if (step.ask && std::holds_alternative<CompareQuestion>(*step.ask) && (!step.lives || step.lives->ways.size() != 2))
      reader_.complain("ask", "compare needs lives of two ways in the same step.");
    reader_.end();
    return step;
  }

 private:
  void readTask(LessonStep& step) {
    step.done = parts_.condition(reader_, table_, "done", ValueKind::Condition);
    step.par = parts_.condition(reader_, table_, "par", ValueKind::Condition);
    step.task = parts_.said(reader_, "task");
    step.attempt = parts_.amount(reader_, "attempt");
    if (step.attempt && !step.done)
      reader_.complain("attempt", "an attempt belongs to a task, which has done = \"…\".");
    step.solution = parts_.actions(reader_, "solution");
    step.wrong = parts_.actions(reader_, "wrong");
    if (step.par && !step.done) reader_.complain("par", "a par belongs to a task, which has done = \"…\".");
    if (step.done && step.task.empty())
      reader_.complain("done", "a task is said in one sentence: task = \"Make it …\".");
    if (step.done && step.solution.empty())
      reader_.complain("done", "a task needs its solution, so that a test can live through it.");
  }

  void checkShown(const std::vector<std::string>& shown) {
    std::vector<std::string> all = lessonPanels();
    all.insert(all.end(), lessonControls().begin(), lessonControls().end());
    for (const auto& entry : lesson_.start.parameters.all()) all.push_back(entry.parameter.key);
    for (const std::string& name : shown) {
      if (std::find(all.begin(), all.end(), name) != all.end()) continue;
      const std::string near = nearestWord(name, all);
      reader_.complain("show", fmt::format("there is no panel or knob \"{}\"{}.", printable(shortened(name)),
                                           near.empty() ? "" : "; did you mean " + near));
    }
  }

  std::optional<LessonPrediction> prediction() {
    const TomlNode* table = reader_.table("predict");
    if (!table) return std::nullopt;
    TomlReader reader(*table, parts_.complaints());
    if (const std::string kind = reader.neededText("kind"); !kind.empty() && kind != "number")
      reader.complain("kind", "what is predicted is a number: kind = \"number\".");
    LessonPrediction p{.question = parts_.neededSaid(reader, "question"),
                       .unit = parts_.said(reader, "unit"),
                       .low = reader.number("low", -1e12, 1e12, 0),
                       .high = reader.number("high", -1e12, 1e12, 100),
                       .of = {},
                       .after = {},
                       .then = parts_.actions(reader, "then"),
                       .turbo = reader.flag("turbo", true)};
    if (p.low >= p.high) reader.complain("high", fmt::format("{} is not above low, {}.", p.high, p.low));
    if (reader.need("of"))
      if (auto of = parts_.condition(reader, *table, "of", ValueKind::Number)) p.of = std::move(*of);
    if (reader.need("after"))
      if (const auto after = parts_.amount(reader, "after")) p.after = *after;
    reader.end();
    return p;
  }

  std::optional<LessonRun> run() {
    const TomlNode* table = reader_.table("run");
    if (!table) return std::nullopt;
    TomlReader reader(*table, parts_.complaints());
    LessonRun run{.until = parts_.condition(reader, *table, "until", ValueKind::Condition),
                  .amount = parts_.amount(reader, "for"),
                  .turbo = reader.flag("turbo")};
    if (run.until && run.amount) reader.complain("for", "a run has one end: until or for.");
    reader.end();
    return run;
  }

  std::optional<LessonLives> lives() {
    const TomlNode* table = reader_.table("lives");
    if (!table) return std::nullopt;
    TomlReader reader(*table, parts_.complaints());
    LessonLives lives{.count = static_cast<int>(reader.whole("count", 2, 50, 10)),
                      .title = parts_.said(reader, "title"),
                      .of = {},
                      .after = {}};
    if (reader.need("of"))
      if (auto of = parts_.condition(reader, *table, "of", ValueKind::Number)) lives.of = std::move(*of);
    if (reader.need("after"))
      if (const auto after = parts_.amount(reader, "after")) lives.after = *after;
    for (const TomlNode* way : reader.tables("ways")) {
      TomlReader one(*way, parts_.complaints());
      const std::string label = one.neededText("label");
      lives.ways.push_back({.label = label,
                            .title = parts_.said(one, "label"),
                            .first = parts_.actions(one, "first"),
                            .place = lesson_.ways++});
      auto& labels = parts_.words().known().ways;
      if (std::find(labels.begin(), labels.end(), lives.ways.back().label) != labels.end())
        one.complain("label", "another way of this lesson has this label.");
      labels.push_back(lives.ways.back().label);
      one.end();
    }
    if (lives.ways.empty() || lives.ways.size() > kMostWays)
      reader.complain("ways", fmt::format("there are 1 to {} ways.", kMostWays));
    reader.end();
    return lives;
  }

  ReadingParts& parts_;
  const TomlNode& table_;
  TomlReader reader_;
  Lesson& lesson_;
};

}  // namespace

const std::vector<std::string>& lessonPanels() {
  static const std::vector<std::string> names = {"world", "parameters", "actions", "maps",    "reward",   "falls",
                                                 "step",  "rule",       "list",    "signals", "portrait", "strides"};
  return names;
}

const std::vector<std::string>& lessonControls() {
  static const std::vector<std::string> names = {"run", "restart", "pace", "turbo", "agent", "policy", "scenario"};
  return names;
}

void readSteps(const Registry& registry, const std::vector<const TomlNode*>& steps,
               const std::vector<std::string>& show, Lesson& lesson, std::vector<Complaint>& complaints,
               const Translate& translate) {
  const auto environment = makeEnvironment(registry, lesson.start);
  if (!environment) return complaints.push_back({{}, environment.error().message});
  LessonWords words((*environment)->task(), lesson.start.parameters);
  ReadingParts parts(registry, lesson, (*environment)->task(), words, complaints, translate);
  for (const TomlNode* table : steps) lesson.steps.push_back(StepReader(parts, *table, lesson).read());
  if (lesson.steps[0].show.empty()) lesson.steps[0].show = show;
  for (std::size_t i = 1; i < lesson.steps.size(); ++i)
    if (lesson.steps[i].show.empty()) lesson.steps[i].show = lesson.steps[i - 1].show;
  lesson.quantities = words.quantities();
}

}  // namespace surefoot
