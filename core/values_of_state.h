// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a policy chooses by in one state, read from a Q-function from outside a learner. Used by one thread.
#pragma once

#include <vector>

#include "core/action_value.h"
#include "core/caution.h"

namespace surefoot {

/// What caution can use of a learner's values, in a task with a hand-made controller or without, with a Q-function as
/// guardian or without.
inline CautionNeeds usableBy(const ActionValueFunction& values, bool handMade, bool guardian) {
  return {.risk = values.hasRisk(), .losses = values.split(), .handMade = handMade, .guardian = guardian};
}

struct ValuesOfState {
  std::vector<double> q{};       ///< q̂(s, ·)
  std::vector<double> risk{};    ///< ρ(s, ·); empty: the function has none
  std::vector<double> losses{};  ///< Q⁻(s, ·); empty: it is not split

  void evaluate(const ActionValueFunction& values, std::span<const double> state) {
    const auto read = [&](Layer layer, bool has, std::vector<double>& row) {
      row.resize(has ? static_cast<std::size_t>(values.actions()) : 0);
      if (has) values.evaluate(state, layer, row);
    };
    read(Layer::Sum, true, q);
    read(Layer::Risk, values.hasRisk(), risk);
    read(Layer::Negative, values.split(), losses);
  }
  ActionView view() const { return {q, risk, losses}; }
};

}  // namespace surefoot
