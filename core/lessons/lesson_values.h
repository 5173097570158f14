// SPDX-License-Identifier: GPL-3.0-or-later
// The values of a lesson's quantities at a moment of a life. A copy is independent: the window evaluates conditions on
// the learner's thread with a copy of its own.
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "core/lessons/lesson.h"
#include "core/life/life.h"
#include "core/text/translate.h"
#include "core/values_of_state.h"

namespace surefoot {

/// The counters of a life that conditions can name, by their kinds.
using LifeFacts = std::array<double, kLifeCounters>;
LifeFacts factsOf(const Life& life);

/// A number as a lesson shows it: whole ones as they are, others in about three digits, without zeros at the end.
std::string lessonNumber(double value);

/// A place of the map, or the episode of a fall, or an action.
struct PointedAt {
  std::vector<double> state{};  ///< empty: the state of the life
  double number = 0.0;
};

class LessonValues {
 public:
  explicit LessonValues(const Lesson& lesson) : lesson_(&lesson), values_(lesson.quantities.size()) {}

  const Lesson& lesson() const { return *lesson_; }
  bool holds(const LessonCondition& condition, const Life& life) const {
    return condition.expression.holds(valuesFor(condition, life, nullptr));
  }
  double of(const LessonCondition& number, const Life& life) const {
    return number.expression.evaluate(valuesFor(number, life, nullptr));
  }
  /// A condition about a place that is pointed at.
  bool accepts(const LessonCondition& condition, const Life& life, const PointedAt& place) const {
    return condition.expression.holds(valuesFor(condition, life, &place));
  }
  /// The text with its numbers as lessonNumber() writes them, and `number` for the reader's language.
  std::string text(const LessonText& text, const Life& life, const Translate& number = {}) const;

  /// Another life begins: what "before." names is this one.
  void endLife(const LifeFacts& facts) { before_ = facts; }
  const LifeFacts& before() const { return before_; }
  /// What step `step` (from 0) predicted, and what it came to.
  void predict(std::size_t step, double value) { predicted_[step] = value; }
  void observe(std::size_t step, double value) { observed_[step] = value; }
  std::optional<double> predicted(std::size_t step) const { return known(predicted_, step); }
  std::optional<double> observed(std::size_t step) const { return known(observed_, step); }
  /// What the lives of a way came to.
  void lived(std::size_t way, std::vector<double> values) { lives_[way] = std::move(values); }
  const std::vector<double>* lives(std::size_t way) const;
  void replayed() { ++replays_; }

 private:
  /// The values of what the condition names, in their places. Allocates nothing: a run asks after every step.
  std::span<const double> valuesFor(const LessonCondition& condition, const Life& life, const PointedAt* place) const;
  double valueOf(const LessonQuantity& quantity, const Life& life, const PointedAt* place) const;
  double ofWay(const LessonQuantity& quantity) const;
  double ofTwoWays(const LessonQuantity& quantity) const;
  static std::optional<double> known(const std::map<std::size_t, double>& of, std::size_t step);

  const Lesson* lesson_;
  LifeFacts before_{};
  std::map<std::size_t, double> predicted_, observed_;
  std::map<std::size_t, std::vector<double>> lives_;
  double replays_ = 0;
  mutable ValuesOfState here_;
  mutable std::vector<double> values_, pi_;  // room for valuesFor()
};

}  // namespace surefoot
