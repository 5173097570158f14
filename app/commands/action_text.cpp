// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/action_text.h"

#include <fmt/format.h>

#include "core/text/number_text.h"
#include "core/text/words.h"

namespace surefoot {

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
