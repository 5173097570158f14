// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/configuration.h"

#include <fmt/format.h>

#include <cmath>

namespace surefoot {

namespace {

/// Sets the values of a preset or scenario; `name` empty: the first that is meant for the environment, if any.
Status assign(const std::vector<AssignmentEntry>& entries, std::string_view what, std::string& name, Configuration& c) {
  if (name.empty())
    for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry)
      if (entry->environment == c.names.environment) name = entry->name;
  if (name.empty()) return Done{};
  const auto found = findEntry(entries, what, name);
  if (!found) return found.error();
  const AssignmentEntry& entry = **found;
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

  for (const PolicyEntry& entry : registry.policies) c.parameters.add(*entry.make(), "policy.");
  const auto world = (*environment)->make();
  c.parameters.add(*world, "environment.");
  if (const Status s = (*agent)->declare(world->task(), names.features, c.parameters); !s) return s.error();

  if (const Status s = assign(registry.presets, "preset", c.names.preset, c); !s) return s.error();
  if (const Status s = assign(registry.scenarios, "scenario", c.names.scenario, c); !s) return s.error();
  for (const Assignment& a : assignments)
    if (const Status s = c.parameters.set(a.key, std::string_view(a.value)); !s) return s.error();
  return c;
}

std::vector<std::string> policyKeys(const PolicyEntry& policy) {
  Parameters parameters;
  parameters.add(*policy.make(), "policy.");
  std::vector<std::string> keys;
  for (const auto& entry : parameters.all()) keys.push_back(entry.parameter.key);
  return keys;
}

Result<std::unique_ptr<Policy>> makePolicy(const Registry& registry, const std::string& name,
                                           const Parameters& parameters) {
  const auto entry = findEntry(registry.policies, "policy", name);
  if (!entry) return entry.error();
  auto policy = (*entry)->make();
  parameters.applyTo(*policy, "policy.");
  return policy;
}

Result<std::unique_ptr<Environment>> makeEnvironment(const Registry& registry, const Configuration& c) {
  const auto entry = findEntry(registry.environments, "environment", c.names.environment);
  if (!entry) return entry.error();
  auto environment = (*entry)->make();
  c.parameters.applyTo(*environment, "environment.");
  if (const Status s = environment->check(); !s) return s.error();
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
