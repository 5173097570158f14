// SPDX-License-Identifier: GPL-3.0-or-later
// Takes numbers out of formulas and complains about those that are not allowed: part of numbersOf().
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/text/number_text.h"
#include "physics/robot/spec/formula.h"
#include "physics/robot/world/robot_numbers.h"

namespace surefoot {

class CheckedNumbers {
 public:
  CheckedNumbers(std::span<const double> values, std::vector<Complaint>& complaints)
      : values_(values),
        complaints_(complaints) {}

  /// `where`: "[body.pole]", or nothing at the top; `what`: "mass"; `unit` stands behind what is allowed.
  double operator()(const Formula& formula, std::string_view where, std::string_view what, double low, double high,
                    std::string_view unit = "") {
    const double value = formula(values_);
    if (value >= low && value <= high) return value;
    complain(formula.at, fmt::format("{}{}{} = {}; allowed is {} … {}{}{}.", where, where.empty() ? "" : ": ", what,
                                     value, boundText(low), boundText(high), unit.empty() ? "" : " ", unit));
    return low > 0.0 ? low : high < 0.0 ? high : 0.0;
  }
  double at(const Formula& formula, std::string_view where, std::string_view what) {
    constexpr double kFarthest = 1e4;  // [m]
    return (*this)(formula, where, what, -kFarthest, kFarthest, "m");
  }
  Point at(const FormulaPair& pair, std::string_view where, std::string_view what) {
    return {at(pair[0], where, what), at(pair[1], where, what)};
  }
  int whole(const Formula& formula, std::string_view what, int low, int high) {
    const double value = (*this)(formula, "", what, low, high);
    if (value != std::floor(value)) complain(formula.at, fmt::format("{}: {} is no whole number.", what, value));
    return static_cast<int>(value);
  }
  void complain(TextPlace at, std::string sentence) { complaints_.push_back({at, std::move(sentence)}); }
  std::size_t wrong() const { return complaints_.size(); }
  std::span<const double> values() const { return values_; }

 private:
  std::span<const double> values_;
  std::vector<Complaint>& complaints_;
};

}  // namespace surefoot
