// SPDX-License-Identifier: GPL-3.0-or-later
// An expression from a file, compiled once and evaluated often: a number or a condition over named quantities. The
// same bits on every machine; no loops, no memory, no names but those that the vocabulary gives.
//
//   c ? a : b     || or     && and     < <= > >= == !=     + -     * /     - ! not     x^2     ( )     1.5e-3     name
//   abs min max sign floor round sqrt sin cos exp square clamp wrap hypot, and pi
//
// Comparisons do not chain. What stands under "condition" is any of them but a plain number; a condition that is used
// as a number is 1 or 0.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/basics/random.h"

namespace surefoot {

/// x is the last value on the stack, a and b are the last two; results take their places.
enum class Operation : std::uint8_t {
  Constant,       // pushes `number`
  Variable,       // pushes values[place]
  Power,          // to the whole number `place`
  Jump,           // to `place`
  JumpIfFalse,    // to `place`; takes the value
  JumpIfDecided,  // to `place` if x is false (`number` 0) or true (`number` 1), which stays; else takes it
  Clamp,          // the last three are x, low, high
  Uniform,        // a random number in [a, b)
  // of x:
  Minus,
  Not,
  Truth,  // 1 for everything but 0
  Abs,
  Sign,
  Floor,
  Round,  // halves away from 0
  Sqrt,
  Sin,
  Cos,
  Exp,
  Square,
  // of a and b:
  Add,
  Subtract,
  Multiply,
  Divide,
  Less,
  LessOrEqual,
  Greater,
  GreaterOrEqual,
  Equal,
  NotEqual,
  Min,
  Max,
  Wrap,  // a less whole periods b, into [−½ b, ½ b)
  Hypot
};

struct Instruction {
  Operation operation;
  std::int32_t place = 0;
  double number = 0.0;
};

class Expression {
 public:
  static constexpr std::size_t kDeepest = 32;  ///< values on the stack
  static constexpr std::size_t kMostInstructions = 512;

  /// The number 0.
  Expression() : instructions_{{Operation::Constant}} {}
  /// As compile() makes them: the stack never holds more than kDeepest values and ends with one.
  explicit Expression(std::vector<Instruction> instructions) : instructions_(std::move(instructions)) {}

  /// `values` holds every variable's value at the place that the vocabulary gave it. `random`: only for expressions
  /// with chance. Allocates nothing.
  double evaluate(std::span<const double> values, Random* random = nullptr) const {
    const Instruction& first = instructions_.front();
    if (instructions_.size() > 1) return run(values, random);
    return first.operation == Operation::Variable ? values[static_cast<std::size_t>(first.place)] : first.number;
  }
  bool holds(std::span<const double> values, Random* random = nullptr) const { return evaluate(values, random) != 0.0; }

  std::span<const Instruction> instructions() const { return instructions_; }
  /// The places of all variables, each once, in rising order.
  std::vector<int> variables() const;

 private:
  double run(std::span<const double> values, Random* random) const;

  std::vector<Instruction> instructions_;
};

}  // namespace surefoot
