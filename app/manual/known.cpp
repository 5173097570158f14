// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual/known.h"

#include "core/environment_library.h"
#include "core/life/rewinding.h"
#include "core/text/number_text.h"
#include "core/text/words.h"

namespace surefoot {

Parameters everyParameter(const Registry& registry) {
  Parameters all;
  for (const PolicyEntry& entry : registry.policies) all.add(*entry.make(), "policy.");
  Rewinding rewinding;
  all.add(rewinding, "life.");
  for (const EnvironmentEntry& environmentEntry : registry.environments) {
    const auto environment = environmentEntry.make();
    all.add(*environment, "environment.");
    for (const AgentEntry& agent : registry.agents)
      for (const FeatureEntry& features : registry.features)
        static_cast<void>(
            static_cast<bool>(agent.declare(environment->task(), features.name, all)));  // a misfit adds nothing
  }
  return all;
}

std::vector<EnvironmentEntry> shelvedRobots(const Registry& registry) {
  std::vector<EnvironmentEntry> robots;
  for (const std::string& name : registry.files ? registry.files->shelved() : std::vector<std::string>()) {
    const auto file = registry.files->open(registry.files->shelvedPath(name));
    if (!file) continue;
    EnvironmentEntry entry = (*file)->entry;
    entry.name = name;
    robots.push_back(std::move(entry));
  }
  return robots;
}

const char* whenName(When when) {
  switch (when) {
    case When::Now:
      return "now";
    case When::NextEpisode:
      return "next episode";
    case When::NewTable:
      break;
  }
  return "new table";
}

std::string rangeText(const Parameter& p) {
  return p.kind == Kind::Choice ? joinWords(p.choices, "or") : boundText(p.low) + " … " + boundText(p.high);
}

}  // namespace surefoot
