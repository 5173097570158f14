// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/plan_condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/experiment/q_file.h"

namespace surefoot {

namespace {

constexpr int kMostPool = 1'000'000;

std::uint64_t hashText(std::string_view text, std::uint64_t seed) {
  Hash64 hash;
  hash.add(seed);
  for (const char c : text) hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  return hash.value();
}

/// "TRL {policy.threshold}" with the values in place of the keys; what a list varies and the name does not tell is
/// added.
std::string nameOf(const Combination& c, std::string name, bool whole) {
  for (const Assignment& a : c.all) {
    const std::string key = a.key.starts_with("set.") ? a.key.substr(4) : a.key, mark = "{" + key + "}";
    const auto place = name.find(mark);
    const bool varied = std::any_of(c.varied.begin(), c.varied.end(), [&](const auto& v) { return v.key == a.key; });
    if (place != std::string::npos)
      name.replace(place, mark.size(), a.value);
    else if (varied && whole)
      name += fmt::format("{}{} {}", name.empty() ? "" : ", ", key, a.value);
  }
  return name;
}

/// Makes one condition; everything that it needs to know of the plan is in `head`.
class ConditionMaker {
 public:
  ConditionMaker(const Registry& registry, const std::string& path, const PlanHead& head)
      : registry_(registry),
        path_(path),
        head_(head) {}

  Result<Condition> make(const Combination& c, int line) {
    Condition condition;
    Names names;
    std::vector<Assignment> assignments;
    std::optional<double> minutes, episodes;
    std::string name, reference = head_.reference, file;
    for (const auto& [key, value] : c.all) {
      Status status = Done{};
      if (key == "name")
        name = value;
      else if (key == "reference")
        reference = value;
      else if (key.starts_with("set."))
        assignments.push_back({key.substr(4), value});
      else if (key == "minutes")
        status = readNumber(key, value, 1e-6, 1e6, minutes);
      else if (key == "episodes")
        status = readNumber(key, value, 1, 1e9, episodes);
      else if (key == "pre-learning.file")
        file = value;
      else if (std::string* part = nameField(names, key))
        *part = value;
      else if (!key.starts_with("pre-learning"))
        status = unknownKey(key, {"name", "reference", "environment", "preset", "scenario", "agent", "features",
                                  "policy", "set", "minutes", "episodes", "pre-learning"});
      if (!status) return planError(path_, c.where.at(key)->line, status.error().message);
    }
    for (const Assignment& a : head_.assignments) assignments.push_back(a);
    if (head_.preset) names.preset = *head_.preset;

    auto configuration = configure(registry_, names, assignments);
    if (!configuration) return planError(path_, line, configuration.error().message);
    condition.configuration = std::move(*configuration);
    Configuration& now = condition.configuration;
    now.lives = head_.lives;
    now.minutes = minutes;
    if (episodes) now.episodes = static_cast<std::int64_t>(*episodes);
    if (!now.minutes && !now.episodes)
      return planError(path_, line, "minutes or episodes: how long a life is must be given, e.g. minutes = 9.");
    if (const Status s = checkPolicy(names.policy, assignments); !s) return planError(path_, line, s.error().message);

    condition.varied = c.varied;
    condition.text = describe(registry_, now);
    if (const Status s = readPreLearning(c, names, assignments, condition, line); !s) return s.error();
    if (!file.empty())
      if (const Status s = readStart(file, condition); !s) return planError(path_, line, s.error().message);
    now.seed = head_.paired ? head_.seed : hashText(condition.text, head_.seed);
    if (now.minutes) condition.text += fmt::format(" minutes={}", *now.minutes);
    if (now.episodes) condition.text += fmt::format(" episodes={}", *now.episodes);
    condition.name = nameOf(c, name, true);
    if (condition.name.empty()) condition.name = names.policy;
    condition.reference = nameOf(c, reference, false);
    if (const auto life = makeLife(registry_, now, 0, false); !life)  // what no single check can see
      return planError(path_, line, life.error().message);
    return condition;
  }

  /// Everything of the condition but policy and step sizes, on its own scenario, until the reward is reached.
  Status readPreLearning(const Combination& c, Names names, std::vector<Assignment> assignments, Condition& condition,
                         int line) {
    constexpr double kCap = 20'000;
    std::optional<double> until, cap = kCap;
    PreLearning pre;
    bool wanted = false;
    names.policy = "epsilon-greedy";
    std::erase_if(assignments,
                  [](const Assignment& a) { return a.key.starts_with("policy.") || a.key.ends_with("step_size"); });
    for (const auto& [fullKey, value] : c.all) {
      if (fullKey == "pre-learning" && value == "false") return Done{};
      if (!fullKey.starts_with("pre-learning") || fullKey == "pre-learning.file") continue;
      wanted = true;
      const std::string key = fullKey.substr(std::min(fullKey.size(), std::string("pre-learning.").size()));
      Status status = Done{};
      if (key == "scenario")
        names.scenario = value;
      else if (key == "preset")
        names.preset = value;
      else if (key == "policy")
        names.policy = value;
      else if (key.starts_with("set."))
        assignments.push_back({key.substr(4), value});
      else if (key == "until")
        status = readNumber(key, value, -1e6, 1e6, until);
      else if (key == "cap")
        status = readNumber(key, value, 1, 1e9, cap);
      else if (key == "pool" && value == "each")
        pre.pool = 0;
      else if (key == "pool")
        status = readCount(key, value, kMostPool, pre.pool);
      else
        status = unknownKey(key, {"scenario", "preset", "policy", "set", "until", "cap", "pool", "file"});
      if (!status) return planError(path_, c.where.at(fullKey)->line, "pre-learning: " + status.error().message);
    }
    if (!wanted) return Done{};
    if (head_.preset) names.preset = *head_.preset;
    if (c.find("pre-learning.file"))
      return planError(path_, line, "pre-learning: with a file nothing is learned before; take the other keys away.");
    if (!until)
      return planError(path_, line,
                       "pre-learning: until is missing: the average reward at which it ends, e.g. until = 198.");
    auto configuration = configure(registry_, names, assignments);
    if (!configuration) return planError(path_, line, "pre-learning: " + configuration.error().message);
    if (const Status s = checkPolicy(names.policy, assignments); !s)
      return planError(path_, line, "pre-learning: " + s.error().message);
    pre.configuration = std::move(*configuration);
    pre.configuration.until = until;
    pre.configuration.episodes = static_cast<std::int64_t>(*cap);
    pre.text = fmt::format("{} until={} cap={}", describe(registry_, pre.configuration), *until, *cap);
    pre.configuration.seed = hashText(pre.text, head_.seed);
    condition.text += fmt::format(" pre-learning=({}) pool={}", pre.text,
                                  pre.pool == 0 ? std::string("each") : std::to_string(pre.pool));
    condition.preLearning = std::move(pre);
    return Done{};
  }

  Status readStart(const std::string& file, Condition& condition) {
    const std::filesystem::path path(file);
    auto read = readQFile(path.is_absolute() ? file : (std::filesystem::path(path_).parent_path() / path).string());
    if (!read) return read.error();
    beginWith(condition.configuration, std::move(*read));
    condition.text += " began-with=" + condition.configuration.beganWith.dump();
    return Done{};
  }

  /// A parameter of a policy that is not chosen would have no effect.
  Status checkPolicy(const std::string& policy, const std::vector<Assignment>& assignments) const {
    const auto entry = findEntry(registry_.policies, "policy", policy);
    const auto keys = policyKeys(**entry);
    for (const Assignment& a : assignments)
      if (a.key.starts_with("policy.") && std::find(keys.begin(), keys.end(), a.key) == keys.end())
        return Error{fmt::format("{}: it has no effect under the policy {}.", a.key, policy)};
    return Done{};
  }

  static std::string* nameField(Names& names, const std::string& key) {
    if (key == "environment") return &names.environment;
    if (key == "preset") return &names.preset;
    if (key == "scenario") return &names.scenario;
    if (key == "agent") return &names.agent;
    if (key == "features") return &names.features;
    return key == "policy" ? &names.policy : nullptr;
  }

  const Registry& registry_;
  const std::string& path_;
  const PlanHead& head_;
};

}  // namespace

std::vector<Combination> combine(const PlanBlock& block) {
  std::vector<Combination> grid(1);
  for (const PlanSetting& setting : block.settings) {
    std::vector<Combination> longer;
    for (const Combination& sofar : grid)
      for (const std::string& value : setting.values) {
        longer.push_back(sofar);
        longer.back().where[setting.key] = &setting;
        longer.back().all.push_back({setting.key, value});
        if (setting.values.size() > 1) longer.back().varied.push_back({setting.key, value});
        if (longer.size() > kMostConditions) return longer;
      }
    grid = std::move(longer);
  }
  return grid;
}

Result<Condition> makeCondition(const Registry& registry, const std::string& path, const PlanHead& head,
                                const Combination& combination, int line) {
  return ConditionMaker(registry, path, head).make(combination, line);
}

}  // namespace surefoot
