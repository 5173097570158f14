// SPDX-License-Identifier: GPL-3.0-or-later
// The names that an expression may use.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/basics/result.h"
#include "core/basics/types.h"

namespace surefoot {

/// What a value is: a number, or a condition, which is 1 or 0. What may be used as both is a Flag.
enum class ValueKind { Number, Condition, Flag };

struct Quantity {
  int place = 0;  ///< where Expression::evaluate finds its value
  ValueKind kind = ValueKind::Number;
  double low = -kInfinity, high = kInfinity;  ///< the values that it can have
};

class Vocabulary {
 public:
  virtual ~Vocabulary() = default;

  /// "falls", "policy.epsilon"; with an argument where parentheses hold a text or a whole number: q("0.75"),
  /// observed(2). The error says why there is no such quantity here; without a message there is none of this name.
  virtual Result<Quantity> find(std::string_view name, std::optional<std::string_view> argument) const = 0;
  /// All names, for "did you mean"; those that take an argument with their parenthesis: "observed(".
  virtual std::vector<std::string> names() const = 0;
  /// Whether uniform(a, b) is allowed.
  virtual bool chance() const { return false; }
};

}  // namespace surefoot
