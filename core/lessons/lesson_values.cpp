// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/lesson_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/lessons/verdict.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

double counterOf(const Life& life, LessonQuantity::Kind kind) {
  using Of = LessonQuantity::Kind;
  const LifeTotals& t = life.log().totals();
  const auto steps = static_cast<double>(life.steps());
  switch (kind) {
    case Of::Episodes:
      return static_cast<double>(t.episodes);
    case Of::Falls:
      return static_cast<double>(t.falls);
    case Of::Successes:
      return static_cast<double>(t.successes);
    case Of::Steps:
      return steps;
    case Of::Minutes:
      return life.simulatedSeconds() / 60;
    case Of::AverageReward:
      return life.log().averageReward();
    case Of::Exploring:
      return steps > 0 ? static_cast<double>(life.agent().explored()) / steps : 0.0;
    default:
      return static_cast<double>(std::count_if(life.changes().begin(), life.changes().end(), [](const Change& c) {
        return c.key == "push" || c.key == "place" || c.key == "go_on";
      }));
  }
}

}  // namespace

LifeFacts factsOf(const Life& life) {
  LifeFacts facts;
  for (std::size_t i = 0; i < facts.size(); ++i) facts[i] = counterOf(life, static_cast<LessonQuantity::Kind>(i));
  return facts;
}

const std::vector<double>* LessonValues::lives(std::size_t way) const {
  const auto found = lives_.find(way);
  return found == lives_.end() ? nullptr : &found->second;
}

std::optional<double> LessonValues::known(const std::map<std::size_t, double>& of, std::size_t step) {
  const auto found = of.find(step);
  return found == of.end() ? std::nullopt : std::optional(found->second);
}

std::span<const double> LessonValues::valuesFor(const LessonCondition& condition, const Life& life,
                                                const PointedAt* place) const {
  for (const int at : condition.reads) {
    const auto i = static_cast<std::size_t>(at);
    values_[i] = valueOf(lesson_->quantities[i], life, place);
  }
  return values_;
}

double LessonValues::ofWay(const LessonQuantity& quantity) const {
  const std::vector<double>* values = lives(quantity.index);
  if (!values || values->empty()) return std::nan("");
  if (quantity.kind == LessonQuantity::Kind::Least) return *std::min_element(values->begin(), values->end());
  if (quantity.kind == LessonQuantity::Kind::Most) return *std::max_element(values->begin(), values->end());
  return std::accumulate(values->begin(), values->end(), 0.0) / static_cast<double>(values->size());
}

double LessonValues::ofTwoWays(const LessonQuantity& quantity) const {
  const std::vector<double>*first = lives(quantity.index), *second = lives(quantity.other);
  if (!first || !second) return std::nan("");
  const Compared compared = compare(*first, *second).answer;
  const bool holds =
      quantity.kind == LessonQuantity::Kind::Lower ? compared == Compared::First : compared != Compared::CannotTell;
  return holds ? 1.0 : 0.0;
}

double LessonValues::valueOf(const LessonQuantity& quantity, const Life& life, const PointedAt* place) const {
  using Of = LessonQuantity::Kind;
  const bool elsewhere = place && !place->state.empty();
  const auto state = elsewhere ? std::span<const double>(place->state) : life.environment().state();
  const ActionValueFunction& values = life.agent().values();
  switch (quantity.kind) {
    case Of::Replays:
      return replays_;
    case Of::Pointed:
      return place ? place->number : std::nan("");
    case Of::Mean:
    case Of::Least:
    case Of::Most:
      return ofWay(quantity);
    case Of::Lower:
    case Of::Tells:
      return ofTwoWays(quantity);
    case Of::Visits:
      return values.visits(state);
    case Of::Parameter:
      return life.parameters().get(quantity.key);
    case Of::State:
      return state[quantity.index];
    case Of::Observed:
      return known(observed_, quantity.index).value_or(std::nan(""));
    case Of::Predicted:
      return known(predicted_, quantity.index).value_or(std::nan(""));
    case Of::ActionValue:
    case Of::Risk:
    case Of::Probability:
      break;
    default:
      return quantity.before ? before_[static_cast<std::size_t>(quantity.kind)] : counterOf(life, quantity.kind);
  }
  here_.evaluate(values, state);
  if (quantity.kind == Of::ActionValue) return here_.q[quantity.index];
  if (quantity.kind == Of::Risk) return here_.risk.empty() ? std::nan("") : 100 * here_.risk[quantity.index];
  pi_.resize(here_.q.size());
  life.policy().probabilities(here_.view(), pi_);
  return pi_[quantity.index];
}

std::string lessonNumber(double value) {
  if (!std::isfinite(value)) return "…";
  const double size = std::abs(value);
  if (value == std::floor(value)) return countText(value);
  std::string text = fixedText(value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 0.1 ? 2 : 3);
  if (text.find('.') == text.npos) return text;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string LessonValues::text(const LessonText& text, const Life& life, const Translate& number) const {
  std::string all = text.empty() ? "" : text.between[0];
  for (std::size_t i = 0; i < text.numbers.size(); ++i)
    all += translated(number, lessonNumber(of(text.numbers[i], life))) + text.between[i + 1];
  return all;
}

}  // namespace surefoot
