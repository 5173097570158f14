// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/lesson_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <thread>

namespace surefoot {

namespace {

class StepCheck {
 public:
  StepCheck(const Registry& registry, const Lesson& lesson, std::size_t number, LessonLife& lived,
            std::vector<Complaint>& complaints)
      : registry_(registry),
        lesson_(lesson),
        step_(lesson.steps[number]),
        number_(number),
        lived_(lived),
        complaints_(complaints) {}

  /// What happens by itself when the step begins.
  void begin() {
    act(step_.begin);
    if (step_.lives) liveLives(*step_.lives);
    if (step_.run && step_.run->amount) lived_.run(*step_.run->amount);
    if (step_.run && step_.run->until && !lived_.runUntil(*step_.run->until))
      complain(fmt::format("the run does not end: {}.", step_.run->until->text));
  }

  void live(ToldStep* told = nullptr) {
    begin();
    if (told) told->say = lived_.values().text(step_.say, lived_.life());
    if (step_.predict) predict(*step_.predict);
    if (const auto* point = step_.ask ? std::get_if<PointQuestion>(&*step_.ask) : nullptr) this->point(*point);
    if (step_.done)
      task();
    else
      act(step_.solution);
    if (step_.observe) lived_.values().observe(number_, lived_.valueOf(*step_.observe));
    for (const LessonCondition& expected : step_.expect)
      if (!lived_.holds(expected)) complain(fmt::format("the text says what does not hold: {}.", expected.text));
    if (told) told->came = cameTo();
  }

 private:
  /// What the step came to, for whoever writes the lesson.
  std::string cameTo() const {
    std::string text;
    if (const auto observed = lived_.values().observed(number_)) text += fmt::format("  observed: {:.6g}\n", *observed);
    for (std::size_t w = 0; step_.lives && w < step_.lives->ways.size(); ++w)
      if (const auto* values = lived_.values().lives(step_.lives->ways[w].place))
        text += fmt::format("  {}: {:.6g}\n", step_.lives->ways[w].label, fmt::join(*values, " "));
    if (const auto* number = step_.ask ? std::get_if<NumberQuestion>(&*step_.ask) : nullptr)
      text += fmt::format("  answer: {:.6g}\n", lived_.valueOf(number->answer));
    const LifeTotals& totals = lived_.life().log().totals();
    return text + fmt::format("  now: {} episodes, {} falls, {} steps, average reward {:.6g}\n", totals.episodes,
                              totals.falls, lived_.life().steps(), lived_.life().log().averageReward());
  }

  void complain(const std::string& sentence) {
    complaints_.push_back({step_.at, fmt::format("step {}: {}", number_ + 1, sentence)});
  }
  void act(const LessonActions& actions) {
    if (const Status s = lived_.act(actions); !s) complain(s.error().message);
  }

  void liveLives(const LessonLives& lives) {
    const int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const auto results = liveWays(registry_, lesson_, lives, lived_.configuration(), lived_.values(), jobs);
    if (!results) return complain(results.error().message);
    for (std::size_t w = 0; w < lives.ways.size(); ++w) lived_.values().lived(lives.ways[w].place, (*results)[w]);
  }

  void predict(const LessonPrediction& prediction) {
    lived_.values().predict(number_, (prediction.low + prediction.high) / 2);
    act(prediction.then);
    lived_.run(prediction.after);
    const double outcome = lived_.valueOf(prediction.of);
    lived_.values().observe(number_, outcome);
    if (!(outcome >= prediction.low && outcome <= prediction.high))
      complain(fmt::format("it comes to {:.6g}, outside {:g} to {:g}, which can be predicted.", outcome, prediction.low,
                           prediction.high));
  }

  void point(const PointQuestion& point) {
    const auto at = [&](const std::vector<double>& place) {
      return point.on == PointQuestion::On::Map ? PointedAt{place, 0} : PointedAt{{}, place.empty() ? 0 : place[0]};
    };
    const std::size_t size = lived_.life().environment().task().state.size();
    if (point.on == PointQuestion::On::Map && (point.right.size() != size || point.wrong.size() != size))
      return complain(fmt::format("right and wrong are states of {} numbers.", size));
    if (!lived_.values().accepts(point.accept, lived_.life(), at(point.right)))
      complain(fmt::format("what is right is not accepted: {}.", point.accept.text));
    if (lived_.values().accepts(point.accept, lived_.life(), at(point.wrong)))
      complain(fmt::format("what is wrong is accepted: {}.", point.accept.text));
  }

  void task() {
    if (lived_.holds(*step_.done)) complain("the task is done before anything is done.");
    act(step_.solution);
    if (!lived_.holds(*step_.done)) complain(fmt::format("its solution does not do the task: {}.", step_.done->text));
    if (step_.par && !lived_.holds(*step_.par))
      complain(fmt::format("its solution does not keep the par: {}.", step_.par->text));
  }

  const Registry& registry_;
  const Lesson& lesson_;
  const LessonStep& step_;
  const std::size_t number_;
  LessonLife& lived_;
  std::vector<Complaint>& complaints_;
};

}  // namespace

namespace {

/// The lesson again, up to the task of a step, and then done the wrong way.
void liveWrongly(const Registry& registry, const Lesson& lesson, std::size_t number, std::uint64_t seed,
                 std::vector<Complaint>& complaints) {
  auto lived = LessonLife::begin(registry, lesson, seed);
  if (!lived) return;
  std::vector<Complaint> told;
  for (std::size_t i = 0; i < number; ++i) StepCheck(registry, lesson, i, *lived, told).live();
  const LessonStep& step = lesson.steps[number];
  StepCheck(registry, lesson, number, *lived, told).begin();
  if (const Status s = lived->act(step.wrong); !s) told.push_back({step.at, s.error().message});
  if (lived->holds(*step.done))
    complaints.push_back(
        {step.at, fmt::format("step {}: its wrong way does the task: {}.", number + 1, step.done->text)});
}

}  // namespace

std::vector<Complaint> liveThrough(const Registry& registry, const Lesson& lesson, std::uint64_t seed,
                                   std::vector<ToldStep>* told) {
  auto lived = LessonLife::begin(registry, lesson, seed);
  if (!lived) return {{{}, lived.error().message}};
  std::vector<Complaint> complaints;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    ToldStep step;
    StepCheck(registry, lesson, i, *lived, complaints).live(told ? &step : nullptr);
    if (told) told->push_back(std::move(step));
  }
  for (std::size_t i = 0; i < lesson.steps.size(); ++i)
    if (lesson.steps[i].done && !lesson.steps[i].wrong.empty()) liveWrongly(registry, lesson, i, seed, complaints);
  return complaints;
}

}  // namespace surefoot
