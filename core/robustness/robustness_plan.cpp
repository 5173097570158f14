// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/robustness/robustness_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/environment_library.h"
#include "core/robustness/tried_models.h"
#include "core/robustness/value_list.h"
#include "core/saved/q_file.h"
#include "core/text/number_text.h"
#include "core/text/shell_text.h"
#include "core/text/text.h"
#include "core/text/words.h"
#include "core/values_of_state.h"

namespace surefoot {

namespace {

constexpr double kLongest = 3600.0, kLatest = 600.0;  // [s]
constexpr const char* kUsualPushAt = "0..5";
constexpr double kUsualSeconds = 10.0;
constexpr std::int64_t kLongestEpisode = 10'000;  // [steps] of a task without a clock
constexpr std::uint64_t kMostStarts = 1'000'000;

using Functions = std::vector<const TriedFunction*>;

/// When it is pushed, and how long it is followed.
Status setTimes(const RobustnessQuestion& q, const Task& task, RobustnessPlan& plan) {
  plan.stepTime = task.stepTime;
  if (!task.stepTime) {
    for (const auto& [option, given] : {std::pair{"--seconds", &q.seconds}, {"--push-at", &q.pushAt}})
      if (*given)
        return Error{
            fmt::format("{}: the environment {} has no clock; leave the option away.", option, plan.environment)};
    plan.after = kLongestEpisode;
    return Done{};
  }
  double seconds = kUsualSeconds;
  if (q.seconds) {
    const auto value = parseNumber("--seconds", *q.seconds);
    if (!value || !(*value > 0 && *value <= kLongest))
      return Error{
          fmt::format("--seconds: \"{}\" is no time above 0 s and up to {:.0f} s.", shortened(*q.seconds), kLongest)};
    seconds = *value;
  }
  const std::string text = q.pushAt.value_or(kUsualPushAt);
  const auto span = parseSpan("--push-at", text);
  if (!span) return span.error();
  if (!(span->first >= 0 && span->second <= kLatest))
    return Error{fmt::format("--push-at: \"{}\" is no time from 0 to {:.0f} s, nor two with .. between them.",
                             shortened(text), kLatest)};
  const auto steps = [&](double time) { return std::llround(time / *task.stepTime); };
  plan.earliest = steps(span->first), plan.latest = steps(span->second);
  plan.after = std::max(1LL, steps(seconds));
  return Done{};
}

Status setNumbers(const RobustnessQuestion& q, Environment& environment, RobustnessPlan& plan) {
  const Parameter push{.key = "--push", .unit = "N s", .low = -1e3, .high = 1e3};
  auto pushes = parseValues(push, q.push.value_or("0"));
  if (!pushes) return pushes.error();
  plan.pushes = std::move(*pushes);
  const bool pushed = std::any_of(plan.pushes.begin(), plan.pushes.end(), [](double impulse) { return impulse != 0; });
  if (pushed && !environment.push(0.0))
    return Error{fmt::format("--push: the environment {} has no body to push.", plan.environment)};
  if (q.starts) {
    const auto starts = parseWhole("--starts", *q.starts, 1, kMostStarts);
    if (!starts) return starts.error();
    plan.starts = static_cast<std::int64_t>(*starts);
  }
  if (q.seed) {
    const auto seed = parseSeed("--seed", *q.seed);
    if (!seed) return seed.error();
    plan.seed = *seed;
  }
  return Done{};
}

/// Whether they can be tried on one robot; tells where they were learned on different ones.
Status checkPair(const Functions& functions, std::string& note) {
  const Configuration &first = functions.front()->configuration, &second = functions.back()->configuration;
  if (plainName(first.names.environment) != plainName(second.names.environment))
    return Error{fmt::format(
        "{} was learned on {}, and {} on {}; two of one environment can be held against each other.",
        functions.front()->name, first.names.environment, functions.back()->name, second.names.environment)};
  std::vector<std::string> others;
  for (const Parameters::Entry& entry : first.parameters.all()) {
    const std::string& key = entry.parameter.key;
    const Parameters::Entry* other = key.starts_with("environment.") ? second.parameters.find(key) : nullptr;
    if (other && other->value != entry.value && entry.parameter.group != Group::Rewards) others.push_back(key);
  }
  constexpr std::size_t kMostNamed = 3;
  if (others.size() > kMostNamed) others.resize(kMostNamed), others.emplace_back("others");
  if (!others.empty())
    note = fmt::format("{} was learned with another {} than {}; both are tried on the models of {}.",
                       functions.back()->name, joinWords(others), functions.front()->name, functions.front()->name);
  return Done{};
}

/// "policy.KEY=VALUE" for every function.
Status setPolicyParameter(const Registry& registry, const std::string& key, const std::string& value,
                          RobustnessPlan& plan) {
  const auto entry = findEntry(registry.policies, "--policy", plan.policy);
  if (!entry) return entry.error();
  const auto keys = policyKeys(**entry);
  if (std::find(keys.begin(), keys.end(), key) == keys.end())
    return Error{fmt::format("{}: the policy {} has no such parameter.", shortened(key), plan.policy)};
  for (Parameters& parameters : plan.policies)
    if (const Status s = parameters.set(key, std::string_view(value)); !s) return s;
  return Done{};
}

/// The sides of the grid; parameters of the policy are set.
Result<std::vector<GridSide>> readSettings(const Registry& registry, const RobustnessQuestion& q,
                                           RobustnessPlan& plan) {
  std::vector<GridSide> sides;
  std::vector<std::string> keys;
  for (const std::string& text : q.settings) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
      return Error{
          fmt::format("--set: \"{}\" is not KEY=VALUES, such as environment.friction=0..0.1:5.", shortened(text))};
    const std::string key = text.substr(0, equals), values = text.substr(equals + 1);
    if (std::find(keys.begin(), keys.end(), key) != keys.end())
      return Error{fmt::format("--set: {} is given twice; give it once, with all its values.", key)};
    keys.push_back(key);
    if (key.starts_with("policy.")) {
      if (const Status s = setPolicyParameter(registry, key, values, plan); !s) return s.error();
      continue;
    }
    if (!key.starts_with("environment."))
      return Error{fmt::format("{}: nothing is learned here; only parameters of policy and environment can be set.",
                               shortened(key))};
    Parameters probe = plan.robot.parameters;  // its error for a key that there is none of
    const Parameters::Entry* entry = probe.find(key);
    if (!entry) return probe.set(key, 0.0).error();
    auto parsed = parseValues(entry->parameter, values);
    if (!parsed) return parsed.error();
    plan.keys.push_back(key);
    sides.push_back({entry->parameter, std::move(*parsed)});
  }
  return sides;
}

/// Whether the policy can act on what each of the functions knows.
Status checkPolicy(const Registry& registry, const Functions& functions, const Task& task, const RobustnessPlan& plan) {
  for (std::size_t f = 0; f < functions.size(); ++f) {
    const auto policy = makePolicy(registry, plan.policy, plan.policies[f]);
    if (!policy) return policy.error();
    if (const Status s = (*policy)->caution().check(usableBy(functions[f]->values(), task.handMade, true)); !s)
      return Error{fmt::format("{}: {}", functions[f]->name, s.error().message)};
  }
  return Done{};
}

}  // namespace

Result<TriedFunction> makeTried(const Registry& registry, std::string name, std::shared_ptr<const TensorFile> file) {
  auto configuration = configurationOf(registry, *file);
  if (!configuration) return configuration.error();
  const auto environment = makeEnvironment(registry, *configuration);
  if (!environment) return environment.error();
  auto agent = makeTeacher(registry, *file, (*environment)->task());
  if (!agent) return agent.error();
  return TriedFunction{std::move(name), std::move(*configuration), std::move(file), std::move(*agent)};
}

Configuration RobustnessPlan::modelled(const TriedModel& model) const {
  Configuration c = robot;
  if (!model.scenario.empty()) c.names.scenario = model.scenario;
  for (const auto& [key, value] : model.values)
    static_cast<void>(static_cast<bool>(c.parameters.set(key, value)));  // checked when the plan was made
  return c;
}

Result<RobustnessPlan> makeRobustnessPlan(const Registry& registry, const Functions& functions,
                                          const RobustnessQuestion& q) {
  RobustnessPlan plan;
  plan.robot = functions.front()->configuration;
  plan.environment = plan.robot.names.environment;
  if (const auto entry = findEntry(registry.policies, "--policy", q.policy); !entry) return entry.error();
  plan.policy = q.policy;
  for (const TriedFunction* function : functions) {
    plan.functions.push_back(function->name);
    plan.policies.push_back(function->configuration.parameters);
  }
  if (const Status s = checkPair(functions, plan.note); !s) return s.error();
  const auto environment = makeEnvironment(registry, plan.robot);
  if (!environment) return environment.error();
  const Task& task = (*environment)->task();
  plan.canFall = task.canFall, plan.canSucceed = task.goalReward.has_value();
  if (const Status s = setTimes(q, task, plan); !s) return s.error();
  if (const Status s = setNumbers(q, **environment, plan); !s) return s.error();
  const auto sides = readSettings(registry, q, plan);
  if (!sides) return sides.error();
  if (const Status s = checkPolicy(registry, functions, task, plan); !s) return s.error();
  auto models = makeTriedModels(registry, plan, functions, q.scenario, *sides);
  if (!models) return models.error();
  plan.models = std::move(*models);
  return plan;
}

std::string robustnessCommandLine(const RobustnessQuestion& q, const std::vector<std::string>& files) {
  std::string command = "surefoot robustness";
  for (const std::string& file : files) command += " " + shellQuoted(file);
  const auto add = [&](const char* option, const std::optional<std::string>& value) {
    if (value) command += fmt::format(" {} {}", option, shellQuoted(*value));
  };
  add("--push", q.push);
  add("--push-at", q.pushAt);
  add("--seconds", q.seconds);
  add("--scenario", q.scenario);
  for (const std::string& setting : q.settings) add("--set", setting);
  if (q.policy != RobustnessQuestion{}.policy) add("--policy", q.policy);
  add("--starts", q.starts);
  add("--seed", q.seed);
  return command;
}

}  // namespace surefoot
