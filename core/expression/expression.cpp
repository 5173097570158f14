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

}  // namespace

// One switch for all: an expression is evaluated in every substep of a robot.
double Expression::run(std::span<const double> values, Random* random) const {
  constexpr std::size_t kBelow = 2;             // so that the last two can be named even if there are none
  std::array<double, kBelow + kDeepest> stack;  // NOLINT: every place is written before it is read
  double* top = stack.data() + kBelow;          // behind the last value
  const auto push = [&](double x) { *top++ = x; };
  const auto pop = [&] { return *--top; };
  const Instruction* const begin = instructions_.data();
  const Instruction* const end = begin + instructions_.size();
  for (const Instruction* in = begin; in != end; ++in) {
    double& a = top[-2];  // of an operation with two; b is taken from the stack
    double& x = top[-1];  // of an operation with one
    switch (in->operation) {
      // clang-format off
      case Operation::Constant: push(in->number); break;
      case Operation::Variable: push(values[static_cast<std::size_t>(in->place)]); break;
      case Operation::Power: x = power(x, in->place); break;
      case Operation::Jump: in = begin + in->place - 1; break;
      case Operation::JumpIfFalse: if (pop() == 0.0) in = begin + in->place - 1; break;
      case Operation::JumpIfDecided:
        if ((x != 0.0) == (in->number != 0.0)) { x = in->number; in = begin + in->place - 1; } else { --top; }
        break;
      case Operation::Clamp: { const double high = pop(), low = pop(); top[-1] = clamp(top[-1], low, high); break; }
      case Operation::Uniform: { const double high = pop(); top[-1] = random->uniform(top[-1], high); break; }
      case Operation::Minus: x = -x; break;
      case Operation::Not: x = x == 0.0 ? 1.0 : 0.0; break;
      case Operation::Truth: x = x == 0.0 ? 0.0 : 1.0; break;
      case Operation::Abs: x = std::abs(x); break;
      case Operation::Sign: x = sign(x); break;
      case Operation::Floor: x = std::floor(x); break;
      case Operation::Round: x = std::round(x); break;
      case Operation::Sqrt: x = std::sqrt(x); break;
      case Operation::Sin: x = portableSin(x); break;
      case Operation::Cos: x = portableCos(x); break;
      case Operation::Exp: x = portableExp(x); break;
      case Operation::Square: x = x * x; break;
      case Operation::Add: a += pop(); break;
      case Operation::Subtract: a -= pop(); break;
      case Operation::Multiply: a *= pop(); break;
      case Operation::Divide: a /= pop(); break;
      case Operation::Less: a = a < pop() ? 1.0 : 0.0; break;
      case Operation::LessOrEqual: a = a <= pop() ? 1.0 : 0.0; break;
      case Operation::Greater: a = a > pop() ? 1.0 : 0.0; break;
      case Operation::GreaterOrEqual: a = a >= pop() ? 1.0 : 0.0; break;
      case Operation::Equal: a = a == pop() ? 1.0 : 0.0; break;
      case Operation::NotEqual: a = a != pop() ? 1.0 : 0.0; break;
      case Operation::Min: { const double b = pop(); a = b < a ? b : a; break; }
      case Operation::Max: { const double b = pop(); a = a < b ? b : a; break; }
      case Operation::Wrap: a = wrap(a, pop()); break;
      case Operation::Hypot: { const double b = pop(); a = std::sqrt(a * a + b * b); break; }
        // clang-format on
    }
  }
  return stack[kBelow];
}

std::vector<int> Expression::variables() const {
  std::set<int> places;
  for (const Instruction& in : instructions_)
    if (in.operation == Operation::Variable) places.insert(in.place);
  return {places.begin(), places.end()};
}

}  // namespace surefoot
