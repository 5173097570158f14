// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/saved/stored_function.h"

#include "core/experiment/task_description.h"

namespace surefoot {

Result<std::unique_ptr<Agent>> makeAgent(const Registry& registry, const Configuration& c, const Task& task,
                                         const TensorFile* stored) {
  const auto entry = findEntry(registry.agents, "agent", c.names.agent);
  if (!entry) return entry.error();
  return (*entry)->make({task, c.names.features, c.parameters, deriveSeed(c.seed, 0, Stream::Weights), stored});
}

Result<StoredFunction> openFunction(const Registry& registry, const std::string& path) {
  if (path.empty()) return Error{"FILE: the name of a Q-function is needed, as `surefoot train --save` writes it."};
  auto file = readQFile(path);
  if (!file) return file.error();
  auto configuration = configurationOf(registry, **file);
  if (!configuration) return configuration.error();
  auto environment = makeEnvironment(registry, *configuration);
  if (!environment) return environment.error();
  if (const Status s = checkTask(**file, (*environment)->task()); !s) return s.error();
  auto agent = makeAgent(registry, *configuration, (*environment)->task(), file->get());
  if (!agent) return agent.error();
  return StoredFunction{std::move(*file), std::move(*configuration), std::move(*environment), std::move(*agent)};
}

}  // namespace surefoot
