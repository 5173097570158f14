// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/robustness/tried_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/environment_library.h"
#include "core/experiment/task_description.h"
#include "core/text/number_text.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

/// The scenarios that were asked for; a null one is the model that the file was learned on.
Result<std::vector<const AssignmentEntry*>> scenariosIn(const Registry& registry, const std::string& environment,
                                                        const std::optional<std::string>& text) {
  if (!text) return std::vector<const AssignmentEntry*>{nullptr};
  auto all = scenariosOf(registry, environment);
  if (all.empty())
    return Error{fmt::format("--scenario: the environment {} has no scenarios; leave the option away.", environment)};
  if (*text == "all") return all;
  const auto names = splitList("--scenario", *text);
  if (!names) return names.error();
  std::vector<const AssignmentEntry*> chosen;
  for (const std::string& name : *names) {
    const auto entry = findScenario(registry, environment, name);
    if (!entry) return entry.error();
    if (std::find(chosen.begin(), chosen.end(), *entry) != chosen.end())
      return Error{fmt::format("--scenario: {} is given twice; give it once.", shortened(name))};
    chosen.push_back(*entry);
  }
  return chosen;
}

Status checkSize(const RobustnessPlan& plan, std::size_t scenarios, const std::vector<GridSide>& sides) {
  double models = static_cast<double>(scenarios);
  for (const GridSide& side : sides) models *= static_cast<double>(side.values.size());
  const double cells = models * static_cast<double>(plan.pushes.size() * plan.functions.size());
  const double trials = cells * static_cast<double>(plan.starts);
  const auto most = [](auto number) { return countText(static_cast<double>(number)); };
  if (models > kMostModels)
    return Error{fmt::format("--scenario and --set: they make {} models; at most {} are allowed.", countText(models),
                             most(kMostModels))};
  if (cells > kMostCells)
    return Error{fmt::format("--push, --scenario and --set: the grid has {} cells; at most {} are allowed.",
                             countText(cells), most(kMostCells))};
  if (trials > static_cast<double>(kMostTrials))
    return Error{fmt::format("--starts: {} cells with {} starts are {} trials; at most {} are allowed.",
                             countText(cells), most(plan.starts), countText(trials), most(kMostTrials))};
  return Done{};
}

/// "friction = 0.05 N m"
std::string settingText(const Parameter& p, double value) {
  const std::string name = p.key.substr(p.key.find('.') + 1);
  const std::string text = p.kind == Kind::Choice ? formatValue(p, value) : fmt::format("{:.4g}", value);
  return fmt::format("{} = {}{}{}", name, text, p.unit.empty() ? "" : " ", p.unit);
}

/// The scenario with values of the grid: number `i` of all their combinations, the last parameter counting fastest.
TriedModel combined(const RobustnessPlan& plan, const AssignmentEntry* scenario, const std::vector<GridSide>& sides,
                    std::size_t i) {
  TriedModel model;
  if (scenario) {
    model.title = scenario->title, model.scenario = scenario->name;
    for (const auto& [key, value] : scenario->values)
      if (key.starts_with("environment.") && plan.robot.parameters.find(key)) model.values.emplace_back(key, value);
  }
  std::vector<std::string> words;
  for (auto side = sides.rbegin(); side != sides.rend(); i /= side->values.size(), ++side) {
    const double value = side->values[i % side->values.size()];
    model.values.insert(model.values.end(), {side->parameter.key, value});
    model.settings.insert(model.settings.begin(), formatValue(side->parameter, value));
    words.insert(words.begin(), settingText(side->parameter, value));
  }
  const std::string settings = fmt::format("{}", fmt::join(words, ", "));
  model.title += model.title.empty() || settings.empty() ? settings : ", " + settings;
  if (model.title.empty()) model.title = "as learned";
  return model;
}

/// Whether a model can be made and the functions are of its task; notes which parameters of the grid have an effect.
Status checkModel(const Registry& registry, const RobustnessPlan& plan, const TriedModel& model,
                  const std::vector<const TriedFunction*>& functions, const std::vector<GridSide>& sides,
                  std::set<std::string>& effective) {
  const Configuration c = plan.modelled(model);
  const auto environment = makeEnvironment(registry, c);
  if (!environment) return Error{fmt::format("the model \"{}\": {}", model.title, environment.error().message)};
  for (const TriedFunction* function : functions)
    if (const Status s = checkTask(*function->file, (*environment)->task()); !s)
      return Error{fmt::format("the model \"{}\": {}", model.title, s.error().message), s.error().kind};
  for (const GridSide& side : sides)
    if (!c.parameters.idleBecauseOf(side.parameter)) effective.insert(side.parameter.key);
  return Done{};
}

}  // namespace

Result<std::vector<TriedModel>> makeTriedModels(const Registry& registry, const RobustnessPlan& plan,
                                                const std::vector<const TriedFunction*>& functions,
                                                const std::optional<std::string>& scenario,
                                                const std::vector<GridSide>& sides) {
  const auto scenarios = scenariosIn(registry, plan.environment, scenario);
  if (!scenarios) return scenarios.error();
  if (const Status s = checkSize(plan, scenarios->size(), sides); !s) return s.error();
  std::size_t combinations = 1;
  for (const GridSide& side : sides) combinations *= side.values.size();
  std::vector<TriedModel> models;
  std::set<std::string> effective;
  for (const AssignmentEntry* entry : *scenarios)
    for (std::size_t i = 0; i < combinations; ++i) {
      models.push_back(combined(plan, entry, sides, i));
      if (const Status s = checkModel(registry, plan, models.back(), functions, sides, effective); !s) return s.error();
    }
  for (const GridSide& side : sides)
    if (!effective.contains(side.parameter.key))
      return Error{fmt::format("{}: it has no effect, because {} is off.", side.parameter.key,
                               plan.modelled(models.back()).parameters.idleBecauseOf(side.parameter)->parameter.key)};
  return models;
}

}  // namespace surefoot
