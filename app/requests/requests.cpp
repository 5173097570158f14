// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/requests.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text/number_text.h"
#include "core/text/text.h"
#include "core/text/words.h"
#include "core/values_of_state.h"

namespace surefoot {

Names namesOr(const ChosenNames& chosen, const Names& otherwise) {
  return {.environment = chosen.environment.value_or(otherwise.environment),
          .preset = chosen.preset.value_or(otherwise.preset),
          .scenario = chosen.scenario.value_or(otherwise.scenario),
          .agent = chosen.agent.value_or(otherwise.agent),
          .features = chosen.features.value_or(otherwise.features),
          .policy = chosen.policy.value_or(otherwise.policy)};
}

Result<std::int64_t> parseCount(const std::string& option, const std::string& text, std::int64_t most) {
  const auto value = parseWhole(option, text, 1, static_cast<std::uint64_t>(most));
  if (!value) return value.error();
  return static_cast<std::int64_t>(*value);
}

Result<std::vector<Assignment>> parseAssignments(const std::vector<std::string>& texts) {
  std::vector<Assignment> assignments;
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
      return Error{fmt::format("--set: \"{}\" is not KEY=VALUE, such as policy.epsilon=0.05.", text.substr(0, 60))};
    assignments.push_back({text.substr(0, equals), text.substr(equals + 1)});
    for (std::size_t i = 0; i + 1 < assignments.size(); ++i)
      if (assignments[i].key == assignments.back().key && assignments[i].value != assignments.back().value)
        return Error{fmt::format("--set: {} is given twice, as {} and as {}; give it once.", assignments[i].key,
                                 assignments[i].value, assignments.back().value)};
  }
  return assignments;
}

Status checkPolicyKeys(const Registry& registry, const std::string& policy,
                       const std::vector<Assignment>& assignments) {
  const auto chosen = findEntry(registry.policies, "--policy", policy);
  if (!chosen) return chosen.error();
  const std::vector<std::string> used = policyKeys(**chosen);
  for (const Assignment& a : assignments) {
    if (!a.key.starts_with("policy.") || std::find(used.begin(), used.end(), a.key) != used.end()) continue;
    std::vector<std::string> owners;
    for (const PolicyEntry& entry : registry.policies) {
      const auto keys = policyKeys(entry);
      if (std::find(keys.begin(), keys.end(), a.key) != keys.end()) owners.push_back(entry.name);
    }
    if (!owners.empty())
      return Error{
          fmt::format("{}: the policy {} does not use it; it belongs to {}.", a.key, policy, joinWords(owners))};
  }
  return Done{};
}

namespace {

Result<std::vector<double>> parseQ(const std::string& text) {
  if (text.empty()) return Error{"--q: the list is empty; action values are needed, such as 1,2,3."};
  auto q = parseNumbers("--q", text);
  if (q && q->size() > kMaxActions)
    return Error{fmt::format("--q: {} values are given; 1 to {} are allowed.", q->size(), kMaxActions)};
  return q;
}

}  // namespace

Result<ProbabilitiesRequest> makeProbabilitiesRequest(const Registry& registry, const ProbabilitiesOptions& o) {
  if (!o.q) return Error{"--q: action values are needed, such as --q 1,2,3."};
  const auto q = parseQ(*o.q);
  if (!q) return q.error();
  const auto assignments = parseAssignments(o.assignments);
  if (!assignments) return assignments.error();
  if (const Status s = checkPolicyKeys(registry, o.policy, *assignments); !s) return s.error();
  for (const Assignment& a : *assignments)
    if (!a.key.starts_with("policy."))
      return Error{fmt::format("{}: only parameters of the policy have a meaning here.", shortened(a.key))};
  return ProbabilitiesRequest{*q, o.policy, *assignments, o.json};
}

Result<std::unique_ptr<Policy>> policyOn(const Registry& registry, const StoredFunction& f, const std::string& name,
                                         const std::vector<std::string>& texts) {
  const auto assignments = parseAssignments(texts);
  if (!assignments) return assignments.error();
  if (const Status s = checkPolicyKeys(registry, name, *assignments); !s) return s.error();
  Parameters values = f.configuration.parameters;
  for (const Assignment& a : *assignments) {
    if (!a.key.starts_with("policy."))
      return Error{fmt::format("{}: only parameters of the policy have a meaning here.", a.key)};
    if (const Status s = values.set(a.key, std::string_view(a.value)); !s) return s.error();
  }
  auto policy = makePolicy(registry, name, values);
  if (!policy) return policy.error();
  if (const Status s = (*policy)->caution().check(usableBy(f.values(), f.task().handMade, true)); !s) return s.error();
  (*policy)->advance({});
  return policy;
}

Error orOtherVersion(const Error& error) {
  return {error.message + " " + kOtherVersion, error.kind};
}

}  // namespace surefoot
