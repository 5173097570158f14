// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/configuration.h"

#include <fmt/format.h>

#include <cmath>

namespace surefoot {

namespace {

Status assign(const AssignmentEntry& entry, std::string_view what, Configuration& c) {
  if (entry.environment != c.names.environment)
    return Error{fmt::format("{}: \"{}\" belongs to the environment {}, not to {}.", what, entry.name,
                             entry.environment, c.names.environment)};
  for (const auto& [key, value] : entry.values)
    if (const Status set = c.parameters.set(key, value); !set) return set;
  return Done{};
}

}  // namespace

Result<Configuration> configure(const Registry& registry, const Names& names,
                                const std::vector<Assignment>& assignments) {
  Configuration c;
  c.names = names;
  const auto environment = findEntry(registry.environments, "environment", names.environment);
  if (!environment) return environment.error();
  const auto features = findEntry(registry.features, "features", names.features);
  if (!features) return features.error();
  const auto agent = findEntry(registry.agents, "agent", names.agent);
  if (!agent) return agent.error();
  const auto policy = findEntry(registry.policies, "policy", names.policy);
  if (!policy) return policy.error();
  const auto preset = findEntry(registry.presets, "preset", names.preset);
  if (!preset) return preset.error();
  const auto scenario = findEntry(registry.scenarios, "scenario", names.scenario);
  if (!scenario) return scenario.error();

  for (const PolicyEntry& entry : registry.policies) {
    const auto prototype = entry.make();
    Fields fields("policy.");
    prototype->declare(fields);
    c.parameters.add(fields);
  }
  const auto world = (*environment)->make();
  Fields fields("environment.");
  world->declare(fields);
  c.parameters.add(fields);
  if (const Status s = (*agent)->declare(world->task(), names.features, c.parameters); !s) return s.error();

  if (const Status s = assign(**preset, "preset", c); !s) return s.error();
  if (const Status s = assign(**scenario, "scenario", c); !s) return s.error();
  for (const Assignment& a : assignments)
    if (const Status s = c.parameters.set(a.key, std::string_view(a.value)); !s) return s.error();
  return c;
}

std::vector<std::string> policyKeys(const PolicyEntry& policy) {
  const auto prototype = policy.make();
  Fields fields("policy.");
  prototype->declare(fields);
  std::vector<std::string> keys;
  for (const auto& field : fields.all()) keys.push_back(field.parameter.key);
  return keys;
}

Result<std::unique_ptr<Policy>> makePolicy(const Registry& registry, const std::string& name,
                                           const Parameters& parameters) {
  const auto entry = findEntry(registry.policies, "policy", name);
  if (!entry) return entry.error();
  auto policy = (*entry)->make();
  Fields fields("policy.");
  policy->declare(fields);
  parameters.apply(fields);
  return policy;
}

Result<std::unique_ptr<Environment>> makeEnvironment(const Registry& registry, const Configuration& c) {
  const auto entry = findEntry(registry.environments, "environment", c.names.environment);
  if (!entry) return entry.error();
  auto environment = (*entry)->make();
  Fields fields("environment.");
  environment->declare(fields);
  c.parameters.apply(fields);
  environment->parametersChanged();
  return environment;
}

Result<std::unique_ptr<Life>> makeLife(const Registry& registry, const Configuration& c, int index, bool keepRows) {
  auto environment = makeEnvironment(registry, c);
  if (!environment) return environment.error();
  auto policy = makePolicy(registry, c.names.policy, c.parameters);
  if (!policy) return policy.error();
  const auto agentEntry = findEntry(registry.agents, "agent", c.names.agent);
  if (!agentEntry) return agentEntry.error();

  const auto life = static_cast<std::uint64_t>(index);
  const Task& task = (*environment)->task();
  auto agent = (*agentEntry)->make({task, c.names.features, c.parameters, deriveSeed(c.seed, life, Stream::Weights)});
  if (!agent) return agent.error();

  LifeLimits limits;
  if (c.episodes) limits.episodes = *c.episodes;
  if (c.minutes) {
    if (!task.stepTime)
      return Error{fmt::format("minutes: the environment {} has no clock; give a number of episodes instead.",
                               c.names.environment)};
    limits.steps = std::llround(*c.minutes * 60.0 / *task.stepTime);
  }
  return std::make_unique<Life>(
      LifeParts{std::move(*environment), std::move(*policy), std::move(*agent), c.parameters, c.names.policy},
      Random(deriveSeed(c.seed, life, Stream::World)), Random(deriveSeed(c.seed, life, Stream::Policy)), limits,
      keepRows);
}

}  // namespace surefoot
