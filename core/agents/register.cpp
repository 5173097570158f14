// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/register.h"

#include <fmt/format.h>

#include "core/agents/sarsa_2q.h"
#include "core/agents/td_control.h"
#include "core/features/tile_coder.h"

namespace surefoot {

namespace {

using Values = LinearActionValue<TileCoder>;

/// An estimate's tiles and its learning, as numbers; the initial values are shared by all estimates of an agent.
struct EstimateParts {
  EstimateSettings learning;
  TileCoder::Settings tiles;
  explicit EstimateParts(const Task& task) : tiles(task) {}
};

Result<Values> makeValues(const AgentParts& parts, const TileCoder::Settings& tiles, const InitialValue& initial,
                          std::uint64_t seed) {
  if (initial.low > initial.high)
    return Error{
        fmt::format("features.initial_low = {} and features.initial_high = {}: the low end must not be above the high.",
                    initial.low, initial.high)};
  Result<TileCoder> coder = TileCoder::create(parts.task, tiles);
  if (!coder) return coder.error();
  return Values(std::move(*coder), static_cast<int>(parts.task.actions.size()), initial, seed);
}

/// Everything that an agent with one estimate is made from, declared under the keys that files and the command line
/// know.
struct OneEstimate {
  EstimateParts estimate;
  ControlSettings control;
  InitialValue initial;
  explicit OneEstimate(const Task& task) : estimate(task) {}
  Fields fields() {
    Fields f("agent.");
    estimate.learning.declare(f);
    control.declare(f);
    f.under("features.", "", [&](Fields& g) {
      estimate.tiles.declare(g);
      initial.declare(g);
    });
    return f;
  }
};

/// The same for Sarsa_2Q.
struct TwoEstimates {
  EstimateParts positive, negative;
  ControlSettings control;
  InitialValue initial;
  RewardSplit split;
  explicit TwoEstimates(const Task& task) : positive(task), negative(task), split(task.rewardTerms) {}
  Fields fields() {
    Fields f("agent.");
    control.declare(f);
    const auto declare = [&](const char* prefix, const char* title, EstimateParts& parts) {
      f.under(prefix, title, [&](Fields& g) {
        parts.learning.declare(g);
        parts.tiles.declare(g);
      });
    };
    declare("positive.", "Q⁺", positive);
    declare("negative.", "Q⁻", negative);
    // Q⁻ is told from Q⁺ by its scale, as in the thesis's chapter 6; the rest of it is for a closer look.
    for (const auto& field : f.all())
      if (field.parameter.key.starts_with("negative.")) f.setOrder(field.parameter.key, 2);
    f.setOrder("negative.scale", 1);
    f.under("split.", "", [&](Fields& g) { split.declare(g); });
    f.under("features.", "", [&](Fields& g) { initial.declare(g); });
    return f;
  }
};

template <class Settings>
Status declare(const Task& task, const std::string&, Parameters& parameters) {
  Settings settings(task);
  parameters.add(settings.fields());
  return Done{};
}

template <class Target>
Result<std::unique_ptr<Agent>> makeControl(const AgentParts& parts) {
  OneEstimate settings(parts.task);
  parts.parameters.apply(settings.fields());
  auto values = makeValues(parts, settings.estimate.tiles, settings.initial, parts.weightSeed);
  if (!values) return values.error();
  return std::unique_ptr<Agent>(
      std::make_unique<TdControl<Target, TileCoder>>(std::move(*values), settings.estimate.learning, settings.control));
}

Result<std::unique_ptr<Agent>> makeSarsa2Q(const AgentParts& parts) {
  TwoEstimates settings(parts.task);
  parts.parameters.apply(settings.fields());
  auto positive = makeValues(parts, settings.positive.tiles, settings.initial, parts.weightSeed);
  if (!positive) return Error{"positive: " + positive.error().message};
  auto negative = makeValues(parts, settings.negative.tiles, settings.initial, mix64(parts.weightSeed));
  if (!negative) return Error{"negative: " + negative.error().message};
  return std::unique_ptr<Agent>(std::make_unique<Sarsa2Q<TileCoder, TileCoder>>(
      Estimate<TileCoder>(std::move(*positive), settings.positive.learning),
      Estimate<TileCoder>(std::move(*negative), settings.negative.learning), settings.control, settings.split));
}

}  // namespace

void registerAgents(Registry& r) {
  r.agents.push_back({{"sarsa", "Sarsa", "Sarsa(λ), the on-policy rule of the thesis."},
                      declare<OneEstimate>,
                      makeControl<SarsaTarget>});
  r.agents.push_back({{"sarsa-2q", "Sarsa_2Q", "Sarsa(λ) with expected gains and losses in two Q-functions."},
                      declare<TwoEstimates>,
                      makeSarsa2Q});
  r.agents.push_back(
      {{"q-learning", "Q-learning", "Watkins's Q(λ), off-policy."}, declare<OneEstimate>, makeControl<WatkinsTarget>});
  r.agents.push_back(
      {{"expected-sarsa", "Expected Sarsa", "Expected Sarsa(λ): the mean over the policy in place of one draw."},
       declare<OneEstimate>,
       makeControl<ExpectedTarget>});
}

}  // namespace surefoot
