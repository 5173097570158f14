// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/registry.h"

#include <fmt/format.h>

#include "core/agents/sarsa_lambda.h"
#include "core/features/tile_coder.h"
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

/// The parameters of one table of weights: tiles and initial values, under "features.".
void declareTable(TileCoder::Settings& tiles, InitialValue& initial, Fields& f) {
  tiles.declare(f);
  initial.declare(f);
}

Status declareSarsa(const Task& task, const std::string&, Parameters& parameters) {
  SarsaSettings settings;
  Fields agent("agent.");
  settings.declare(agent);
  parameters.add(agent);

  TileCoder::Settings tiles(task);
  InitialValue initial;
  Fields features("features.");
  declareTable(tiles, initial, features);
  parameters.add(features);
  return Done{};
}

Result<std::unique_ptr<Agent>> makeSarsa(const AgentParts& parts) {
  SarsaSettings settings;
  Fields agent("agent.");
  settings.declare(agent);
  parts.parameters.apply(agent);

  TileCoder::Settings tiles(parts.task);
  InitialValue initial;
  Fields features("features.");
  declareTable(tiles, initial, features);
  parts.parameters.apply(features);
  if (initial.low > initial.high)
    return Error{
        fmt::format("features.initial_low = {} and features.initial_high = {}: the low end must not be above the high.",
                    initial.low, initial.high)};

  Result<TileCoder> coder = TileCoder::create(parts.task, tiles);
  if (!coder) return coder.error();
  LinearActionValue<TileCoder> values(std::move(*coder), static_cast<int>(parts.task.actions.size()), initial,
                                      parts.weightSeed);
  return std::unique_ptr<Agent>(std::make_unique<SarsaLambda<TileCoder>>(std::move(values), settings));
}

}  // namespace

void registerCore(Registry& r) {
  r.features.push_back({{"tile-coder", "Tile coder", "Displaced grids of tiles, in a dense table."}});
  r.agents.push_back({{"sarsa", "Sarsa", "Sarsa(λ), the on-policy rule of the thesis."}, declareSarsa, makeSarsa});
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
