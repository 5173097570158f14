// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/configuration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/environment_library.h"
#include "core/experiment/configuration_json.h"
#include "core/experiment/task_description.h"
#include "core/life/inputs_text.h"
#include "core/text/number_text.h"

namespace surefoot {

namespace {

/// Sets the values of a preset or scenario; `name` empty: the first that the environment has, if any.
Status assign(const std::vector<const AssignmentEntry*>& own, const Result<const AssignmentEntry*>& named,
              std::string& name, Configuration& c) {
  if (name.empty() && own.empty()) return Done{};
  if (!name.empty() && !named) return named.error();
  const AssignmentEntry& entry = name.empty() ? *own.front() : **named;
  name = entry.name;
  for (const auto& [key, value] : entry.values) {
    // Values for a learning rule or representation that was not chosen have no effect.
    if (!key.starts_with("environment.") && !c.parameters.find(key)) continue;
    if (const Status set = c.parameters.set(key, value); !set) return set;
  }
  return Done{};
}

}  // namespace

bool isMovedByProgram(const Configuration& c) {
  return c.environmentFile && !c.environmentFile->starts.empty();
}

Result<Configuration> configure(const Registry& registry, const Names& names,
                                const std::vector<Assignment>& assignments) {
  Configuration c;
  c.names = names;
  auto named = environmentNamed(registry, names.environment);
  if (!named) return named.error();
  const std::string& here = c.names.environment = std::move(*named);
  const auto environment = findEnvironment(registry, here);
  if (!environment) return environment.error();
  if (registry.files) c.environmentFile = registry.files->find(here);
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
  Rewinding rewinding;
  c.parameters.add(rewinding, "life.");

  std::string &preset = c.names.preset, &scenario = c.names.scenario;
  if (const Status s = assign(presetsOf(registry, here), findPreset(registry, here, preset), preset, c); !s)
    return s.error();
  if (const Status s = assign(scenariosOf(registry, here), findScenario(registry, here, scenario), scenario, c); !s)
    return s.error();
  c.parameters.setUsual();
  for (const Assignment& a : assignments)
    if (const Status s = c.parameters.set(a.key, std::string_view(a.value)); !s) return s.error();
  return c;
}

void leaveTeacher(Configuration& c) {
  c.teacher = nullptr;
  const Parameters::Entry* guardian = c.parameters.find("policy.guardian");
  if (guardian && static_cast<GuardedBy>(guardian->value) == GuardedBy::QFunction)
    static_cast<void>(static_cast<bool>(c.parameters.set("policy.guardian", std::string_view("nobody"))));
}

std::vector<std::string> policyKeys(const PolicyEntry& policy) {
  Parameters parameters;
  parameters.add(*policy.make(), "policy.");
  std::vector<std::string> keys;
  for (const auto& entry : parameters.all()) keys.push_back(entry.parameter.key);
  return keys;
}

Result<Configuration> configurationUnder(const Registry& registry, const Configuration& now, const Names& names) {
  auto changed = configure(registry, names, {});
  if (!changed) return changed;
  for (const auto& entry : now.parameters.all())
    if (changed->parameters.find(entry.parameter.key))
      if (const Status s = changed->parameters.set(entry.parameter.key, entry.value); !s) return s.error();
  changed->seed = now.seed;
  changed->minutes = now.minutes;
  changed->episodes = now.episodes;
  if (names.environment == now.names.environment)
    changed->teacher = now.teacher;
  else
    leaveTeacher(*changed);
  return changed;
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
  const auto entry = findEnvironment(registry, c.names.environment);
  if (!entry) return entry.error();
  auto environment = (*entry)->make();
  c.parameters.applyTo(*environment, "environment.");
  if (const Status s = environment->check(); !s) return s.error();
  environment->parametersChanged();
  return environment;
}

Result<std::unique_ptr<Agent>> makeTeacher(const Registry& registry, const TensorFile& file, const Task& task) {
  if (const Status s = checkTask(file, task); !s) return s.error();
  if (!file.about.contains("configuration")) return fileError(file.name, "it holds no configuration.");
  const auto c = configurationFromJson(registry, file.about["configuration"], file.name);
  if (!c) return c.error();
  const auto entry = findEntry(registry.agents, "agent", c->names.agent);
  if (!entry) return entry.error();
  return (*entry)->make({task, c->names.features, c->parameters, 0, &file});
}

namespace {

/// A command as it will be carried out; refused if there is no such parameter, policy or body, or it needs a new table.
Result<TimedCommand> makeCommand(const Registry& registry, const Configuration& c, const CommandText& text) {
  const Parameter kPush{.key = "push", .unit = "N s", .low = -1e3, .high = 1e3};
  TimedCommand command{.step = text.step, .key = text.key, .value = 0.0, .policy = {}, .policyName = {}};
  if (text.key == "policy") {
    auto policy = makePolicy(registry, text.value, c.parameters);
    if (!policy) return policy.error();
    command.policy = std::move(*policy);
    command.policyName = text.value;
    return command;
  }
  if (text.key == "push") {
    const auto value = parseValue(kPush, text.value);
    if (!value) return value.error();
    command.value = *value;
    return command;
  }
  if (text.key == "place" || text.key == "go_on") return command;  // they are read where the task is known
  Parameters parameters = c.parameters;
  if (const Status s = parameters.set(text.key, std::string_view(text.value)); !s) return s.error();
  const Parameters::Entry* entry = parameters.find(text.key);
  if (entry->parameter.when == When::NewTable)
    return Error{fmt::format("{}: a new table is needed for it, so it cannot change while a life goes on.", text.key)};
  command.value = entry->value;
  return command;
}

/// The state that a life is to be placed in: a list of numbers.
Status readState(const CommandText& text, Environment& environment, std::vector<double>& state) {
  const auto refuse = [&](const std::string& why) {
    return Error{fmt::format("at step {}: place = \"{}\": {}", text.step, text.value, why)};
  };
  const auto numbers = parseNumbers("place", text.value);
  if (!numbers) return refuse("numbers with ; or blanks between them are expected.");
  state = *numbers;
  if (const Status s = checkState(environment.task(), state); !s) return refuse(s.error().message);
  return environment.place(state) ? Status(Done{}) : refuse("this environment begins only where it always does.");
}

Result<LifeLimits> makeLimits(const Configuration& c, const Task& task) {
  LifeLimits limits;
  if (c.episodes) limits.episodes = *c.episodes;
  if (c.until) limits.averageReward = *c.until;
  if (!c.minutes) return limits;
  if (!task.stepTime)
    return Error{fmt::format("minutes: the environment {} has no clock; give a number of episodes instead.",
                             c.names.environment)};
  limits.steps = std::llround(*c.minutes * 60.0 / *task.stepTime);
  return limits;
}

/// Everything that a life is made from; `environment` has its parameters already.
Result<LifeParts> makeParts(const Registry& registry, const Configuration& c, std::uint64_t weightSeed,
                            std::unique_ptr<Environment> environment) {
  auto policy = makePolicy(registry, c.names.policy, c.parameters);
  if (!policy) return policy.error();
  const auto agentEntry = findEntry(registry.agents, "agent", c.names.agent);
  if (!agentEntry) return agentEntry.error();
  const Task& task = environment->task();
  if (c.start)
    if (const Status s = checkTask(*c.start, task); !s) return s.error();
  auto agent = (*agentEntry)->make({task, c.names.features, c.parameters, weightSeed, c.start.get()});
  if (!agent) return agent.error();
  std::unique_ptr<Agent> teacher;
  if (c.teacher) {
    auto made = makeTeacher(registry, *c.teacher, task);
    if (!made) return made.error();
    teacher = std::move(*made);
  }
  if (const Status s = checkRewinding(c.parameters, *environment); !s) return s.error();
  const CautionNeeds has = usableBy((*agent)->values(), task.handMade, teacher != nullptr);
  if (const Status s = (*policy)->caution().check(has); !s) return s.error();
  LifeParts parts{std::move(environment), std::move(*policy), std::move(*agent), c.parameters, c.names.policy, {}};
  parts.preLearned = c.start != nullptr;
  parts.teacher = std::move(teacher);
  if (!parts.environment->task().measures.empty()) {
    auto tests = makeEnvironment(registry, c);
    if (!tests) return tests.error();
    parts.tests = std::move(*tests);
  }
  Configuration then = c;  // the configuration after the commands so far
  for (const CommandText& text : c.commands) {
    auto command = makeCommand(registry, c, text);
    if (!command) return Error{fmt::format("at step {}: {}", text.step, command.error().message)};
    if (command->key == "push" && !parts.environment->push(0.0))
      return Error{
          fmt::format("at step {}: push: the environment {} has no body to push.", text.step, c.names.environment)};
    if (command->key == "place")
      if (const Status s = readState(text, *parts.environment, command->state); !s) return s.error();
    if (command->key == "go_on") {
      auto until = inputsFrom(text.value, parts.environment->task());
      if (!until) return Error{fmt::format("at step {}: {}", text.step, until.error().message)};
      if (!until->pushSteps.empty() && !parts.environment->push(0.0))
        return Error{fmt::format("at step {}: go_on: there is no body to push.", text.step)};
      command->until = std::move(*until);
    }
    if (then.parameters.find(command->key)) {
      if (const Status s = then.parameters.set(command->key, command->value); !s) return s.error();
      const auto possible = makeEnvironment(registry, then);
      const Status s = possible ? checkRewinding(then.parameters, **possible) : Status(possible.error());
      if (!s) return Error{fmt::format("at step {}: {}", text.step, s.error().message)};
    }
    parts.commands.push_back(std::move(*command));
  }
  return parts;
}

}  // namespace

Result<std::unique_ptr<Life>> makeLife(const Registry& registry, const Configuration& c, int index, bool keepRows,
                                       std::int64_t mostSteps) {
  auto environment = makeEnvironment(registry, c);
  if (!environment) return environment.error();
  const auto life = static_cast<std::uint64_t>(index);
  auto limits = makeLimits(c, (*environment)->task());
  if (!limits) return limits.error();
  limits->steps = std::min(limits->steps, mostSteps);
  auto parts = makeParts(registry, c, deriveSeed(c.seed, life, Stream::Weights), std::move(*environment));
  if (!parts) return parts.error();
  parts->testSeed = deriveSeed(c.seed, life, Stream::Tests);
  return std::make_unique<Life>(std::move(*parts), Random(deriveSeed(c.seed, life, Stream::World)),
                                Random(deriveSeed(c.seed, life, Stream::Policy)), *limits, keepRows);
}

Result<std::unique_ptr<Life>> resumeLife(const Registry& registry, const Configuration& now,
                                         const Configuration& inForce, bool keepRows,
                                         const std::vector<Change>& changes, Archive& archive) {
  auto environment = makeEnvironment(registry, inForce);
  if (!environment) return environment.error();
  const auto limits = makeLimits(now, (*environment)->task());
  if (!limits) return limits.error();
  auto parts = makeParts(registry, now, 0, std::move(*environment));
  if (!parts) return parts.error();
  parts->changes = changes;
  auto life = std::make_unique<Life>(std::move(*parts), *limits, keepRows, archive);
  if (!archive.good()) return archive.status().error();
  return life;
}

}  // namespace surefoot
