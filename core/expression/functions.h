// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of expressions.
#pragma once

#include <string_view>

#include "core/expression/expression.h"

namespace surefoot {

struct ExpressionFunction {
  std::string_view name;
  Operation operation;
  int arguments;
};

inline constexpr ExpressionFunction kExpressionFunctions[] = {
    {"abs", Operation::Abs, 1},     {"sign", Operation::Sign, 1},   {"floor", Operation::Floor, 1},
    {"round", Operation::Round, 1}, {"sqrt", Operation::Sqrt, 1},   {"sin", Operation::Sin, 1},
    {"cos", Operation::Cos, 1},     {"exp", Operation::Exp, 1},     {"square", Operation::Square, 1},
    {"min", Operation::Min, 2},     {"max", Operation::Max, 2},     {"wrap", Operation::Wrap, 2},
    {"hypot", Operation::Hypot, 2}, {"clamp", Operation::Clamp, 3}, {"uniform", Operation::Uniform, 2}};

}  // namespace surefoot
