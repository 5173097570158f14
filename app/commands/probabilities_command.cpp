// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot probabilities`: π for given action values; the tool behind the thesis's Figure 4.1.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "core/basics/typed_json.h"

namespace surefoot {

int probabilitiesCommand(const Registry& registry, const ProbabilitiesRequest& request) {
  const auto entry = findEntry(registry.policies, "--policy", request.policy);
  if (!entry) return fail(entry.error());
  const auto policy = (*entry)->make();
  Parameters parameters;
  parameters.add(*policy, "policy.");
  for (const Assignment& a : request.assignments)
    if (const Status s = parameters.set(a.key, std::string_view(a.value)); !s) return fail(s.error());
  parameters.applyTo(*policy, "policy.");

  // Nothing but values is known here.
  if (const Status s = policy->caution().check({}); !s) return fail(s.error());
  std::vector<double> pi(request.q.size());
  policy->probabilities({.q = request.q}, pi);
  if (request.json) {
    const nlohmann::ordered_json json = {{"q", request.q}, {"policy", request.policy}, {"probabilities", pi}};
    return print(jsonText(json) + "\n");
  }
  std::string text = fmt::format("{:>6}  {:>12}  {:>12}\n", "action", "Q", "probability");
  for (std::size_t a = 0; a < pi.size(); ++a)
    text += fmt::format("{:>6}  {:>12.6g}  {:>12.6g}\n", a, request.q[a], pi[a]);
  return print(text);
}

}  // namespace surefoot
