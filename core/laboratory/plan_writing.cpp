// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/plan_writing.h"

#include <fmt/format.h>

#include <algorithm>

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
  for (const auto& entry : c.parameters.all()) {
    const std::string& key = entry.parameter.key;
    const Parameters::Entry* before = usual->parameters.find(key);
    if (before && before->value == entry.value) continue;
    // What another policy would read has no effect.
    if (key.starts_with("policy.") && std::find(keys.begin(), keys.end(), key) == keys.end()) continue;
    const std::string value = formatValue(entry.parameter, entry.value);
    toml += fmt::format("set.{} = {}\n", key, entry.parameter.choices.empty() ? value : tomlText(value));
  }
  return toml;
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
