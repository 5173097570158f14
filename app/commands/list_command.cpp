// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.h"
#include "app/reports/list_report.h"
#include "core/environment_library.h"

namespace surefoot {

namespace {

/// Leaves nothing but one environment, with its presets, scenarios and parameters.
Status keepOnly(Registry& registry, const std::string& robot) {
  const auto name = environmentNamed(registry, robot);
  if (!name) return name.error();
  const auto entry = findEnvironment(registry, *name);
  if (!entry) return entry.error();
  std::vector<AssignmentEntry> presets, scenarios;
  for (const AssignmentEntry* preset : presetsOf(registry, *name)) presets.push_back(*preset);
  for (const AssignmentEntry* scenario : scenariosOf(registry, *name)) scenarios.push_back(*scenario);
  registry.environments = {**entry};
  registry.presets = std::move(presets);
  registry.scenarios = std::move(scenarios);
  registry.files = nullptr;
  return Done{};
}

}  // namespace

int listCommand(const Registry& registry, const ListRequest& request) {
  Registry r = registry;
  if (!request.robot.empty())
    if (const Status s = keepOnly(r, request.robot); !s) return fail(s.error());
  return print(request.json ? listAsJson(r) : listAsTable(r));
}

}  // namespace surefoot
