// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/stored_function.h"

#include <fmt/format.h>

#include "app/requests.h"

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

Result<std::vector<double>> parseState(const std::string& option, const std::string& text, const Task& task) {
  auto state = parseNumbers(option, text);
  if (!state) return state.error();
  if (state->size() == task.state.size()) return state;
  std::vector<std::string> names;
  for (const StateVariable& v : task.state) names.push_back(v.key);
  return Error{fmt::format("{}: {} {} given, and the state has {}: {}.", option, state->size(),
                           state->size() == 1 ? "value is" : "values are", task.state.size(), joinWords(names, "and"))};
}

std::string actionText(const Task& task, std::size_t a) {
  return a < task.actionNames.size() ? task.actionNames[a] : fmt::format("{}", task.actions[a]);
}

}  // namespace surefoot
