// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/expression/expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/basics/portable_math.h"

namespace surefoot {

namespace {

double power(double x, std::int32_t n) {
  double product = 1.0;
  for (std::int32_t i = 0; i < n; ++i) product *= x;
  return product;
}

double sign(double x) {
  return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0;
}

double wrap(double x, double period) {
  return x - period * std::floor(x / period + 0.5);
}

double clamp(double x, double low, double high) {
  return x < low ? low : high < x ? high : x;
}

double ofOne(Operation operation, double x) {
  switch (operation) {
    case Operation::Minus:
      return -x;
    case Operation::Not:
      return x == 0.0 ? 1.0 : 0.0;
    case Operation::Truth:
      return x == 0.0 ? 0.0 : 1.0;
    case Operation::Abs:
      return std::abs(x);
    case Operation::Sign:
      return sign(x);
    case Operation::Floor:
      return std::floor(x);
    case Operation::Round:
      return std::round(x);
    case Operation::Sqrt:
      return std::sqrt(x);
    case Operation::Sin:
      return portableSin(x);
    case Operation::Cos:
      return portableCos(x);
    case Operation::Exp:
      return portableExp(x);
    default:
      return x * x;
  }
}

double ofTwo(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::Add:
      return a + b;
    case Operation::Subtract:
      return a - b;
    case Operation::Multiply:
      return a * b;
    case Operation::Divide:
      return a / b;
    case Operation::Less:
      return a < b ? 1.0 : 0.0;
    case Operation::LessOrEqual:
      return a <= b ? 1.0 : 0.0;
    case Operation::Greater:
      return a > b ? 1.0 : 0.0;
    case Operation::GreaterOrEqual:
      return a >= b ? 1.0 : 0.0;
    case Operation::Equal:
      return a == b ? 1.0 : 0.0;
    case Operation::NotEqual:
      return a != b ? 1.0 : 0.0;
    case Operation::Min:
      return b < a ? b : a;
    case Operation::Max:
      return a < b ? b : a;
    case Operation::Wrap:
      return wrap(a, b);
    default:
      return std::sqrt(a * a + b * b);
  }
}

}  // namespace

double Expression::evaluate(std::span<const double> values, Random* random) const {
  std::array<double, kDeepest> stack;  // NOLINT: every place is written before it is read
  std::size_t top = 0;                 // number of values
  for (std::size_t i = 0; i < instructions_.size(); ++i) {
    const Instruction& in = instructions_[i];
    switch (in.operation) {
      case Operation::Constant:
        stack[top++] = in.number;
        break;
      case Operation::Variable:
        stack[top++] = values[static_cast<std::size_t>(in.place)];
        break;
      case Operation::Power:
        stack[top - 1] = power(stack[top - 1], in.place);
        break;
      case Operation::Jump:
        i = static_cast<std::size_t>(in.place) - 1;
        break;
      case Operation::JumpIfFalse:
        if (stack[--top] == 0.0) i = static_cast<std::size_t>(in.place) - 1;
        break;
      case Operation::JumpIfDecided:
        if ((stack[top - 1] != 0.0) == (in.number != 0.0)) {
          stack[top - 1] = in.number;
          i = static_cast<std::size_t>(in.place) - 1;
        } else {
          --top;
        }
        break;
      case Operation::Clamp:
        top -= 2;
        stack[top - 1] = clamp(stack[top - 1], stack[top], stack[top + 1]);
        break;
      case Operation::Uniform:
        --top;
        stack[top - 1] = random->uniform(stack[top - 1], stack[top]);
        break;
      default:
        if (in.operation >= Operation::Add) --top;
        stack[top - 1] = in.operation < Operation::Add ? ofOne(in.operation, stack[top - 1])
                                                       : ofTwo(in.operation, stack[top - 1], stack[top]);
    }
  }
  return stack[0];
}

std::vector<int> Expression::variables() const {
  std::set<int> places;
  for (const Instruction& in : instructions_)
    if (in.operation == Operation::Variable) places.insert(in.place);
  return {places.begin(), places.end()};
}

}  // namespace surefoot
