// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/registry.h"

#include <fmt/format.h>

#include "core/agents/register.h"
#include "core/environments/register.h"
#include "core/policies/epsilon_greedy.h"
#include "core/policies/greedy.h"
#include "core/policies/softmax.h"
#include "core/policies/threshold_restricted.h"
#include "core/text.h"

namespace surefoot {

namespace {

template <class P>
std::unique_ptr<Policy> makePolicy() {
  return std::make_unique<P>();
}

}  // namespace

void registerCore(Registry& r) {
  r.features.push_back({{"tile-coder", "Tile coder", "Displaced grids of tiles, in a dense or hashed table."}});
  r.features.push_back({{"radial-basis", "Radial basis", "Gaussians on a grid, width and spacing set apart."}});
  r.features.push_back({{"table", "Table", "One value a state, for states of whole numbers."}});
  registerAgents(r);
  registerEnvironments(r);
  r.policies.push_back(
      {{"epsilon-greedy", "ε-greedy", "The best action, but any with probability ε."}, makePolicy<EpsilonGreedy>});
  r.policies.push_back(
      {{"trl", "TRL", "ε-greedy that explores among the actions above a threshold."}, makePolicy<ThresholdRestricted>});
  r.policies.push_back(
      {{"softmax", "Softmax", "The better an action, the likelier, by a temperature."}, makePolicy<Softmax>});
  r.policies.push_back({{"greedy", "Greedy", "Always the best action."}, makePolicy<Greedy>});
}

Error unknownName(std::string_view what, std::string_view name, const std::vector<std::string>& names) {
  const std::string near = nearestWord(name, names);
  return Error{fmt::format("{}: there is no \"{}\"{}; choose {}.", what, shortened(name),
                           near.empty() ? "" : fmt::format(", did you mean {}", near), joinWords(names, "or"))};
}

}  // namespace surefoot
