// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/lesson_life.h"

#include <fmt/format.h>

#include <cmath>

namespace surefoot {

Result<LessonLife> LessonLife::begin(const Registry& registry, const Lesson& lesson, std::uint64_t seed) {
  LessonLife lived(registry, lesson);
  lived.now_ = lesson.start;
  if (lesson.seedOfStudent) lived.now_.seed = seed;
  auto life = makeLife(registry, lived.now_, 0, false);
  if (!life) return life.error();
  lived.life_ = std::move(*life);
  return lived;
}

Status LessonLife::restart() {
  before_ = totalsOf(*life_);
  auto life = makeLife(*registry_, now_, 0, false);
  if (!life) return life.error();
  life_ = std::move(*life);
  return Done{};
}

Status LessonLife::act(const LessonAction& action) {
  switch (action.kind) {
    case LessonAction::Kind::Set: {
      if (const Status s = now_.parameters.set(action.key, action.value); !s) return s;
      const Parameters::Entry* entry = now_.parameters.find(action.key);
      return entry->parameter.when == When::NewTable ? Status(Done{}) : life_->set(action.key, entry->value);
    }
    case LessonAction::Kind::Policy: {
      now_.names.policy = action.value;
      auto policy = makePolicy(*registry_, action.value, now_.parameters);
      if (!policy) return policy.error();
      life_->setPolicy(action.value, std::move(*policy));
      return Done{};
    }
    case LessonAction::Kind::Restart:
      return restart();
    case LessonAction::Kind::Run:
      run(action.amount);
  }
  return Done{};
}

void LessonLife::run(const LessonAmount& amount) {
  const Totals from = totalsOf(*life_);
  const auto passed = [&] {
    switch (amount.unit) {
      case LessonAmount::Unit::Episodes:
        return static_cast<double>(life_->log().totals().episodes) - from.episodes;
      case LessonAmount::Unit::Minutes:
        return life_->simulatedSeconds() / 60 - from.minutes;
      case LessonAmount::Unit::Steps:
        break;
    }
    return static_cast<double>(life_->steps()) - from.steps;
  };
  for (std::int64_t step = 0; step < kMostSteps && passed() < amount.value && !life_->finished(); ++step) life_->step();
}

bool LessonLife::runUntil(const LessonCondition& condition) {
  for (std::int64_t step = 0; step < kMostSteps && !life_->finished(); ++step) {
    if (holds(condition)) return true;
    life_->step();
  }
  return holds(condition);
}

LessonLife::Totals LessonLife::totalsOf(const Life& life) {
  const LifeTotals& t = life.log().totals();
  return {.episodes = static_cast<double>(t.episodes),
          .falls = static_cast<double>(t.falls),
          .successes = static_cast<double>(t.successes),
          .steps = static_cast<double>(life.steps()),
          .minutes = life.simulatedSeconds() / 60,
          .averageReward = life.log().averageReward()};
}

std::span<const double> LessonLife::valuesFor(const LessonCondition& condition) const {
  for (const int place : condition.reads) {
    const auto i = static_cast<std::size_t>(place);
    values_[i] = valueOf(lesson_->quantities[i]);
  }
  return values_;
}

double LessonLife::valueOf(const LessonQuantity& quantity) const {
  using Of = LessonQuantity::Kind;
  const Totals totals = quantity.before ? before_ : totalsOf(*life_);
  const auto known = [&](const std::map<std::size_t, double>& of) {
    const auto found = of.find(quantity.index);
    return found == of.end() ? std::nan("") : found->second;
  };
  const auto state = life_->environment().state();
  switch (quantity.kind) {
    case Of::Episodes:
      return totals.episodes;
    case Of::Falls:
      return totals.falls;
    case Of::Successes:
      return totals.successes;
    case Of::Steps:
      return totals.steps;
    case Of::Minutes:
      return totals.minutes;
    case Of::AverageReward:
      return totals.averageReward;
    case Of::Visits:
      return life_->agent().values().visits(state);
    case Of::Parameter:
      return now_.parameters.get(quantity.key);
    case Of::State:
      return state[quantity.index];
    case Of::Observed:
      return known(observed_);
    case Of::Predicted:
      return known(predicted_);
    case Of::ActionValue:
    case Of::Probability:
      break;
  }
  q_.resize(static_cast<std::size_t>(life_->agent().values().actions()));
  pi_.resize(q_.size());
  life_->agent().values().evaluate(state, Layer::Sum, q_);
  if (quantity.kind == Of::ActionValue) return q_[quantity.index];
  life_->policy().probabilities(q_, pi_);
  return pi_[quantity.index];
}

namespace {

/// One step of a lesson, as its solution says.
void liveStep(LessonLife& lived, const LessonStep& step, std::size_t number, std::vector<Complaint>& complaints) {
  const auto complain = [&](const std::string& sentence) {
    complaints.push_back({step.at, fmt::format("step {}: {}", number + 1, sentence)});
  };
  const auto act = [&](const std::vector<LessonAction>& actions) {
    for (const LessonAction& action : actions)
      if (const Status s = lived.act(action); !s) complain(s.error().message);
  };
  act(step.begin);
  if (step.predict) {
    lived.predict(number, (step.predict->low + step.predict->high) / 2);
    lived.run(step.predict->after);
    const double outcome = lived.valueOf(step.predict->of);
    lived.observe(number, outcome);
    if (outcome < step.predict->low || outcome > step.predict->high)
      complain(fmt::format("it comes to {:.6g}, outside {:g} to {:g}, which can be predicted.", outcome,
                           step.predict->low, step.predict->high));
  }
  if (step.run && step.run->until && !lived.runUntil(*step.run->until))
    complain(fmt::format("the run does not end: {}.", step.run->until->text));
  if (!step.done) return act(step.solution);
  if (lived.holds(*step.done)) complain("the task is done before anything is done.");
  act(step.solution);
  if (!lived.holds(*step.done)) complain(fmt::format("its solution does not do the task: {}.", step.done->text));
  if (step.par && !lived.holds(*step.par))
    complain(fmt::format("its solution does not keep the par: {}.", step.par->text));
}

}  // namespace

std::vector<Complaint> liveThrough(const Registry& registry, const Lesson& lesson, std::uint64_t seed) {
  auto lived = LessonLife::begin(registry, lesson, seed);
  if (!lived) return {{{}, lived.error().message}};
  std::vector<Complaint> complaints;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) liveStep(*lived, lesson.steps[i], i, complaints);
  return complaints;
}

}  // namespace surefoot
