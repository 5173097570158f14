// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/lesson_life.h"

#include <algorithm>

namespace surefoot {

Result<LessonLife> LessonLife::begin(const Registry& registry, const Lesson& lesson, std::uint64_t seed,
                                     const std::atomic<bool>* interrupted) {
  Configuration configuration = lesson.start;
  if (lesson.seedOfStudent) configuration.seed = seed;
  return begin(registry, lesson, std::move(configuration), 0, interrupted);
}

Result<LessonLife> LessonLife::begin(const Registry& registry, const Lesson& lesson, Configuration configuration,
                                     int index, const std::atomic<bool>* interrupted) {
  auto life = makeLife(registry, configuration, index, true);
  if (!life) return life.error();
  (*life)->keepInputs();
  LessonLife lived(registry, LessonValues(lesson), {std::move(configuration), std::move(*life)}, interrupted);
  lived.index_ = index;
  return lived;
}

LessonLife::LessonLife(const Registry& registry, LessonValues values, LifeInHand life,
                       const std::atomic<bool>* interrupted)
    : registry_(&registry),
      interrupted_(interrupted),
      now_(life.now()),
      hand_(std::move(life)),
      values_(std::move(values)) {}

Status LessonLife::beginAgain() {
  auto life = makeLife(*registry_, now_, index_, true);
  if (!life) return life.error();
  (*life)->keepInputs();
  values_.endLife(factsOf(*hand_.life));
  hand_ = {now_, std::move(*life), hand_.learnedFrom};
  return Done{};
}

Status LessonLife::set(const LessonAction& action) {
  if (const Status s = now_.parameters.set(action.key, std::string_view(action.value)); !s) return s;
  const Parameters::Entry* entry = now_.parameters.find(action.key);
  return entry->parameter.when == When::NewTable ? beginAgain() : hand_.life->set(action.key, entry->value);
}

Status LessonLife::setScenario(const std::string& name) {
  const auto entry = findEntry(registry_->scenarios, "scenario", name);
  if (!entry) return entry.error();
  for (const auto& [key, value] : (*entry)->values) {
    if (const Status s = now_.parameters.set(key, value); !s) return s;
    if (const Status s = hand_.life->set(key, value); !s) return s;
  }
  now_.names.scenario = name;
  return Done{};
}

Status LessonLife::act(const LessonActions& actions) {
  for (const LessonAction& action : actions)
    if (const Status s = act(action); !s) return s;
  return Done{};
}

Status LessonLife::act(const LessonAction& action) {
  switch (action.kind) {
    case LessonAction::Kind::Set:
      return set(action);
    case LessonAction::Kind::Policy: {
      now_.names.policy = action.value;
      auto policy = makePolicy(*registry_, action.value, now_.parameters);
      if (!policy) return policy.error();
      hand_.life->setPolicy(action.value, std::move(*policy));
      return Done{};
    }
    case LessonAction::Kind::Agent: {
      Names names = now_.names;
      names.agent = action.value;
      auto changed = configurationUnder(*registry_, now_, names);
      if (!changed) return changed.error();
      now_ = std::move(*changed);
      hand_.learnedFrom = nullptr;  // another rule, another table
      return beginAgain();
    }
    case LessonAction::Kind::Scenario:
      return setScenario(action.value);
    case LessonAction::Kind::Seed:
      now_.seed = action.seed;
      return beginAgain();
    case LessonAction::Kind::Restart:
      return beginAgain();
    case LessonAction::Kind::Transfer:
      hand_.learnedFrom = std::make_shared<const LifeRecord>(record());
      now_ = transferred(*hand_.life, std::move(now_));
      return beginAgain();
    case LessonAction::Kind::Place:
      return hand_.life->place(action.state);
    case LessonAction::Kind::Push:
      return hand_.life->push(action.state.at(0)) ? Status(Done{}) : Error{"there is no body to push."};
    case LessonAction::Kind::Run:
      run(action.amount);
  }
  return Done{};
}

bool LessonLife::goesOn(std::int64_t stepsSoFar) const {
  return stepsSoFar < kMostSteps && !hand_.life->finished() && !(interrupted_ && *interrupted_);
}

double shareOf(const LessonAmount& amount, const LifeFacts& from, const Life& life) {
  const auto passed = [&](LessonQuantity::Kind kind, double now) { return now - from[static_cast<std::size_t>(kind)]; };
  using Of = LessonQuantity::Kind;
  switch (amount.unit) {
    case LessonAmount::Unit::Episodes:
      return passed(Of::Episodes, static_cast<double>(life.log().totals().episodes)) / amount.value;
    case LessonAmount::Unit::Minutes:
      return passed(Of::Minutes, life.simulatedSeconds() / 60) / amount.value;
    case LessonAmount::Unit::Steps:
      break;
  }
  return passed(Of::Steps, static_cast<double>(life.steps())) / amount.value;
}

void LessonLife::step() {
  Life& life = *hand_.life;
  if (life.inEpisode()) {
    const auto state = life.environment().state();
    hand_.last.state.assign(state.begin(), state.end());
    hand_.last.action = life.nextAction();
  }
  life.step();
}

void LessonLife::run(const LessonAmount& amount) {
  const LifeFacts from = factsOf(*hand_.life);
  for (std::int64_t step = 0; goesOn(step) && shareOf(amount, from, *hand_.life) < 1; ++step) this->step();
}

bool LessonLife::runUntil(const LessonCondition& condition) {
  for (std::int64_t step = 0; goesOn(step); ++step) {
    if (holds(condition)) return true;
    this->step();
  }
  return holds(condition);
}

}  // namespace surefoot
