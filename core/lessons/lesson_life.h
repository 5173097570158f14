// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson lived without a window: the life of a student, driven by the actions that a hand could do, and the values of
// the lesson's quantities. Tests and grading live lessons with it.
#pragma once

#include <map>
#include <span>

#include "core/lessons/lesson.h"
#include "core/life/life.h"

namespace surefoot {

class LessonLife {
 public:
  /// No run goes on longer, whatever a condition waits for.
  static constexpr std::int64_t kMostSteps = 20'000'000;

  /// `seed`: of lessons whose seed is the student's.
  static Result<LessonLife> begin(const Registry& registry, const Lesson& lesson, std::uint64_t seed);

  /// Sets, follows a policy, restarts or runs. An error: the life refuses it, or a restart could not be made.
  Status act(const LessonAction& action);
  /// Goes on until the condition holds; false: it did not within kMostSteps, or the values diverged.
  bool runUntil(const LessonCondition& condition);
  void run(const LessonAmount& amount);

  bool holds(const LessonCondition& condition) const { return condition.expression.holds(valuesFor(condition)); }
  double valueOf(const LessonCondition& number) const { return number.expression.evaluate(valuesFor(number)); }
  /// What step `step` (from 0) predicted, and what it came to.
  void predict(std::size_t step, double value) { predicted_[step] = value; }
  void observe(std::size_t step, double value) { observed_[step] = value; }

  const Life& life() const { return *life_; }

 private:
  struct Totals {
    double episodes = 0, falls = 0, successes = 0, steps = 0, minutes = 0, averageReward = 0;
  };
  LessonLife(const Registry& registry, const Lesson& lesson)
      : registry_(&registry),
        lesson_(&lesson),
        values_(lesson.quantities.size()) {}

  static Totals totalsOf(const Life& life);
  /// The values of what the condition names, in their places. Allocates nothing: a run asks after every step.
  std::span<const double> valuesFor(const LessonCondition& condition) const;
  double valueOf(const LessonQuantity& quantity) const;
  Status restart();

  const Registry* registry_;
  const Lesson* lesson_;
  Configuration now_;
  std::unique_ptr<Life> life_;
  Totals before_;  // of the life before
  std::map<std::size_t, double> predicted_, observed_;
  mutable std::vector<double> values_, q_, pi_;  // room for valuesFor()
};

/// Lives through all steps as their solutions say. What does not come out gets a complaint: a task that is done before
/// anything was done, or is not done afterwards; a par that the solution does not keep; a run that does not end; a
/// prediction whose outcome lies outside its range.
std::vector<Complaint> liveThrough(const Registry& registry, const Lesson& lesson, std::uint64_t seed);

}  // namespace surefoot
