// SPDX-License-Identifier: GPL-3.0-or-later
// A Q-function from a file, ready to be asked: what query, slice, inspect and resample begin with.
#pragma once

#include "core/experiment/q_file.h"

namespace surefoot {

struct StoredFunction {
  std::shared_ptr<const TensorFile> file;
  Configuration configuration;  ///< that it was learned under
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

/// What to call action `a`: "left", or "0.75" for a torque.
std::string actionText(const Task& task, std::size_t a);

}  // namespace surefoot
