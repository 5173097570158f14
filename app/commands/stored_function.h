// SPDX-License-Identifier: GPL-3.0-or-later
// A Q-function from a file, ready for use by query, slice, inspect and resample.
#pragma once

#include "core/saved/q_file.h"

namespace surefoot {

struct StoredFunction {
  std::shared_ptr<const TensorFile> file;
  Configuration configuration;  ///< the configuration that it was learned under
  std::unique_ptr<Environment> environment;
  std::unique_ptr<Agent> agent;

  const Task& task() const { return environment->task(); }
  const ActionValueFunction& values() const { return agent->values(); }
};

Result<StoredFunction> openFunction(const Registry& registry, const std::string& path);

/// An agent for a configuration; begins with `stored` if that is given.
Result<std::unique_ptr<Agent>> makeAgent(const Registry& registry, const Configuration& configuration, const Task& task,
                                         const TensorFile* stored);

/// The values of the state variables from "0.1,0,0", each in its range.
Result<std::vector<double>> parseState(const std::string& option, const std::string& text, const Task& task);

/// Action `a` in physical units, one value per action variable: {0.75} [N m], {-8.9, 0, 8.9} [V].
std::vector<double> actionValues(const Task& task, std::size_t a);

/// The name of action `a`: "left", "0.75" for a torque, "-8.9 0 8.9" for three voltages.
std::string actionText(const Task& task, std::size_t a);

/// The same with the unit: "0.75 N m".
std::string actionWithUnit(const Task& task, std::size_t a);

}  // namespace surefoot
