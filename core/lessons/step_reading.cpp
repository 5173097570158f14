// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/step_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "core/expression/compile.h"
#include "core/lessons/lesson_reading.h"
#include "core/text/printable.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

const std::vector<std::string> kControls = {"run", "restart", "pace", "turbo", "agent", "policy", "environment"};

class StepReader {
 public:
  StepReader(const Registry& registry, const TomlNode& table, Lesson& lesson, LessonWords& words,
             std::vector<Complaint>& complaints)
      : registry_(registry),
        table_(table),
        reader_(table, complaints),
        lesson_(lesson),
        words_(words),
        complaints_(complaints) {}

  LessonStep read(std::vector<bool>& predicts) {
    LessonStep step{.at = table_.at};
    predicts.push_back(table_.find("predict") != nullptr);
    words_.beginStep(predicts);
    step.say = reader_.neededText("say");
    checkWords(step.say);
    step.hint = reader_.text("hint");
    step.show = reader_.texts("show");
    checkShown(step.show);
    step.minutes = reader_.number("minutes", 0, 180, 0);
    step.begin = actions("begin");
    step.predict = prediction();
    step.run = run();
    step.ask = question();
    step.done = condition(reader_, table_, "done", ValueKind::Condition);
    step.par = condition(reader_, table_, "par", ValueKind::Condition);
    step.solution = actions("solution");
    if (step.par && !step.done) reader_.complain("par", "a par belongs to a task, which has done = \"…\".");
    if (step.done && step.solution.empty())
      reader_.complain("done", "a task needs its solution, so that a test can live through it.");
    reader_.end();
    return step;
  }

 private:
  void checkWords(const std::string& text) {
    std::istringstream in(text);
    int words = 0;
    for (std::string word; in >> word;) ++words;
    if (words > kMostWords)
      reader_.complain("say", fmt::format("it has {} words; a step has at most {}.", words, kMostWords));
  }

  void checkShown(const std::vector<std::string>& shown) {
    std::vector<std::string> all = lessonPanels();
    all.insert(all.end(), kControls.begin(), kControls.end());
    for (const auto& entry : lesson_.start.parameters.all()) all.push_back(entry.parameter.key);
    for (const std::string& name : shown) {
      if (std::find(all.begin(), all.end(), name) != all.end()) continue;
      const std::string near = nearestWord(name, all);
      reader_.complain("show", fmt::format("there is no panel or knob \"{}\"{}.", printable(shortened(name)),
                                           near.empty() ? "" : "; did you mean " + near));
    }
  }

  /// The text of a condition or of a number, compiled; its place in the file goes on into the text.
  std::optional<LessonCondition> condition(TomlReader& reader, const TomlNode& table, std::string_view key,
                                           ValueKind wanted) {
    const std::string text = reader.text(key);
    if (text.empty()) return std::nullopt;
    std::size_t at = 0;
    auto compiled = compile(text, wanted, words_, at);
    if (compiled) {
      std::vector<int> reads = compiled->variables();
      return LessonCondition{text, std::move(*compiled), std::move(reads)};
    }
    TextPlace place = table.find(key)->at;
    place.column += static_cast<int>(at) + 1;  // behind the quotation mark
    complaints_.push_back({place, fmt::format("{}: {}", key, compiled.error().message)});
    return std::nullopt;
  }

  std::optional<LessonAmount> amount(TomlReader& reader, std::string_view key) {
    const std::string text = reader.text(key);
    if (text.empty()) return std::nullopt;
    auto parsed = parseAmount(text);
    if (parsed && parsed->unit == LessonAmount::Unit::Minutes && !hasClock())
      return reader.complain(key, "this task has no clock; count episodes or steps."), std::nullopt;
    if (!parsed) reader.complain(key, "it takes \"200 episodes\", \"20 minutes\" or \"5000 steps\".");
    return parsed;
  }
  bool hasClock() const {
    const auto entry = findEntry(registry_.environments, "environment", lesson_.start.names.environment);
    return entry && (*entry)->make()->task().stepTime.has_value();
  }

  std::vector<LessonAction> actions(std::string_view key) {
    std::vector<LessonAction> all;
    for (const TomlNode* table : reader_.tables(key)) {
      TomlReader reader(*table, complaints_);
      if (const std::string set = reader.text("set"); !set.empty()) all.push_back(setting(reader, set));
      if (const std::string policy = reader.text("policy"); !policy.empty()) {
        if (const auto entry = findEntry(registry_.policies, "policy", policy); !entry)
          reader.complain("policy", entry.error().message);
        all.push_back({.kind = LessonAction::Kind::Policy, .key = "policy", .value = policy});
      }
      if (reader.flag("restart")) all.push_back({.kind = LessonAction::Kind::Restart});
      if (const auto amount = this->amount(reader, "run"))
        all.push_back({.kind = LessonAction::Kind::Run, .amount = *amount});
      reader.end();
    }
    return all;
  }

  /// "policy.epsilon = 0.3"
  LessonAction setting(TomlReader& reader, const std::string& text) {
    const auto equals = text.find('=');
    const auto trimmed = [](std::string part) {
      const auto first = part.find_first_not_of(' '), last = part.find_last_not_of(' ');
      return first == std::string::npos ? std::string() : part.substr(first, last - first + 1);
    };
    LessonAction action{.kind = LessonAction::Kind::Set, .key = trimmed(text.substr(0, equals))};
    if (equals == std::string::npos) {
      reader.complain("set", "it takes \"policy.epsilon = 0.3\".");
      return action;
    }
    action.value = trimmed(text.substr(equals + 1));
    Parameters trial = lesson_.start.parameters;
    if (const Status s = trial.set(action.key, action.value); !s) reader.complain("set", s.error().message);
    return action;
  }

  std::optional<LessonPrediction> prediction() {
    const TomlNode* table = reader_.table("predict");
    if (!table) return std::nullopt;
    TomlReader reader(*table, complaints_);
    if (const std::string kind = reader.neededText("kind"); !kind.empty() && kind != "number")
      reader.complain("kind", "what is predicted is a number: kind = \"number\".");
    LessonPrediction p{.unit = reader.text("unit"),
                       .low = reader.number("low", -1e12, 1e12, 0),
                       .high = reader.number("high", -1e12, 1e12, 100),
                       .of = {},
                       .after = {}};
    if (p.low >= p.high) reader.complain("high", fmt::format("{} is not above low, {}.", p.high, p.low));
    if (reader.need("of"))
      if (auto of = condition(reader, *table, "of", ValueKind::Number)) p.of = std::move(*of);
    if (reader.need("after"))
      if (const auto after = amount(reader, "after")) p.after = *after;
    reader.end();
    return p;
  }

  std::optional<LessonRun> run() {
    const TomlNode* table = reader_.table("run");
    if (!table) return std::nullopt;
    TomlReader reader(*table, complaints_);
    LessonRun run{.until = condition(reader, *table, "until", ValueKind::Condition), .turbo = reader.flag("turbo")};
    reader.end();
    return run;
  }

  std::optional<LessonQuestion> question();
  LessonQuestion choice(TomlReader& reader);
  LessonQuestion order(TomlReader& reader);

  const Registry& registry_;
  const TomlNode& table_;
  TomlReader reader_;
  Lesson& lesson_;
  LessonWords& words_;
  std::vector<Complaint>& complaints_;
};

std::optional<LessonQuestion> StepReader::question() {
  const TomlNode* table = reader_.table("ask");
  if (!table) return std::nullopt;
  TomlReader reader(*table, complaints_);
  std::optional<LessonQuestion> question;
  const std::string kind = reader.neededText("kind");
  if (kind == "number") {
    NumberQuestion number{
        .answer = {}, .tolerance = reader.number("tolerance", 0, 1e12, 0), .unit = reader.text("unit")};
    if (reader.need("answer"))
      if (auto answer = condition(reader, *table, "answer", ValueKind::Number)) number.answer = std::move(*answer);
    question = std::move(number);
  } else if (kind == "choice" || kind == "mistake") {
    question = choice(reader);
  } else if (kind == "order") {
    question = order(reader);
  } else if (kind == "point") {
    const std::string on = reader.text("on", "map");
    if (on != "map" && on != "fall" && on != "action") reader.complain("on", "it takes map, fall or action.");
    PointQuestion point{.on = on == "fall"     ? PointQuestion::On::Fall
                              : on == "action" ? PointQuestion::On::ActionRow
                                               : PointQuestion::On::Map,
                        .accept = {}};
    if (reader.need("accept"))
      if (auto accept = condition(reader, *table, "accept", ValueKind::Condition)) point.accept = std::move(*accept);
    question = std::move(point);
  } else if (kind == "words") {
    question = WordsQuestion{reader.neededText("model")};
  } else if (kind == "compare") {
    question = CompareQuestion{reader.texts("options"), reader.neededText("plan")};
  } else if (!kind.empty()) {
    reader.complain("kind", fmt::format("there is no \"{}\"; it takes number, choice, order, point, mistake, compare "
                                        "or words.",
                                        printable(shortened(kind))));
    return std::nullopt;
  }
  reader.end();
  return question;
}

LessonQuestion StepReader::choice(TomlReader& reader) {
  ChoiceQuestion choice{.options = reader.texts("options"),
                        .remarks = reader.texts("remarks"),
                        .answer = 0,
                        .because = reader.flag("because")};
  const auto most = static_cast<std::int64_t>(choice.options.size());
  if (most < 2 || choice.options.size() > kMostOptions)
    reader.complain("options", fmt::format("a choice has 2 to {} options.", kMostOptions));
  if (!choice.remarks.empty() && choice.remarks.size() != choice.options.size())
    reader.complain("remarks", "there is one for each option (\"\" for the right one), or none at all.");
  if (reader.need("answer"))
    choice.answer = static_cast<std::size_t>(
        std::max<std::int64_t>(reader.whole("answer", 1, std::max<std::int64_t>(most, 1), 1), 1) - 1);
  return choice;
}

LessonQuestion StepReader::order(TomlReader& reader) {
  OrderQuestion order{.options = reader.texts("options"), .answer = {}};
  std::set<std::size_t> seen;
  const TomlNode* list = reader.need("answer");
  for (std::size_t i = 0; list && i < list->list.size(); ++i) {
    const TomlNode& n = list->list[i];
    if (n.kind != TomlNode::Kind::Whole || n.whole < 1 || n.whole > static_cast<std::int64_t>(order.options.size()))
      continue;
    order.answer.push_back(static_cast<std::size_t>(n.whole - 1));
    seen.insert(order.answer.back());
  }
  if (list && (seen.size() != order.options.size() || order.answer.size() != seen.size() || seen.size() < 2))
    reader.complain("answer", "it names every option once, by its number: [2, 1, 3].");
  return order;
}

}  // namespace

const std::vector<std::string>& lessonPanels() {
  static const std::vector<std::string> names = {"world", "parameters", "actions", "maps", "reward",
                                                 "falls", "step",       "rule",    "list"};
  return names;
}

void readSteps(const Registry& registry, const std::vector<const TomlNode*>& steps,
               const std::vector<std::string>& show, Lesson& lesson, std::vector<Complaint>& complaints) {
  const auto environment = makeEnvironment(registry, lesson.start);
  if (!environment) return complaints.push_back({{}, environment.error().message});
  LessonWords words((*environment)->task(), lesson.start.parameters);
  std::vector<bool> predicts;
  for (const TomlNode* table : steps)
    lesson.steps.push_back(StepReader(registry, *table, lesson, words, complaints).read(predicts));
  if (lesson.steps[0].show.empty()) lesson.steps[0].show = show;
  for (std::size_t i = 1; i < lesson.steps.size(); ++i)
    if (lesson.steps[i].show.empty()) lesson.steps[i].show = lesson.steps[i - 1].show;
  lesson.quantities = words.quantities();
}

}  // namespace surefoot
