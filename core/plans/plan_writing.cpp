// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plans/plan_writing.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/basics/typed_json.h"
#include "core/saved/q_file.h"
#include "core/text/text.h"

namespace surefoot {

namespace {
constexpr double kMinutes = 9;
constexpr int kEpisodes = 500;

std::string lengthOf(const Configuration& c, bool clock) {
  std::string lines;
  if (c.minutes && clock) lines += fmt::format("minutes = {}\n", *c.minutes);
  if (c.episodes) lines += fmt::format("episodes = {}\n", *c.episodes);
  if (!lines.empty()) return lines;
  return clock ? fmt::format("minutes = {}\n", kMinutes) : fmt::format("episodes = {}\n", kEpisodes);
}

Error notToBeWritten(const std::string& began) {
  return Error{
      fmt::format("The life began with {}, which no plan can say. Save its Q-function, begin a life with that "
                  "file, and add what then runs.",
                  began)};
}

/// One line for every value that differs from `usual`.
std::string settingsOf(const Parameters& parameters, const Parameters& usual,
                       const std::vector<std::string>& policyKeys, const std::string& prefix) {
  std::string lines;
  for (const auto& entry : parameters.all()) {
    const std::string& key = entry.parameter.key;
    const Parameters::Entry* before = usual.find(key);
    if (before && before->value == entry.value) continue;
    // Parameters that only other policies read have no effect.
    if (key.starts_with("policy.") && std::find(policyKeys.begin(), policyKeys.end(), key) == policyKeys.end())
      continue;
    const std::string value = formatValue(entry.parameter, entry.value);
    lines += fmt::format("{}set.{} = {}\n", prefix, key, entry.parameter.choices.empty() ? value : tomlText(value));
  }
  return lines;
}

/// Where the file is that the life "began with", if it still has the same values.
Result<std::string> placeOf(const TensorFile& file, const char* beganWith) {
  const std::string name = std::filesystem::path(file.name).filename().string();
  const auto now = readQFile(file.name);
  if (!now) return now.error();
  if (contentOf(**now) != contentOf(file))
    return Error{fmt::format("The life {} {}, and that file holds other values now.", beganWith, name)};
  return tomlText(std::filesystem::absolute(file.name).string());
}

/// The settings of a pool that is learned in the same way as this Q-function. A plan takes most settings over from the
/// condition (all but policy and step sizes); only the others are written.
Result<std::string> preLearningToml(const Registry& registry, const Configuration& c, const TensorFile& start) {
  constexpr std::int64_t kUsualCap = 20'000;
  const auto before = configurationOf(registry, start);
  if (!before) return before.error();
  const Names& n = before->names;
  const Names& now = c.names;
  if (!before->until || n.environment != now.environment || n.agent != now.agent || n.features != now.features)
    return notToBeWritten(
        "a Q-function of another task, learning rule or representation, or without a reward to reach");
  Names names = n;
  std::vector<Assignment> inherited;  // as makeCondition does it
  const auto usual = configure(registry, c.names, {});
  if (!usual) return usual.error();
  for (const auto& entry : c.parameters.all()) {
    const std::string& key = entry.parameter.key;
    const Parameters::Entry* other = usual->parameters.find(key);
    if ((other && other->value == entry.value) || !isInherited(key)) continue;
    inherited.push_back({key, formatValue(entry.parameter, entry.value)});
  }
  const auto taken = configure(registry, names, inherited);
  if (!taken) return taken.error();
  const auto policy = findEntry(registry.policies, "policy", n.policy);
  if (!policy) return policy.error();
  std::string toml;
  if (!n.scenario.empty()) toml += "pre-learning.scenario = " + tomlText(n.scenario) + "\n";
  if (n.preset != c.names.preset) toml += "pre-learning.preset = " + tomlText(n.preset) + "\n";
  if (n.policy != "epsilon-greedy") toml += "pre-learning.policy = " + tomlText(n.policy) + "\n";
  toml += fmt::format("pre-learning.until = {}\n", *before->until);
  if (before->episodes && *before->episodes != kUsualCap)
    toml += fmt::format("pre-learning.cap = {}\n", *before->episodes);
  return toml + settingsOf(before->parameters, taken->parameters, policyKeys(**policy), "pre-learning.");
}

/// The settings for how the lives begin; none if they begin with an empty table.
Result<std::string> startToml(const Registry& registry, const Configuration& c) {
  if (!c.start && c.beganWith.is_null()) return std::string();
  const std::string file = textIn(c.beganWith, "file");
  const auto& learned = partOf(c.beganWith, "learned");
  if (learned.contains("carried_over") && learned["carried_over"] == true)
    return notToBeWritten("what was carried over from another table");
  if (!c.start)
    return notToBeWritten(file.empty() ? "something learned before"
                                       : std::string(shortened(file)) + ", which is not at hand");
  if (c.start->name.empty()) return preLearningToml(registry, c, *c.start);
  const auto place = placeOf(*c.start, "began with");
  if (!place) return place.error();
  return "pre-learning.file = " + *place + "\n";
}

/// Where the settings say that a Q-function is the guardian, they name its file.
Status teacherToml(const Configuration& c, std::string& toml) {
  const std::string said = "set.policy.guardian = \"q-function\"\n";
  const auto at = toml.find(said);
  if (at == toml.npos || !c.teacher) return Done{};
  const auto file = placeOf(*c.teacher, "is guarded by");
  if (!file) return file.error();
  toml.replace(at, said.size(), "set.policy.guardian = " + *file + "\n");
  return Done{};
}

}  // namespace

std::string tomlText(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) out += c;
  }
  return out + "\"";
}

Result<std::string> conditionToml(const Registry& registry, const Configuration& c, const std::string& name) {
  const auto environment = makeEnvironment(registry, c);
  if (!environment) return environment.error();
  const auto usual = configure(registry, c.names, {});
  if (!usual) return usual.error();
  const auto policy = findEntry(registry.policies, "policy", c.names.policy);
  if (!policy) return policy.error();
  const auto keys = policyKeys(**policy);

  std::string toml = fmt::format("[[condition]]\nname = {}\nbase = false\n", tomlText(name));
  const auto line = [&](const char* key, const std::string& value) {
    if (!value.empty()) toml += fmt::format("{} = {}\n", key, tomlText(value));
  };
  line("environment", c.names.environment);
  line("preset", c.names.preset);
  line("scenario", c.names.scenario);
  line("agent", c.names.agent);
  line("features", c.names.features);
  line("policy", c.names.policy);
  toml += lengthOf(c, (*environment)->task().stepTime.has_value());
  toml += settingsOf(c.parameters, usual->parameters, keys, "");
  if (const auto teacher = teacherToml(c, toml); !teacher) return teacher.error();
  const auto start = startToml(registry, c);
  if (!start) return start.error();
  return toml + *start;
}

std::string freeName(const Plan& plan, const std::string& name) {
  const auto taken = [&](const std::string& candidate) {
    return std::any_of(plan.conditions.begin(), plan.conditions.end(),
                       [&](const Condition& c) { return c.name == candidate; });
  };
  std::string candidate = name;
  for (int number = 2; taken(candidate); ++number) candidate = fmt::format("{} ({})", name, number);
  return candidate;
}

}  // namespace surefoot
