// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/register.h"

#include <fmt/format.h>

#include <variant>

#include "core/agents/sarsa_2q.h"
#include "core/agents/td_control.h"
#include "core/features/table.h"
#include "core/features/tile_coder.h"

namespace surefoot {

namespace {

/// An estimate's tiles and its learning, as numbers; the initial values are shared by all estimates of an agent.
struct EstimateParts {
  EstimateSettings learning;
  TileCoder::Settings tiles;
  explicit EstimateParts(const Task& task) : tiles(task) {}
  /// A table has no tiles to set.
  void declareFeatures(const std::string& features, Fields& f) {
    if (features == "tile-coder") tiles.declare(f);
  }
};

/// Every feature map that an estimate may stand on.
using AnyFeatures = std::variant<TileCoder, Table>;

Result<AnyFeatures> makeFeatures(const AgentParts& parts, const TileCoder::Settings& tiles) {
  if (parts.features == "table") {
    auto table = Table::create(parts.task);
    if (!table) return table.error();
    return AnyFeatures(std::move(*table));
  }
  auto coder = TileCoder::create(parts.task, tiles);
  if (!coder) return coder.error();
  return AnyFeatures(std::move(*coder));
}

Status checkInitial(const InitialValue& initial) {
  if (initial.low <= initial.high) return Done{};
  return Error{
      fmt::format("features.initial_low = {} and features.initial_high = {}: the low end must not be above the high.",
                  initial.low, initial.high)};
}

template <FeatureMap F>
Estimate<F> makeEstimate(const AgentParts& parts, F features, const InitialValue& initial, std::uint64_t seed,
                         const EstimateSettings& learning) {
  const auto actions = static_cast<int>(parts.task.actions.size());
  return Estimate<F>(LinearActionValue<F>(std::move(features), actions, initial, seed), learning);
}

/// Everything that an agent with one estimate is made from, declared under the keys that files and the command line
/// know.
struct OneEstimate {
  EstimateParts estimate;
  ControlSettings control;
  InitialValue initial;
  explicit OneEstimate(const Task& task) : estimate(task) {}
  Fields fields(const std::string& features) {
    Fields f("agent.");
    estimate.learning.declare(f);
    control.declare(f);
    f.under("features.", "", [&](Fields& g) {
      estimate.declareFeatures(features, g);
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
  Fields fields(const std::string& features) {
    Fields f("agent.");
    control.declare(f);
    const auto declare = [&](const char* prefix, const char* title, EstimateParts& parts) {
      f.under(prefix, title, [&](Fields& g) {
        parts.learning.declare(g);
        parts.declareFeatures(features, g);
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
Status declare(const Task& task, const std::string& features, Parameters& parameters) {
  Settings settings(task);
  parameters.add(settings.fields(features));
  return Done{};
}

template <class Target>
Result<std::unique_ptr<Agent>> makeControl(const AgentParts& parts) {
  OneEstimate s(parts.task);
  parts.parameters.apply(s.fields(parts.features));
  if (const Status status = checkInitial(s.initial); !status) return status.error();
  auto features = makeFeatures(parts, s.estimate.tiles);
  if (!features) return features.error();
  return std::visit(
      [&]<class F>(F& map) -> std::unique_ptr<Agent> {
        return std::make_unique<TdControl<Target, F>>(
            makeEstimate(parts, std::move(map), s.initial, parts.weightSeed, s.estimate.learning), s.control);
      },
      *features);
}

Result<std::unique_ptr<Agent>> makeSarsa2Q(const AgentParts& parts) {
  TwoEstimates s(parts.task);
  parts.parameters.apply(s.fields(parts.features));
  if (const Status status = checkInitial(s.initial); !status) return status.error();
  auto positive = makeFeatures(parts, s.positive.tiles), negative = makeFeatures(parts, s.negative.tiles);
  if (!positive) return Error{"Q⁺: " + positive.error().message};
  if (!negative) return Error{"Q⁻: " + negative.error().message};
  return std::visit(
      [&]<class P, class N>(P& fine, N& coarse) -> std::unique_ptr<Agent> {
        return std::make_unique<Sarsa2Q<P, N>>(
            makeEstimate(parts, std::move(fine), s.initial, parts.weightSeed, s.positive.learning),
            makeEstimate(parts, std::move(coarse), s.initial, mix64(parts.weightSeed), s.negative.learning), s.control,
            s.split);
      },
      *positive, *negative);
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
