// SPDX-License-Identifier: GPL-3.0-or-later
// Whether an answer is right. Any thread.
#pragma once

#include "core/lessons/lesson_values.h"
#include "core/statistics/statistics.h"

namespace surefoot {

struct LessonVerdict {
  bool right = false;
  std::string remark{};  ///< one sentence, or empty
};

/// Wrong options have a remark of their own, or a plain one.
LessonVerdict judge(const ChoiceQuestion& question, std::size_t chosen);
LessonVerdict judge(const NumberQuestion& question, double said, double answer);
LessonVerdict judge(const OrderQuestion& question, const std::vector<std::size_t>& order);

enum class Compared { First, Second, CannotTell };

/// Which of two ways has the smaller mean: told by the 95 % interval of the mean difference of lives with the same
/// seeds (statistics/mean_estimate.h).
struct WaysCompared {
  double first = 0.0, second = 0.0;  ///< the means
  Interval difference{};             ///< second − first
  Compared answer = Compared::CannotTell;
};
WaysCompared compare(const std::vector<double>& first, const std::vector<double>& second);
LessonVerdict judge(const WaysCompared& comparison, Compared said);

/// The mean of a way's lives with its 95 % interval.
Interval meanWithInterval(const std::vector<double>& lives);

}  // namespace surefoot
