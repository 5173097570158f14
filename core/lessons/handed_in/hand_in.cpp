// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/handed_in/hand_in.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "core/basics/version.h"
#include "core/files/limited_json.h"
#include "core/life/episode_log.h"
#include "core/life/lives_version.h"

namespace surefoot {

namespace {

constexpr std::size_t kLongestLine = 4u << 20;
constexpr std::size_t kMostMarks = 100'000;
constexpr const char* kFormat = "1.0";

constexpr std::pair<LessonMark::Kind, const char*> kKinds[] = {
    {LessonMark::Kind::Arrived, "arrived"},   {LessonMark::Kind::Said, "said"},
    {LessonMark::Kind::Lived, "lived"},       {LessonMark::Kind::Observed, "observed"},
    {LessonMark::Kind::Answered, "answered"}, {LessonMark::Kind::Done, "done"},
    {LessonMark::Kind::Words, "words"},       {LessonMark::Kind::HintTaken, "hint"},
    {LessonMark::Kind::Finished, "finished"}};

std::uint64_t checkOf(std::uint64_t before, const std::string& line) {
  Hash64 hash;
  hash.add(before);
  hash.add(std::string_view(line));
  return hash.value();
}

std::optional<std::uint64_t> hexIn(const Json& json, const char* key) {
  const std::string text = textIn(json, key);
  std::uint64_t value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (text.empty() || code != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool flagIn(const Json& json, const char* key) {
  return json.contains(key) && json[key].is_boolean() && json[key].get<bool>();
}

Json asJson(const LessonMark& mark) {
  Json json = {{"step", mark.step + 1}, {"seconds", std::round(mark.seconds * 10) / 10}};
  for (const auto& [kind, name] : kKinds)
    if (kind == mark.kind) json["what"] = name;
  const bool judged = mark.kind == LessonMark::Kind::Answered || mark.kind == LessonMark::Kind::Done ||
                      mark.kind == LessonMark::Kind::Words;
  if (judged) json["right"] = mark.right;
  if (mark.kind == LessonMark::Kind::Said || mark.kind == LessonMark::Kind::Observed) json["value"] = mark.value;
  if (!mark.values.empty()) json["values"] = mark.values;
  if (!mark.text.empty()) json["text"] = mark.text;
  if (!mark.because.empty()) json["because"] = mark.because;
  if (mark.life) json["life"] = asJson(*mark.life);
  if (mark.before) json["before"] = asJson(*mark.before);
  return json;
}

/// The life in a mark; nullptr: there is none. False: it is damaged.
bool readLife(const Json& json, const char* key, std::shared_ptr<const LifeRecord>& into) {
  if (!json.contains(key)) return true;
  auto record = lifeRecordOf(json[key]);
  if (!record) return false;
  into = std::make_shared<const LifeRecord>(std::move(*record));
  return true;
}

std::optional<LessonMark> markOf(const Json& json) {
  constexpr double kMostSteps = 1000;
  const std::string what = textIn(json, "what");
  const auto kind = std::find_if(std::begin(kKinds), std::end(kKinds), [&](const auto& k) { return what == k.second; });
  const double step = numberIn(json, "step");
  if (kind == std::end(kKinds) || !(step >= 1 && step <= kMostSteps)) return std::nullopt;
  LessonMark mark{.kind = kind->first,
                  .step = static_cast<std::size_t>(step) - 1,
                  .value = numberIn(json, "value"),
                  .right = flagIn(json, "right"),
                  .text = textIn(json, "text"),
                  .because = textIn(json, "because"),
                  .seconds = numberIn(json, "seconds", 0)};
  for (const Json& value : partOf(json, "values"))
    if (value.is_number()) mark.values.push_back(value.get<double>());
  if (!readLife(json, "life", mark.life) || !readLife(json, "before", mark.before)) return std::nullopt;
  return mark;
}

}  // namespace

std::string HandInWriter::checked(Json json) {
  check_ = checkOf(check_, jsonText(json));
  json["check"] = fmt::format("{:016x}", check_);
  return jsonText(json) + "\n";
}

std::string HandInWriter::header(const HandIn& handIn) {
  return checked({{"surefoot_lesson", kFormat},
                  {"program", kVersion},
                  {"lives_version", kLivesVersion},
                  {"lesson", handIn.lesson},
                  {"lesson_hash", fmt::format("{:016x}", handIn.lessonHash)},
                  {"student", handIn.student},
                  {"seed", handIn.seed}});
}

std::string HandInWriter::line(const LessonMark& mark) {
  return checked(asJson(mark));
}

Result<HandIn> parseHandIn(const std::string& text, std::uint64_t* check) {
  HandIn handIn;
  std::istringstream in(text);
  std::string line;
  std::uint64_t before = 0;
  for (std::size_t number = 1; std::getline(in, line) && number <= kMostMarks; ++number) {
    Json json = parseJson(line, kLongestLine);
    if (number == 1) {
      if (textIn(json, "surefoot_lesson").empty()) return Error{"it is not what a student did in a lesson."};
      if (!textIn(json, "surefoot_lesson").starts_with("1."))
        return Error{"it was written by a later version of Surefoot; this one reads format 1."};
      handIn.lesson = textIn(json, "lesson");
      handIn.student = textIn(json, "student");
      handIn.lessonHash = hexIn(json, "lesson_hash").value_or(0);
      handIn.livesVersion = static_cast<int>(std::clamp(numberIn(json, "lives_version", 0), 0.0, 1e6));
      if (json.contains("seed") && json["seed"].is_number_unsigned()) handIn.seed = json["seed"].get<std::uint64_t>();
    }
    if (!json.is_object()) {
      handIn.damaged.push_back(number);
      continue;
    }
    const auto said = hexIn(json, "check");
    json.erase("check");
    const std::uint64_t now = checkOf(before, jsonText(json));
    if (said != now) handIn.edited.push_back(number);
    before = said.value_or(now);  // the lines behind an edited one are not told as well
    if (number == 1) continue;
    if (auto mark = markOf(json))
      handIn.marks.push_back(std::move(*mark));
    else
      handIn.damaged.push_back(number);
  }
  if (check) *check = before;
  if (handIn.lesson.empty()) return Error{"it does not say of which lesson it is."};
  return handIn;
}

const LessonMark* HandIn::last(LessonMark::Kind kind, std::size_t step) const {
  const auto found =
      std::find_if(marks.rbegin(), marks.rend(), [&](const LessonMark& m) { return m.kind == kind && m.step == step; });
  return found == marks.rend() ? nullptr : &*found;
}

bool HandIn::finished() const {
  return std::any_of(marks.begin(), marks.end(), [](const auto& m) { return m.kind == LessonMark::Kind::Finished; });
}

std::size_t HandIn::reached(const Lesson& of) const {
  if (finished()) return of.steps.size();
  std::size_t most = 0;
  for (const LessonMark& m : marks)
    if (m.kind == LessonMark::Kind::Arrived) most = std::max(most, m.step);
  return std::min(most, of.steps.size() - 1);
}

}  // namespace surefoot
