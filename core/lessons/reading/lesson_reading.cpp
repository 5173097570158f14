// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/reading/lesson_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "core/environment_library.h"
#include "core/lessons/reading/step_reading.h"
#include "core/text/printable.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

/// "set.policy.epsilon = 0.05" is a table in tables: the keys with dots, and their values as text.
void flatten(const TomlNode& node, const std::string& key, std::vector<Assignment>& into) {
  switch (node.kind) {
    case TomlNode::Kind::Table:
      for (const auto& [name, child] : node.table) flatten(child, key.empty() ? name : key + "." + name, into);
      return;
    case TomlNode::Kind::Text:
      return into.push_back({key, node.text});
    case TomlNode::Kind::Flag:
      return into.push_back({key, node.flag ? "1" : "0"});
    case TomlNode::Kind::Whole:
      return into.push_back({key, fmt::format("{}", node.whole)});
    case TomlNode::Kind::Number:
    case TomlNode::Kind::List:
      return into.push_back({key, fmt::format("{}", node.number)});
  }
}

/// `range.agent.discount = [0, 1]`: the ends of a knob's slider.
void readRanges(const TomlNode& node, const std::string& key, std::vector<Complaint>& complaints,
                std::map<std::string, std::pair<double, double>>& ranges) {
  if (node.kind == TomlNode::Kind::Table) {
    for (const auto& [name, child] : node.table)
      readRanges(child, key.empty() ? name : key + "." + name, complaints, ranges);
    return;
  }
  const bool two = node.kind == TomlNode::Kind::List && node.list.size() == 2;
  if (two && node.list[0].number < node.list[1].number)
    ranges[key] = {node.list[0].number, node.list[1].number};
  else
    complaints.push_back({node.at, fmt::format("range.{} takes the two ends of a slider: [0, 1].", printable(key))});
}

/// Each is of a parameter that there is, within what it may be.
void checkRanges(const Lesson& lesson, TextPlace at, std::vector<Complaint>& complaints) {
  for (const auto& [key, range] : lesson.ranges) {
    const auto* entry = lesson.start.parameters.find(key);
    if (!entry)
      complaints.push_back({at, fmt::format("range: there is no parameter {} here.", printable(key))});
    else if (range.first < entry->parameter.low || range.second > entry->parameter.high)
      complaints.push_back({at, fmt::format("range.{} goes from {} to {}; it takes {}.", key, range.first, range.second,
                                            allowedValues(entry->parameter))});
  }
}

void readStart(const Registry& registry, TomlReader& root, const std::string& file, Lesson& lesson,
               std::vector<std::string>& show, std::vector<Complaint>& complaints) {
  static const TomlNode kNothing;
  const TomlNode* table = root.table("start");
  TomlReader start(table ? *table : kNothing, complaints);
  Names names;
  names.environment = environmentBeside(file, start.text("environment", names.environment));
  names.preset = start.text("preset");
  names.scenario = start.text("scenario");
  names.agent = start.text("agent", names.agent);
  names.features = start.text("features", names.features);
  names.policy = start.text("policy", names.policy);
  show = start.texts("show");
  std::vector<Assignment> assignments;
  if (const TomlNode* set = start.table("set")) flatten(*set, "", assignments);
  if (const TomlNode* range = start.table("range")) readRanges(*range, "", complaints, lesson.ranges);
  const TomlNode* seed = start.find("seed");
  lesson.seedOfStudent = seed && seed->kind == TomlNode::Kind::Text && seed->text == "student";
  const std::int64_t number =
      lesson.seedOfStudent ? 1 : start.whole("seed", 0, std::numeric_limits<std::int64_t>::max(), 1);
  start.end();
  auto configuration = configure(registry, names, assignments);
  if (!configuration)
    return complaints.push_back({table ? table->at : TextPlace{}, "start: " + configuration.error().message});
  lesson.start = std::move(*configuration);
  lesson.start.seed = static_cast<std::uint64_t>(number);
  checkRanges(lesson, table ? table->at : TextPlace{}, complaints);
}

void readKiosk(TomlReader& root, Lesson& lesson, std::vector<Complaint>& complaints, const Translate& translate) {
  const TomlNode* table = root.table("kiosk");
  if (!table) return;
  TomlReader reader(*table, complaints);
  lesson.kiosk = LessonKiosk{.question = translated(translate, reader.neededText("question")),
                             .note = translated(translate, reader.text("note")),
                             .explain = translated(translate, reader.neededText("explain")),
                             .word = reader.text("word", lesson.name),
                             .share = reader.number("share", 0, 0.5, 0.1),
                             .episodes = reader.whole("episodes", 10, 100'000, 300)};
  reader.end();
}

/// The name without the number in front and the ending: "exploring-costs-falls".
std::string plainName(const std::string& file) {
  std::string name = std::filesystem::path(file).stem().string();
  const auto letter = name.find_first_not_of("0123456789-");
  return letter == std::string::npos ? name : name.substr(letter);
}

/// The number in front of a file's name, without zeros: "5"; empty: none.
std::string numberOf(const std::string& file) {
  const std::string name = std::filesystem::path(file).stem().string();
  const auto first = name.find_first_not_of('0');
  const auto end = name.find_first_not_of("0123456789");
  return first == std::string::npos || end == std::string::npos || end <= first ? "" : name.substr(first, end - first);
}

}  // namespace

std::optional<LessonAmount> parseAmount(std::string_view text) {
  constexpr double kMost = 1e9;
  LessonAmount amount;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), amount.value);
  if (error != std::errc() || !(amount.value > 0) || amount.value > kMost) return std::nullopt;
  std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
  if (unit.size() < 2 || unit[0] != ' ') return std::nullopt;
  unit.remove_prefix(1);
  if (unit.ends_with('s')) unit.remove_suffix(1);
  if (unit == "episode")
    amount.unit = LessonAmount::Unit::Episodes;
  else if (unit == "minute")
    amount.unit = LessonAmount::Unit::Minutes;
  else if (unit == "step")
    amount.unit = LessonAmount::Unit::Steps;
  else
    return std::nullopt;
  const bool whole = amount.value == std::floor(amount.value);
  return whole || amount.unit == LessonAmount::Unit::Minutes ? std::optional(amount) : std::nullopt;
}

std::string complaintText(const std::string& file, const Complaint& complaint) {
  const std::string name = std::filesystem::path(file).filename().string();
  if (complaint.at.line == 0) return fmt::format("{}: {}", name, complaint.sentence);
  return fmt::format("{}, line {}, column {}: {}", name, complaint.at.line, complaint.at.column, complaint.sentence);
}

std::optional<Lesson> readLesson(const Registry& registry, std::string_view toml, const std::string& name,
                                 std::vector<Complaint>& complaints, const Translate& given) {
  complaints.clear();
  if (toml.size() > kLongestLesson) {
    complaints.push_back({{}, fmt::format("a lesson has at most {} kB.", kLongestLesson / 1024)});
    return std::nullopt;
  }
  const auto tree = parseToml(toml, complaints);
  if (!tree) return std::nullopt;
  TomlReader root(*tree, complaints);
  Lesson lesson{.name = plainName(name), .number = numberOf(name)};
  Hash64 hash;
  hash.add(toml);
  lesson.hash = hash.value();
  lesson.language = root.text("language", "en");
  const Translate translate = lesson.language == "en" ? given : Translate();
  const auto text = [&](const char* key) { return translated(translate, root.text(key)); };
  lesson.title = translated(translate, root.neededText("title"));
  lesson.goal = translated(translate, root.neededText("goal"));
  lesson.line = root.find("line") ? text("line") : lesson.goal;
  lesson.about = text("about");
  lesson.chapter = text("chapter");
  lesson.minutes = root.number("minutes", 1, 180, 10);
  lesson.level = static_cast<int>(root.whole("level", 1, 3, 1));
  lesson.needs = root.texts("needs");
  std::vector<std::string> show;
  readStart(registry, root, name, lesson, show, complaints);
  if (const TomlNode* teacher = root.table("teacher")) {
    TomlReader reader(*teacher, complaints);
    lesson.notes = translated(translate, reader.text("notes"));
    lesson.discuss = reader.texts("discuss");
    for (std::string& one : lesson.discuss) one = translated(translate, one);
    reader.end();
  }
  readKiosk(root, lesson, complaints, translate);
  const auto steps = root.tables("step");
  root.end();
  if (steps.empty() || steps.size() > kMostSteps)
    complaints.push_back({{}, fmt::format("a lesson has 1 to {} steps: [[step]].", kMostSteps)});
  if (!complaints.empty()) return std::nullopt;  // conditions can be checked only if the life can be lived
  readSteps(registry, steps, show, lesson, complaints, translate);
  return complaints.empty() ? std::optional(std::move(lesson)) : std::nullopt;
}

}  // namespace surefoot
