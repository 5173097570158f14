// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plans/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/files/read_file.h"
#include "core/plans/plan_condition.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

constexpr int kMostLives = 1'000'000;

/// The settings of a plan above its conditions.
Status readHead(const PlanFile& file, const std::string& path, Plan& plan, PlanHead& head) {
  for (const PlanSetting& s : file.head) {
    const std::string& value = s.values.front();
    Status status = Done{};
    if (s.values.size() > 1)
      status = Error{fmt::format("{}: one value is expected.", s.key)};
    else if (s.key == "title")
      plan.title = value;
    else if (s.key == "reference")
      head.reference = value;
    else if (s.key == "lives" && value == "decided")
      plan.growth.decided.emplace();
    else if (s.key == "lives")
      status = readCount(s.key, value, kMostLives, head.lives);
    else if (s.key == "seed")
      status = readSeed(value, head.seed);
    else if (s.key == "series")
      head.series = value;
    else if (s.key == "paired")
      status = readFlag(s.key, value, head.paired);
    else
      status = unknownKey(s.key, {"title", "reference", "lives", "seed", "series", "paired", "base", "pre-learning",
                                  "systems", "decided", "search", "condition"});
    if (!status) return planError(path, s.line, status.error().message);
  }
  return Done{};
}

/// Whether and how the lives grow. A number of lives on the command line replaces "decided".
Status readGrowth(const PlanFile& file, const std::string& path, const PlanChanges& changes, Plan& plan,
                  PlanHead& head) {
  if (changes.lives) plan.growth.decided.reset();
  if (plan.growth.decided) {
    auto decided = readDecided(file.decided, path);
    if (!decided) return decided.error();
    plan.growth.decided = std::move(*decided);
  } else if (!file.decided.empty() && !changes.lives) {
    return planError(path, file.decided.front().line, "decided: it goes with lives = \"decided\".");
  }
  if (file.search.empty()) return Done{};
  if (plan.growth.decided)
    return planError(path, file.search.front().line, "search: it has a budget of lives; lives = \"decided\" has none.");
  auto search = readSearch(file.search, path);
  if (!search) return search.error();
  plan.growth.search = std::move(*search);
  if (changes.lives) plan.growth.search->fresh = *changes.lives;
  plan.paired = head.paired = true;  // candidates are compared in lives with the same seeds
  return Done{};
}

/// The condition whose parameter is sought, once with every value.
Status addCandidates(const std::optional<PlanSearch>& search, const std::string& path, std::vector<PlanBlock>& blocks) {
  if (!search) return Done{};
  for (PlanBlock& block : blocks) {
    const auto has = [&](const std::string& key) {
      return std::find_if(block.settings.begin(), block.settings.end(), [&](const auto& s) { return s.key == key; });
    };
    const auto name = has("name");
    if (name == block.settings.end() || name->values != std::vector<std::string>{search->condition}) continue;
    const std::string key = "set." + search->key;
    if (const auto own = has(key); own != block.settings.end())
      return planError(path, own->line, key + ": it is sought ([search]), and has no value here.");
    block.settings.push_back({key, search->valuesToTry(), block.line});
    return Done{};
  }
  return planError(path, 0, fmt::format("search: no condition is called \"{}\".", shortened(search->condition)));
}

void nameCandidates(Plan& plan) {
  if (!plan.growth.search) return;
  PlanSearch& search = *plan.growth.search;
  for (const Condition& c : plan.conditions)
    if (std::any_of(c.varied.begin(), c.varied.end(), [&](const auto& v) { return v.key == "set." + search.key; }) &&
        c.name.starts_with(search.condition))
      search.candidates.push_back(c.name);
}

/// Checks that no two conditions are the same, and that every reference is one of them.
Status checkConditions(const std::vector<Condition>& conditions) {
  std::set<std::string> names;
  std::map<std::string, std::string> texts;
  for (const Condition& c : conditions) {
    if (!names.insert(c.name).second)
      return Error{fmt::format(
          "two conditions are called \"{}\"; write what differs into the name, e.g. {{policy.threshold}}.", c.name)};
    const auto [other, fresh] = texts.emplace(c.text, c.name);
    if (!fresh) return Error{fmt::format("the conditions \"{}\" and \"{}\" are the same.", other->second, c.name)};
  }
  for (const Condition& c : conditions)
    if (!c.reference.empty() && !names.contains(c.reference))
      return Error{fmt::format("reference: no condition is called \"{}\".", shortened(c.reference))};
  return Done{};
}

}  // namespace

std::string describe(const Registry& registry, const Configuration& c) {
  const Names& n = c.names;
  std::string text = fmt::format("environment={}", n.environment);
  if (!n.preset.empty()) text += " preset=" + n.preset;
  if (!n.scenario.empty()) text += " scenario=" + n.scenario;
  text += fmt::format(" agent={} features={} policy={}", n.agent, n.features, n.policy);
  const auto usual = configure(registry, n, {});
  const auto keys = policyKeys(**findEntry(registry.policies, "policy", n.policy));
  for (const auto& entry : c.parameters.all()) {
    const std::string& key = entry.parameter.key;
    if (entry.value == usual->parameters.get(key)) continue;
    if (key.starts_with("policy.") && std::find(keys.begin(), keys.end(), key) == keys.end()) continue;
    text += fmt::format(" {}={}", key, formatValue(entry.parameter, entry.value));
  }
  return text;
}

Result<Plan> parsePlan(const Registry& registry, const std::string& text, const std::string& path,
                       const PlanChanges& changes) {
  const auto file = parsePlanFile(text, path);
  if (!file) return file.error();
  Plan plan;
  PlanHead head;
  if (const Status s = readHead(*file, path, plan, head); !s) return s.error();
  if (const Status s = readGrowth(*file, path, changes, plan, head); !s) return s.error();
  plan.lives = head.lives = changes.lives.value_or(head.lives);
  plan.seed = head.seed = changes.seed.value_or(head.seed);
  plan.paired = head.paired = head.paired || plan.paired;
  head.assignments = changes.assignments;
  head.preset = changes.preset;
  const auto systems = drawSystems(file->systems, path);
  if (!systems) return systems.error();
  plan.systems = static_cast<int>(systems->size());
  std::vector<PlanBlock> blocks = file->blocks;
  if (const Status s = addCandidates(plan.growth.search, path, blocks); !s) return s.error();
  std::vector<std::vector<Combination>> grids;  // counted before the first is made
  std::size_t count = 0;
  for (const PlanBlock& block : blocks) {
    count += grids.emplace_back(combine(block)).size() * std::max<std::size_t>(1, systems->size());
    if (count > kMostConditions)
      return planError(path, block.line, fmt::format("there are more than {} conditions.", kMostConditions));
  }
  const auto addAll = [&]() -> Status {
    for (std::size_t i = 0; i < grids.size(); ++i)
      for (const Combination& combination : grids[i]) {
        if (changes.interrupted && *changes.interrupted)
          return Error{path + ": interrupted before its conditions were read.", ErrorKind::Interrupted};
        auto condition = makeCondition(registry, path, head, combination, blocks[i].line);
        if (!condition) return condition.error();
        plan.conditions.push_back(std::move(*condition));
      }
    return Done{};
  };
  if (systems->empty())
    if (const Status s = addAll(); !s) return s.error();
  for (const DrawnSystem& system : *systems) {
    head.system = system;
    if (const Status s = addAll(); !s) return s.error();
  }
  if (const Status s = checkConditions(plan.conditions); !s) return planError(path, 0, s.error().message);
  nameCandidates(plan);
  if (plan.growth) plan.lives = plan.growth.first();
  return plan;
}

Result<Plan> readPlan(const Registry& registry, const std::string& path, const PlanChanges& changes) {
  const auto text = readText(path);
  if (!text) return text.error();
  return parsePlan(registry, *text, path, changes);
}

}  // namespace surefoot
