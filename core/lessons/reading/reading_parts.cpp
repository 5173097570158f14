// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/reading/reading_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "core/environment_library.h"
#include "core/expression/compile.h"
#include "core/lessons/reading/lesson_reading.h"

namespace surefoot {

namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \n\t"), last = text.find_last_not_of(" \n\t");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

/// What Markdown must not hold: nothing is fetched or drawn from elsewhere.
const char* forbiddenIn(const std::string& text) {
  if (text.find("![") != std::string::npos) return "it shows a picture; a lesson's text has none.";
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const unsigned char next = at + 1 < text.size() ? static_cast<unsigned char>(text[at + 1]) : ' ';
    if (std::isalpha(next) || next == '/' || next == '!') return "it holds HTML; a lesson's text is Markdown.";
  }
  for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1))
    if (text.compare(at + 2, 7, "lesson:") != 0) return "its links lead to lessons: [the cliff](lesson:the-cliff).";
  return nullptr;
}

}  // namespace

std::optional<LessonCondition> ReadingParts::compiled(const std::string& text, TextPlace at, std::string_view key,
                                                      ValueKind wanted) {
  std::size_t character = 0;
  auto expression = compile(text, wanted, words_, character);
  if (expression) {
    std::vector<int> reads = expression->variables();
    return LessonCondition{text, std::move(*expression), std::move(reads)};
  }
  at.column += static_cast<int>(character);
  complaints_.push_back({at, fmt::format("{}: {}", key, expression.error().message)});
  return std::nullopt;
}

std::optional<LessonCondition> ReadingParts::condition(TomlReader& reader, const TomlNode& table, std::string_view key,
                                                       ValueKind wanted) {
  const std::string text = reader.text(key);
  if (text.empty()) return std::nullopt;
  TextPlace at = table.find(key)->at;
  ++at.column;  // behind the quotation mark
  return compiled(text, at, key, wanted);
}

std::vector<LessonCondition> ReadingParts::conditions(TomlReader& reader, const TomlNode& table, std::string_view key) {
  std::vector<LessonCondition> all;
  const std::vector<std::string> texts = reader.texts(key);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    TextPlace at = table.find(key)->list[i].at;
    ++at.column;
    if (auto one = compiled(texts[i], at, key, ValueKind::Condition)) all.push_back(std::move(*one));
  }
  return all;
}

std::string ReadingParts::neededSaid(TomlReader& reader, std::string_view key) {
  return translated(translate_, reader.neededText(key));
}

std::vector<std::string> ReadingParts::allSaid(TomlReader& reader, std::string_view key) {
  std::vector<std::string> all = reader.texts(key);
  for (std::string& one : all) one = translated(translate_, one);
  return all;
}

LessonText ReadingParts::text(TomlReader& reader, const TomlNode& table, std::string_view key) {
  const std::string written = reader.neededText(key), markdown = translated(translate_, written);
  LessonText text;
  if (markdown.empty()) return text;
  std::istringstream in(written);
  int words = 0;
  for (std::string word; in >> word;) ++words;
  if (words > kMostWords)
    reader.complain(key, fmt::format("it has {} words; a step has at most {}.", words, kMostWords));
  if (const char* why = forbiddenIn(markdown)) reader.complain(key, why);
  text.between.emplace_back();
  std::size_t from = 0;
  for (std::size_t open = markdown.find('{'); open != std::string::npos; open = markdown.find('{', from)) {
    const std::size_t close = markdown.find('}', open);
    if (close == std::string::npos) {
      reader.complain(key, "a brace is not closed: {falls} stands for a number.");
      break;
    }
    text.between.back() += markdown.substr(from, open - from);
    const std::string number = markdown.substr(open + 1, close - open - 1);
    if (auto of = compiled(number, table.find(key)->at, fmt::format("{}, {{{}}}", key, number), ValueKind::Number)) {
      text.numbers.push_back(std::move(*of));
      text.between.emplace_back();
    }
    from = close + 1;
  }
  text.between.back() += markdown.substr(from);
  return text;
}

std::optional<LessonAmount> ReadingParts::amount(TomlReader& reader, std::string_view key) {
  const std::string text = reader.text(key);
  if (text.empty()) return std::nullopt;
  auto parsed = parseAmount(text);
  if (parsed && parsed->unit == LessonAmount::Unit::Minutes && !task_.stepTime)
    return reader.complain(key, "this task has no clock; count episodes or steps."), std::nullopt;
  if (!parsed) reader.complain(key, "it takes \"200 episodes\", \"20 minutes\" or \"5000 steps\".");
  return parsed;
}

void ReadingParts::checkName(TomlReader& reader, const std::string& key, const std::string& name) {
  std::optional<Error> why;
  const auto check = [&](const auto& entry) {
    if (!entry) why = entry.error();
  };
  if (key == "policy") check(findEntry(registry_.policies, "policy", name));
  if (key == "agent") check(findEntry(registry_.agents, "agent", name));
  if (key == "scenario") check(findScenario(registry_, lesson_.start.names.environment, name));
  if (why) reader.complain(key, why->message);
}

LessonActions ReadingParts::actions(TomlReader& reader, std::string_view key) {
  LessonActions all;
  for (const TomlNode* table : reader.tables(key)) action(*table, all);
  return all;
}

void ReadingParts::action(const TomlNode& table, LessonActions& all) {
  using Does = LessonAction::Kind;
  TomlReader reader(table, complaints_);
  const std::size_t before = all.size();
  const std::pair<const char*, Does> named[] = {
      {"policy", Does::Policy}, {"agent", Does::Agent}, {"scenario", Does::Scenario}};
  if (const std::string set = reader.text("set"); !set.empty()) all.push_back(setting(reader, set));
  for (const auto& [key, kind] : named)
    if (const std::string name = reader.text(key); !name.empty()) {
      checkName(reader, key, name);
      all.push_back({.kind = kind, .key = key, .value = name});
    }
  if (reader.find("seed"))
    all.push_back(
        {.kind = Does::Seed,
         .seed = static_cast<std::uint64_t>(reader.whole("seed", 0, std::numeric_limits<std::int64_t>::max(), 1))});
  if (reader.flag("restart")) all.push_back({.kind = Does::Restart});
  if (reader.flag("transfer")) all.push_back({.kind = Does::Transfer});
  if (reader.find("push")) all.push_back({.kind = Does::Push, .state = {reader.number("push", -1e3, 1e3, 0)}});
  if (const TomlNode* place = reader.find("place")) {
    LessonAction action{.kind = Does::Place};
    for (const TomlNode& n : place->list) action.state.push_back(n.number);
    if (const Status s = checkState(task_, action.state); !s) reader.complain("place", s.error().message);
    all.push_back(std::move(action));
  }
  if (const auto run = amount(reader, "run")) all.push_back({.kind = Does::Run, .amount = *run});
  reader.end();
  if (all.size() == before)
    complaints_.push_back({table.at, "an action does something: {set = \"policy.epsilon = 0.3\"}, {restart = true}."});
}

/// "policy.epsilon = 0.3"
LessonAction ReadingParts::setting(TomlReader& reader, const std::string& text) {
  const auto equals = text.find('=');
  LessonAction action{.kind = LessonAction::Kind::Set, .key = trimmed(text.substr(0, equals))};
  if (equals == std::string::npos) {
    reader.complain("set", "it takes \"policy.epsilon = 0.3\".");
    return action;
  }
  action.value = trimmed(text.substr(equals + 1));
  Parameters trial = lesson_.start.parameters;
  if (const Status s = trial.set(action.key, std::string_view(action.value)); !s)
    reader.complain("set", s.error().message);
  return action;
}

}  // namespace surefoot
