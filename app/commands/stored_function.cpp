// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/stored_function.h"

#include <fmt/format.h>

#include "app/requests/requests.h"
#include "core/experiment/task_description.h"
#include "core/text/number_text.h"
#include "core/text/words.h"

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

std::vector<double> actionValues(const Task& task, std::size_t a) {
  if (task.actionVariables.empty()) return {task.actions[a]};
  std::vector<double> values;
  for (std::size_t j = 0; j < task.actionVariables.size(); ++j)
    values.push_back(task.actionVariables[j].levels[levelOf(task, a, j)]);
  return values;
}

std::string actionText(const Task& task, std::size_t a) {
  if (a < task.actionNames.size()) return task.actionNames[a];
  if (task.actionVariables.empty()) return fmt::format("{}", task.actions[a]);
  std::vector<std::string> texts;
  for (const double value : actionValues(task, a)) texts.push_back(fmt::format("{:.5g}", value));
  return fmt::format("{}", fmt::join(texts, " "));
}

std::string actionWithUnit(const Task& task, std::size_t a) {
  const std::string text = actionText(task, a);
  return task.actionUnit.empty() || a < task.actionNames.size() ? text : text + " " + task.actionUnit;
}

}  // namespace surefoot
