// SPDX-License-Identifier: GPL-3.0-or-later
// The models of a grid: scenarios × values of an environment's parameters. Inside the room.
#pragma once

#include "core/robustness/robustness_plan.h"

namespace surefoot {

/// One side of the grid: a parameter of the environment and its values.
struct GridSide {
  Parameter parameter;
  std::vector<double> values;
};

/// `scenario` as in the question; `functions` × `pushes` cells a model. Every model can be made, and every function is
/// one of its task.
Result<std::vector<TriedModel>> makeTriedModels(const Registry& registry, const RobustnessPlan& plan,
                                                const std::vector<const TriedFunction*>& functions,
                                                const std::optional<std::string>& scenario,
                                                const std::vector<GridSide>& sides);

}  // namespace surefoot
