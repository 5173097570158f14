// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "core/basics/typed_json.h"
#include "core/basics/version.h"
#include "core/experiment/configuration_json.h"
#include "core/files/json_difference.h"
#include "core/files/limited_json.h"
#include "core/files/read_file.h"
#include "core/life/lives_version.h"
#include "core/saved/q_file.h"
#include "core/store/store.h"

namespace surefoot {

Result<StoredPlan> planToStore(const Registry& registry, const Plan& plan) {
  StoredPlan stored{
      .title = plan.title, .version = kVersion, .seed = plan.seed, .paired = plan.paired, .conditions = {}};
  if (plan.growth) stored.growth = jsonText(growthAsJson(plan.growth));
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    const Condition& c = plan.conditions[i];
    const auto environment = makeEnvironment(registry, c.configuration);
    if (!environment) return environment.error();
    const Task& task = (*environment)->task();
    auto json = configurationAsJson(c.configuration);
    json["seed"] = c.configuration.seed;
    json.erase("lives");  // the number of lives may grow
    if (const auto& start = c.configuration.start) {
      const auto content = c.configuration.beganWith["content"].get<std::string>();
      json["began_with"] = {{"content", content}};
      stored.qFunctions[content] = start;
    }
    if (const auto& teacher = c.configuration.teacher) {
      const std::string content = contentOf(*teacher);
      json["guardian"] = {{"content", content}};
      stored.qFunctions[content] = teacher;
    }
    if (c.preLearning) {
      auto pre = configurationAsJson(c.preLearning->configuration);
      pre["seed"] = c.preLearning->configuration.seed;
      pre.erase("lives");
      json["pre_learning"] = {{"pool", c.preLearning->pool}, {"configuration", std::move(pre)}};
    }
    stored.conditions.push_back({c.name, c.reference, c.text, jsonText(json), plan.livesOf(i), task.highestReturn,
                                 task.stepTime.value_or(0.0)});
  }
  return stored;
}

namespace {

/// Reads a configuration that planToStore wrote.
Result<Configuration> storedConfiguration(const Registry& registry, const Json& json, const std::string& file) {
  auto c = configurationFromJson(registry, json, file);
  if (!c) return c.error();
  if (!json.contains("seed") || !json["seed"].is_number_unsigned())
    return fileError(file, "a condition has no seed; the file is damaged.");
  c->seed = json["seed"].get<std::uint64_t>();
  return c;
}

Result<PreLearning> storedPreLearning(const Registry& registry, const Json& json, const std::string& file) {
  if (!json.is_object() || !json.contains("pool") || !json["pool"].is_number_unsigned() ||
      json["pool"].get<std::uint64_t>() > 1'000'000 || !json.contains("configuration"))
    return fileError(file, "the pre-learning of a condition lacks its pool or configuration; the file is damaged.");
  auto c = storedConfiguration(registry, json["configuration"], file);
  if (!c) return c.error();
  PreLearning pre{.configuration = std::move(*c), .pool = json["pool"].get<int>(), .text = {}};
  pre.text = jsonText(json["configuration"]);
  return pre;
}

Result<std::shared_ptr<const TensorFile>> storedQFunction(const Json& json, const Json::json_pointer& place,
                                                          const char* which, const Store& store) {
  const Json content = json.value(place, Json());
  auto q = store.qFunction(content.is_string() ? content.get<std::string>() : "");
  if (q && !*q)
    return fileError(store.path(), fmt::format("it does not hold the Q-function {}; go on with its plan: surefoot "
                                               "experiment PLAN --resume.",
                                               which));
  return q;
}

Result<Condition> storedCondition(const Registry& registry, const StoredCondition& stored, const Store& store) {
  const std::string& file = store.path();
  const Json json = parseJson(stored.configuration);
  auto configuration = storedConfiguration(registry, json, file);
  if (!configuration) return configuration.error();
  Condition c{.name = stored.name,
              .text = stored.text,
              .reference = stored.reference,
              .configuration = std::move(*configuration),
              .preLearning = {},
              .varied = {}};
  c.configuration.lives = stored.lives;
  if (!c.configuration.minutes && !c.configuration.episodes)
    return fileError(file, "a condition does not say how long a life is; the file is damaged.");
  if (json.contains("began_with") || stored.text.find(" began-with={") != std::string::npos) {
    auto q = storedQFunction(json, "/began_with/content"_json_pointer, "that its lives begin with", store);
    if (!q) return q.error();
    beginWith(c.configuration, std::move(*q));
  }
  if (json.contains("guardian")) {
    auto q = storedQFunction(json, "/guardian/content"_json_pointer, "of its guardian", store);
    if (!q) return q.error();
    c.configuration.teacher = std::move(*q);
  }
  if (!json.contains("pre_learning")) return c;
  auto pre = storedPreLearning(registry, json["pre_learning"], file);
  if (!pre) return pre.error();
  c.preLearning = std::move(*pre);
  return c;
}

}  // namespace

Result<Plan> planFromStore(const Registry& registry, const Store& store) {
  const auto stored = store.plan();
  if (!stored) return stored.error();
  Plan plan{.title = stored->title,
            .seed = stored->seed,
            .lives = stored->conditions.front().lives,
            .paired = stored->paired,
            .conditions = {}};
  for (const StoredCondition& c : stored->conditions) {
    auto condition = storedCondition(registry, c, store);
    if (!condition) return condition.error();
    plan.conditions.push_back(std::move(*condition));
    plan.livesEach.push_back(c.lives);
  }
  if (!stored->growth.empty()) {
    auto growth = growthFromJson(parseJson(stored->growth));
    if (!growth) return fileError(store.path(), "how its lives grow cannot be read; the file is damaged.");
    plan.growth = std::move(*growth);
  } else {
    plan.livesEach.clear();
  }
  // The plan must be written again in the same way: a parameter with another value would make other lives.
  const auto again = planToStore(registry, plan);
  if (!again) return again.error();
  if (const Status s = checkSamePlan(*stored, *again, store.path()); !s) return s.error();
  return plan;
}

int livesPlanned(const StoredPlan& plan) {
  std::int64_t all = 0;
  for (const StoredCondition& c : plan.conditions) all += c.lives;
  return static_cast<int>(all / plan.shards + (plan.shard <= all % plan.shards));
}

Status checkLivesVersion(const std::vector<StoredLife>& lives, const std::string& path) {
  for (const StoredLife& l : lives)
    if (l.livesVersion != kLivesVersion) return otherLives(path, l.livesVersion, l.program);
  return Done{};
}

namespace {

/// Removes parameters of policies that are missing in `other`: the policy was added to the program later, and no
/// condition of `other` uses it.
void leaveOutNewer(Json& json, const Json& other) {
  for (auto& [key, value] : json.items()) {
    if (!value.is_object() || !other.contains(key)) continue;
    if (key != "parameters") {
      leaveOutNewer(value, other[key]);
      continue;
    }
    for (auto parameter = value.begin(); parameter != value.end();)
      parameter = parameter.key().starts_with("policy.") && !other[key].contains(parameter.key())
                      ? value.erase(parameter)
                      : std::next(parameter);
  }
}

}  // namespace

Status checkSamePlan(const StoredPlan& stored, const StoredPlan& plan, const std::string& path) {
  const auto differs = [&](const std::string& what, const auto& there, const auto& here) {
    return fileError(path, fmt::format("it belongs to another plan: {} is {} there and {} here.", what, there, here));
  };
  if (stored.seed != plan.seed) return differs("seed", stored.seed, plan.seed);
  if (stored.paired != plan.paired) return differs("paired", stored.paired, plan.paired);
  if (stored.growth != plan.growth)
    return differs("how its lives grow", stored.growth.empty() ? "a fixed number" : stored.growth,
                   plan.growth.empty() ? "a fixed number" : plan.growth);
  if (stored.title != plan.title) return differs("title", stored.title, plan.title);
  if (stored.conditions.size() != plan.conditions.size())
    return differs("the number of conditions", stored.conditions.size(), plan.conditions.size());
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    const StoredCondition &there = stored.conditions[i], &here = plan.conditions[i];
    const std::string which = fmt::format("condition {}", i + 1);
    if (there.name != here.name) return differs(which, there.name, here.name);
    if (there.reference != here.reference) return differs(which + ", reference", there.reference, here.reference);
    if (there.text != here.text) return differs(which, there.text, here.text);
    if (there.configuration != here.configuration) {
      const auto theirs = parseJson(there.configuration);
      auto ours = parseJson(here.configuration);
      leaveOutNewer(ours, theirs);
      if (ours == theirs) continue;
      const std::string whole = fmt::format("{} ({})", which, here.name);
      if (const auto d = firstDifference(theirs, ours, whole)) return differs(d->where, d->theirs, d->ours);
      const auto d = firstDifference(ours, theirs, whole);  // something that only the store has
      return differs(d ? d->where : whole, d ? d->ours : "another", d ? d->theirs : "another");
    }
  }
  return Done{};
}

Status checkSameShard(const StoredPlan& stored, const StoredPlan& plan, const std::string& path) {
  if (stored.shard == plan.shard && stored.shards == plan.shards) return Done{};
  return fileError(path,
                   fmt::format("it is shard {}/{}, not {}/{}.", stored.shard, stored.shards, plan.shard, plan.shards));
}

}  // namespace surefoot
