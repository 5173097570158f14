// SPDX-License-Identifier: GPL-3.0-or-later
// The part of LessonDriver about what the student says.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "ui/language/speech.h"
#include "ui/lessons/driver/lesson_driver.h"

namespace surefoot {

namespace {
constexpr int kTries = 2;  // then the answer is told
}

void LessonDriver::mark(LessonMark mark) {
  mark.seconds = static_cast<double>(clock_.elapsed()) / 1000;
  handIn_.marks.push_back(mark);
  Q_EMIT marked(mark);
}

void LessonDriver::renderText() {
  auto text = std::make_shared<std::string>();
  visit(
      [text, say = step().say](const Life& life, Knowledge& k) { *text = k.values.text(say, life, numbersInLanguage); },
      [this, text] {
        text_ = QString::fromStdString(*text);
        Q_EMIT textChanged();
      });
}

/// The prediction is locked; what it is about is done and lived, and the next step shows what came out.
void LessonDriver::say(double value) {
  if (phase_ != Phase::Open || !step().predict || predicted(number_)) return;
  const LessonPrediction prediction = *step().predict;
  predicted_[number_] = value;
  know([number = number_, value](LessonValues& v) { v.predict(number, value); });
  mark({.kind = LessonMark::Kind::Said, .step = number_, .value = value});
  setPhase(Phase::Running);
  perform(prediction.then, 0, [this, prediction] {
    run({.amount = prediction.after, .turbo = prediction.turbo}, [this, prediction] {
      observe(prediction.of, [this] {
        session_->life().setTurbo(false);
        settled_.reset();
        setPhase(Phase::Open);
        next();
      });
    });
  });
}

void LessonDriver::judge(const LessonVerdict& verdict, LessonMark given) {
  given.right = verdict.right;
  ++tries_;
  if (verdict.right || tries_ >= kTries) answered_.insert(number_);
  mark(std::move(given));
  Q_EMIT judged(verdict);
}

void LessonDriver::choose(std::size_t option, const QString& because) {
  const auto* question = step().ask ? std::get_if<ChoiceQuestion>(&*step().ask) : nullptr;
  if (!question || option >= question->options.size()) return;
  judge(surefoot::judge(*question, option), {.kind = LessonMark::Kind::Answered,
                                             .step = number_,
                                             .text = fmt::format("{}", option + 1),
                                             .because = because.toStdString()});
}

void LessonDriver::order(const std::vector<std::size_t>& order) {
  const auto* question = step().ask ? std::get_if<OrderQuestion>(&*step().ask) : nullptr;
  if (!question) return;
  std::vector<std::size_t> numbers;
  for (const std::size_t i : order) numbers.push_back(i + 1);
  judge(surefoot::judge(*question, order),
        {.kind = LessonMark::Kind::Answered, .step = number_, .text = fmt::format("{}", fmt::join(numbers, " "))});
}

void LessonDriver::number(double value) {
  const auto* question = step().ask ? std::get_if<NumberQuestion>(&*step().ask) : nullptr;
  if (!question) return;
  auto given = std::make_shared<LessonMark>(
      LessonMark{.kind = LessonMark::Kind::Answered, .step = number_, .text = fmt::format("{}", value)});
  auto answer = std::make_shared<double>(0.0);
  visit(
      [answer, given, of = question->answer, record = recorder()](const Life& life, Knowledge& k) {
        *answer = k.values.of(of, life);
        record(life, k, *given);
      },
      [this, answer, given, value] {
        if (const auto* asked = std::get_if<NumberQuestion>(&*step().ask))
          judge(surefoot::judge(*asked, value, *answer), std::move(*given));
      });
}

void LessonDriver::point(const PointedAt& place) {
  const auto* question = step().ask ? std::get_if<PointQuestion>(&*step().ask) : nullptr;
  if (!question || phase_ != Phase::Open) return;
  const std::string at =
      place.state.empty() ? fmt::format("{}", place.number) : fmt::format("{}", fmt::join(place.state, " "));
  auto given =
      std::make_shared<LessonMark>(LessonMark{.kind = LessonMark::Kind::Answered, .step = number_, .text = at});
  auto verdict = std::make_shared<LessonVerdict>();
  visit(
      [verdict, given, accept = question->accept, place, record = recorder()](const Life& life, Knowledge& k) {
        verdict->right = k.values.accepts(accept, life, place);
        verdict->remark = verdict->right ? "" : tr("Not there. Try another place.").toStdString();
        record(life, k, *given);
      },
      [this, verdict, given] { judge(*verdict, std::move(*given)); });
}

void LessonDriver::compared(Compared said) {
  if (lives_.size() != 2) return;
  auto given = std::make_shared<LessonMark>(LessonMark{
      .kind = LessonMark::Kind::Answered, .step = number_, .text = kComparedNames.at(static_cast<std::size_t>(said))});
  visit([given, record = recorder()](const Life& life, Knowledge& k) { record(life, k, *given); },
        [this, given, said] { judge(surefoot::judge(compare(lives_[0], lives_[1]), said), std::move(*given)); });
}

void LessonDriver::words(const QString& text, std::optional<bool> agrees) {
  answered_.insert(number_);
  mark({.kind = LessonMark::Kind::Words, .step = number_, .right = agrees.value_or(false), .text = text.toStdString()});
  Q_EMIT judged({true, ""});
}

LessonDraft LessonDriver::draft() const {
  if (const auto kept = drafts_.find(number_); kept != drafts_.end()) return kept->second;
  for (const auto kind : {LessonMark::Kind::Answered, LessonMark::Kind::Words})
    if (const LessonMark* given = handIn_.last(kind, number_)) return {given->text, given->because};
  return {};
}

void LessonDriver::keepDraft(LessonDraft draft) {
  if (draft == this->draft()) return;
  drafts_[number_] = std::move(draft);
  Q_EMIT drafted();
}

void LessonDriver::takeHint() {
  if (std::exchange(hintTaken_, true)) return;
  mark({.kind = LessonMark::Kind::HintTaken, .step = number_});
}

void LessonDriver::noteReplay() {
  know([](LessonValues& v) { v.replayed(); });
}

}  // namespace surefoot
