// SPDX-License-Identifier: GPL-3.0-or-later
// What a Q-function says of many states at once. Rows are states.
#pragma once

#include "app/library/surefoot.h"
#include "core/action_value.h"
#include "core/basics/result.h"
#include "core/environment.h"
#include "core/policy.h"

namespace surefoot {

/// Some states in a row: [n][state variables].
struct States {
  const double* values = nullptr;
  std::size_t n = 0;
};

/// values[n][actions] ← a layer.
Status valuesOf(const ActionValueFunction& function, const Task& task, int32_t layer, const States& states,
                double* values, std::size_t count);
/// pi[n][actions] ← the probabilities of the actions under a policy.
Status probabilitiesOf(const ActionValueFunction& function, const Task& task, const Policy& policy,
                       const States& states, double* pi, std::size_t count);
/// visits[n] ← how often the features of the state were visited.
Status visitsOf(const ActionValueFunction& function, const Task& task, const States& states, double* visits,
                std::size_t count);
/// The names of the layers that a function has.
std::vector<std::string> layersOf(const ActionValueFunction& function);

}  // namespace surefoot
