// SPDX-License-Identifier: GPL-3.0-or-later
// A number of a robot's file: written as such, or as an expression in quotes. Values; any thread.
#pragma once

#include <array>
#include <span>

#include "core/expression/expression.h"
#include "core/files/toml_tree.h"

namespace surefoot {

struct Formula {
  Expression expression{};
  TextPlace at{};  ///< where it stands in the file

  /// `values`: what RobotNames gave places to.
  double operator()(std::span<const double> values) const { return expression.evaluate(values); }
};

inline Formula formulaOf(double number, TextPlace at = {}) {
  return {Expression({{Operation::Constant, 0, number}}), at};
}

using FormulaPair = std::array<Formula, 2>;

}  // namespace surefoot
