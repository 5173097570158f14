// SPDX-License-Identifier: GPL-3.0-or-later
// A Q-function from a file, ready to be asked. Used by one thread.
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

}  // namespace surefoot
