// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/handed_in/class_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "core/text/text.h"

namespace surefoot {

namespace {

ClassCell cellOf(const Lesson& lesson, const HandIn& handIn, std::size_t step) {
  using Kind = LessonMark::Kind;
  const LessonStep& of = lesson.steps[step];
  const LessonMark* said = handIn.last(Kind::Said, step);
  if (of.predict) return said ? ClassCell{ClassCell::State::There, fmt::format("{:.6g}", said->value)} : ClassCell{};
  if (of.done) return handIn.last(Kind::Done, step) ? ClassCell{ClassCell::State::Right, "done"} : ClassCell{};
  const bool words = of.ask && std::holds_alternative<WordsQuestion>(*of.ask);
  if (words) return handIn.last(Kind::Words, step) ? ClassCell{ClassCell::State::There, "own words"} : ClassCell{};
  for (const LessonMark& mark : handIn.marks)  // the first answer is the telling one
    if (mark.kind == Kind::Answered && mark.step == step)
      return {mark.right ? ClassCell::State::Right : ClassCell::State::Wrong, mark.text};
  return {};
}

/// The wrong answer that is given most often.
std::string mostGiven(const LessonStep& step, const std::vector<ClassCell>& answers) {
  std::map<std::string, int> counts;
  int all = 0;
  for (const ClassCell& cell : answers) {
    all += cell.state != ClassCell::State::Nothing;
    if (cell.state == ClassCell::State::Wrong) ++counts[cell.text];
  }
  const auto most =
      std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == counts.end()) return "";
  std::string words = most->first;
  if (const auto* choice = step.ask ? std::get_if<ChoiceQuestion>(&*step.ask) : nullptr) {
    std::size_t option = 0;
    std::from_chars(words.data(), words.data() + words.size(), option);
    if (option >= 1 && option <= choice->options.size()) words = choice->options[option - 1];
  }
  return fmt::format("{} of {} said first: {}", most->second, all, words);
}

/// The middle half of the predictions.
std::string middleOf(const std::vector<ClassCell>& answers) {
  std::vector<double> said;
  for (const ClassCell& cell : answers)
    if (cell.state == ClassCell::State::There) said.push_back(std::strtod(cell.text.c_str(), nullptr));
  if (said.empty()) return "";
  std::sort(said.begin(), said.end());
  const std::size_t n = said.size();
  return fmt::format("half of them say {:.6g} to {:.6g}", said[n / 4], said[n - 1 - n / 4]);
}

}  // namespace

ClassTable classTableOf(const Lesson& lesson, const std::vector<HandIn>& handIns) {
  std::vector<const HandIn*> own;
  for (const HandIn& handIn : handIns)
    if (handIn.lesson == lesson.name) own.push_back(&handIn);
  std::sort(own.begin(), own.end(), [](const HandIn* a, const HandIn* b) { return a->student < b->student; });
  ClassTable table;
  for (const HandIn* handIn : own) {
    table.students.push_back(handIn->student);
    table.cells.emplace_back();
    for (std::size_t step = 0; step < lesson.steps.size(); ++step)
      table.cells.back().push_back(cellOf(lesson, *handIn, step));
  }
  for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
    std::vector<ClassCell> answers;
    ClassStep summary;
    for (const auto& row : table.cells) {
      answers.push_back(row[step]);
      summary.answered += row[step].state != ClassCell::State::Nothing;
      summary.right += row[step].state == ClassCell::State::Right;
    }
    summary.mostSay = lesson.steps[step].predict ? middleOf(answers) : mostGiven(lesson.steps[step], answers);
    table.steps.push_back(std::move(summary));
  }
  return table;
}

}  // namespace surefoot
