// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/reading/question_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/lessons/reading/lesson_reading.h"
#include "core/text/printable.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

class QuestionReader {
 public:
  QuestionReader(ReadingParts& parts, const TomlNode& table)
      : parts_(parts),
        table_(table),
        reader_(table, parts.complaints()) {}

  std::optional<LessonQuestion> read() {
    const std::string kind = reader_.neededText("kind");
    if (kind.empty()) return std::nullopt;
    question_ = parts_.neededSaid(reader_, "question");
    auto question = ofKind(kind);
    if (question) reader_.end();
    return question;
  }

 private:
  std::optional<LessonQuestion> ofKind(const std::string& kind) {
    if (kind == "number") return number();
    if (kind == "choice" || kind == "mistake") return choice(kind == "mistake");
    if (kind == "order") return order();
    if (kind == "point") return point();
    if (kind == "words") return WordsQuestion{question_, parts_.neededSaid(reader_, "model")};
    if (kind == "compare") return CompareQuestion{question_};
    reader_.complain("kind", fmt::format("there is no \"{}\"; it takes number, choice, order, point, mistake, compare "
                                         "or words.",
                                         printable(shortened(kind))));
    return std::nullopt;
  }

  LessonQuestion number() {
    NumberQuestion q{.question = question_,
                     .answer = {},
                     .tolerance = reader_.number("tolerance", 0, 1e12, 0),
                     .unit = parts_.said(reader_, "unit")};
    if (reader_.need("answer"))
      if (auto answer = parts_.condition(reader_, table_, "answer", ValueKind::Number)) q.answer = std::move(*answer);
    return q;
  }

  std::vector<std::string> options() {
    std::vector<std::string> all = parts_.allSaid(reader_, "options");
    if (all.size() < 2 || all.size() > kMostOptions)
      reader_.complain("options", fmt::format("there are 2 to {} options.", kMostOptions));
    return all;
  }

  LessonQuestion choice(bool mistake) {
    ChoiceQuestion q{.question = question_,
                     .options = options(),
                     .remarks = parts_.allSaid(reader_, "remarks"),
                     .answer = 0,
                     .why = parts_.said(reader_, "why"),
                     .because = reader_.flag("because"),
                     .mistake = mistake};
    if (!q.remarks.empty() && q.remarks.size() != q.options.size())
      reader_.complain("remarks", "there is one for each option (\"\" for the right one), or none at all.");
    const auto most = std::max<std::int64_t>(static_cast<std::int64_t>(q.options.size()), 1);
    if (reader_.need("answer"))
      q.answer = static_cast<std::size_t>(std::max<std::int64_t>(reader_.whole("answer", 1, most, 1), 1) - 1);
    return q;
  }

  LessonQuestion order() {
    OrderQuestion q{.question = question_, .options = options(), .answer = {}};
    std::set<std::size_t> seen;
    const TomlNode* list = reader_.need("answer");
    for (std::size_t i = 0; list && i < list->list.size(); ++i) {
      const TomlNode& n = list->list[i];
      if (n.kind != TomlNode::Kind::Whole || n.whole < 1 || n.whole > static_cast<std::int64_t>(q.options.size()))
        continue;
      q.answer.push_back(static_cast<std::size_t>(n.whole - 1));
      seen.insert(q.answer.back());
    }
    if (list && (seen.size() != q.options.size() || q.answer.size() != seen.size()))
      reader_.complain("answer", "it names every option once, by its number: [2, 1, 3].");
    return q;
  }

  std::vector<double> place(const char* key) {
    std::vector<double> state;
    const TomlNode* list = reader_.need(key);
    for (std::size_t i = 0; list && i < list->list.size(); ++i) state.push_back(list->list[i].number);
    if (list && state.empty()) state.push_back(list->number);
    return state;
  }

  LessonQuestion point() {
    const std::string on = reader_.text("on", "map");
    if (on != "map" && on != "fall" && on != "action") reader_.complain("on", "it takes map, fall or action.");
    PointQuestion q{.question = question_,
                    .on = on == "fall"     ? PointQuestion::On::Fall
                          : on == "action" ? PointQuestion::On::ActionRow
                                           : PointQuestion::On::Map,
                    .accept = {}};
    parts_.words().known().pointing = true;
    if (reader_.need("accept"))
      if (auto accept = parts_.condition(reader_, table_, "accept", ValueKind::Condition))
        q.accept = std::move(*accept);
    parts_.words().known().pointing = false;
    q.right = place("right");
    q.wrong = place("wrong");
    return q;
  }

  ReadingParts& parts_;
  const TomlNode& table_;
  TomlReader reader_;
  std::string question_;
};

}  // namespace

std::optional<LessonQuestion> readQuestion(ReadingParts& parts, TomlReader& step) {
  const TomlNode* table = step.table("ask");
  return table ? QuestionReader(parts, *table).read() : std::nullopt;
}

}  // namespace surefoot
