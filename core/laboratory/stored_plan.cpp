// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "core/experiment/configuration_json.h"
#include "core/files/json_difference.h"
#include "core/files/read_file.h"
#include "core/laboratory/store.h"
#include "core/version.h"

namespace surefoot {

Result<StoredPlan> planToStore(const Registry& registry, const Plan& plan) {
  StoredPlan stored{
      .title = plan.title, .version = kVersion, .seed = plan.seed, .paired = plan.paired, .conditions = {}};
  for (const Condition& c : plan.conditions) {
    const auto environment = makeEnvironment(registry, c.configuration);
    if (!environment) return environment.error();
    const Task& task = (*environment)->task();
    auto json = configurationAsJson(c.configuration);
    json["seed"] = c.configuration.seed;
    json.erase("lives");  // it may grow
    if (c.preLearning) {
      auto pre = configurationAsJson(c.preLearning->configuration);
      pre["seed"] = c.preLearning->configuration.seed;
      pre.erase("lives");
      json["pre_learning"] = {{"pool", c.preLearning->pool}, {"configuration", std::move(pre)}};
    }
    stored.conditions.push_back(
        {c.name, c.reference, c.text, json.dump(), plan.lives, task.highestReturn, task.stepTime.value_or(0.0)});
  }
  return stored;
}

Status checkSamePlan(const StoredPlan& stored, const StoredPlan& plan, const std::string& path) {
  const auto differs = [&](const std::string& what, const auto& there, const auto& here) {
    return fileError(path, fmt::format("it belongs to another plan: {} is {} there and {} here.", what, there, here));
  };
  if (stored.seed != plan.seed) return differs("seed", stored.seed, plan.seed);
  if (stored.paired != plan.paired) return differs("paired", stored.paired, plan.paired);
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
      const auto theirs = nlohmann::json::parse(there.configuration, nullptr, false);
      const auto ours = nlohmann::json::parse(here.configuration, nullptr, false);
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
