// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/statistics/mean_estimate.h"
#include "core/text/text.h"

namespace surefoot {

LessonVerdict judge(const ChoiceQuestion& question, std::size_t chosen) {
  if (chosen == question.answer) return {true, question.why};
  const bool has = chosen < question.remarks.size() && !question.remarks[chosen].empty();
  return {false, has ? question.remarks[chosen] : "That does not explain it. Look again at what is on the screen."};
}

LessonVerdict judge(const NumberQuestion& question, double said, double answer) {
  constexpr double kRounding = 1e-9;
  if (std::abs(said - answer) <= question.tolerance + kRounding * std::abs(answer)) return {true, ""};
  return {false, said < answer ? "It is more than that." : "It is less than that."};
}

LessonVerdict judge(const OrderQuestion& question, const std::vector<std::size_t>& order) {
  if (order == question.answer) return {true, ""};
  std::size_t inPlace = 0;
  for (std::size_t i = 0; i < std::min(order.size(), question.answer.size()); ++i)
    inPlace += order[i] == question.answer[i];
  return {false, fmt::format("{} of {} stand where they belong.", inPlace == 0 ? "None" : fmt::format("{}", inPlace),
                             question.answer.size())};
}

Interval meanWithInterval(const std::vector<double>& lives) {
  return intervalOf(estimateOf(lives, Units::each(lives.size())));
}

WaysCompared compare(const std::vector<double>& first, const std::vector<double>& second) {
  const MeanEstimate a = estimateOf(first, Units::each(first.size()));
  const MeanEstimate b = estimateOf(second, Units::each(second.size()));
  WaysCompared result{.first = a.value, .second = b.value, .difference = differenceOf(a, b, true)};
  if (result.difference.low > 0) result.answer = Compared::First;
  if (result.difference.high < 0) result.answer = Compared::Second;
  return result;
}

LessonVerdict judge(const WaysCompared& comparison, Compared said) {
  const std::string interval =
      fmt::format("The mean difference is {}, its 95 % interval {} to {}", fixedText(comparison.difference.value, 1),
                  fixedText(comparison.difference.low, 1), fixedText(comparison.difference.high, 1));
  const bool tells = comparison.answer != Compared::CannotTell;
  return {said == comparison.answer,
          interval + (tells ? ": 0 is not in it." : ": 0 is in it, so one cannot tell from these lives.")};
}

}  // namespace surefoot
