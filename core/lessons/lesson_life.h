// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson lived without a window: the life of a student, driven by the actions that a hand could do, and the values of
// the lesson's quantities. Tests and grading live lessons with it.
#pragma once

#include <atomic>

#include "core/lessons/lesson_values.h"
#include "core/lessons/life_record.h"

namespace surefoot {

class LessonLife {
 public:
  /// No run goes on longer, whatever a condition waits for.
  static constexpr std::int64_t kMostSteps = 20'000'000;

  /// `seed`: of lessons whose seed is the student's. `interrupted`, set by anyone, ends every run.
  static Result<LessonLife> begin(const Registry& registry, const Lesson& lesson, std::uint64_t seed,
                                  const std::atomic<bool>* interrupted = nullptr);

  /// Life number `index` (from 0) of a configuration.
  static Result<LessonLife> begin(const Registry& registry, const Lesson& lesson, Configuration configuration,
                                  int index, const std::atomic<bool>* interrupted = nullptr);

  /// A life that was begun elsewhere goes on here.
  LessonLife(const Registry& registry, LessonValues values, LifeInHand life, const std::atomic<bool>* interrupted);

  /// An error: the life refuses it, or a new life could not be made.
  Status act(const LessonAction& action);
  Status act(const LessonActions& actions);
  /// Goes on until the condition holds; false: it did not within kMostSteps, or the values diverged.
  bool runUntil(const LessonCondition& condition);
  void run(const LessonAmount& amount);

  bool holds(const LessonCondition& condition) const { return values_.holds(condition, *hand_.life); }
  double valueOf(const LessonCondition& number) const { return values_.of(number, *hand_.life); }
  LessonValues& values() { return values_; }

  const Life& life() const { return *hand_.life; }
  const Configuration& configuration() const { return now_; }
  LifeRecord record() const { return recordOf(values_.lesson(), hand_.began, *hand_.life, hand_.learnedFrom); }
  LifeInHand take() { return std::move(hand_); }

 private:
  Status set(const LessonAction& action);
  Status setScenario(const std::string& name);
  Status beginAgain();
  bool goesOn(std::int64_t stepsSoFar) const;
  void step();

  const Registry* registry_;
  const std::atomic<bool>* interrupted_;
  int index_ = 0;
  Configuration now_;
  LifeInHand hand_;
  LessonValues values_;
};

/// How far a life has come by an amount since `from`, 0 to 1.
double shareOf(const LessonAmount& amount, const LifeFacts& from, const Life& life);

/// The lives of all ways of a step, with the seeds of lives 0, 1, … : for each way what each of them came to. Ends with
/// an error when interrupted. `begun`: what the lesson's life has now, before the ways' own actions.
Result<std::vector<std::vector<double>>> liveWays(const Registry& registry, const Lesson& lesson,
                                                  const LessonLives& lives, const Configuration& begun,
                                                  const LessonValues& values, int jobs,
                                                  const std::atomic<bool>* interrupted = nullptr);

}  // namespace surefoot
