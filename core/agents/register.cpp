// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/register.h"

#include <fmt/format.h>

#include "core/agents/options.h"
#include "core/agents/representation.h"
#include "core/agents/sarsa_2q.h"
#include "core/agents/scripted.h"
#include "core/agents/td_control.h"

namespace surefoot {

namespace {

/// An estimate's features and its learning, as numbers; the initial values are shared by all estimates of an agent.
struct EstimateParts {
  EstimateSettings learning;
  RepresentationSettings representation;
  explicit EstimateParts(const Task& task) : representation(task) {}
};

/// Everything that an agent with one estimate is made from, declared under the keys that files and the command line
/// know.
template <class Target>
struct OneEstimate {
  EstimateParts estimate;
  ControlSettings control;
  InitialValue initial;
  OptionParts options;
  explicit OneEstimate(const Task& task) : estimate(task), options(task) {
    control.dutch = std::is_same_v<Target, TrueOnlineTarget>;
  }
  Fields fields(const std::string& features) {
    Fields f("agent.");
    estimate.learning.declare(f);
    control.declare(f);
    f.under("features.", "", [&](Fields& g) {
      estimate.representation.declare(features, g);
      initial.declare(g);
    });
    options.declare(features, f);
    return f;
  }
};

/// The same for Sarsa_2Q.
struct TwoEstimates {
  EstimateParts positive, negative;
  ControlSettings control;
  InitialValue initial;
  RewardSplit split;
  OptionParts options;
  explicit TwoEstimates(const Task& task) : positive(task), negative(task), split(termsOf(task)), options(task) {}
  Fields fields(const std::string& features) {
    Fields f("agent.");
    control.declare(f);
    const auto declare = [&](const char* prefix, const char* title, EstimateParts& parts) {
      f.under(prefix, title, [&](Fields& g) {
        parts.learning.declare(g);
        parts.representation.declare(features, g);
      });
    };
    declare("positive.", "Q⁺", positive);
    declare("negative.", "Q⁻", negative);
    // Q⁻ differs from Q⁺ by its scale, as in the thesis's chapter 6; its other parameters are shown in a larger window.
    for (const auto& field : f.all())
      if (field.parameter.key.starts_with("negative.") && field.parameter.order < 2) f.setOrder(field.parameter.key, 2);
    f.setOrder("negative.scale", 1);
    f.under("split.", "", [&](Fields& g) { split.declare(g); });
    f.under("features.", "", [&](Fields& g) { initial.declare(g); });
    options.declare(features, f);
    return f;
  }
};

template <class Settings>
Status declare(const Task& task, const std::string& features, Parameters& parameters) {
  Settings settings(task);
  parameters.add(settings.fields(features));
  return Done{};
}

template <class Settings>
Result<Settings> settingsFrom(const AgentParts& parts) {
  Settings s(parts.task);
  parts.parameters.apply(s.fields(parts.features));
  if (s.initial.low <= s.initial.high) return s;
  return Error{
      fmt::format("features.initial_low = {} and features.initial_high = {}: the low end must not be above the high.",
                  s.initial.low, s.initial.high)};
}

template <class Target>
Result<std::unique_ptr<Agent>> makeControl(const AgentParts& parts) {
  const auto s = settingsFrom<OneEstimate<Target>>(parts);
  if (!s) return s.error();
  auto features = makeFeatures(parts.task, parts.features, s->estimate.representation, "features.");
  if (!features) return features.error();
  return std::visit(
      [&]<class F>(F& map) -> Result<std::unique_ptr<Agent>> {
        auto estimate = makeEstimate("q", std::move(map), parts.actions(), s->initial, parts.weightSeed,
                                     s->estimate.learning, parts.stored);
        if (!estimate) return estimate.error();
        return withOptions(std::make_unique<TdControl<Target, F>>(std::move(*estimate), s->control), s->options, parts);
      },
      *features);
}

Result<std::unique_ptr<Agent>> makeSarsa2Q(const AgentParts& parts) {
  const auto s = settingsFrom<TwoEstimates>(parts);
  if (!s) return s.error();
  auto positive = makeFeatures(parts.task, parts.features, s->positive.representation, "positive.");
  auto negative = makeFeatures(parts.task, parts.features, s->negative.representation, "negative.");
  if (!positive) return positive.error();
  if (!negative) return negative.error();
  return std::visit(
      [&]<class P, class N>(P& gains, N& losses) -> Result<std::unique_ptr<Agent>> {
        auto plus = makeEstimate("positive", std::move(gains), parts.actions(), s->initial, parts.weightSeed,
                                 s->positive.learning, parts.stored);
        if (!plus) return plus.error();
        auto minus = makeEstimate("negative", std::move(losses), parts.actions(), s->initial, mix64(parts.weightSeed),
                                  s->negative.learning, parts.stored);
        if (!minus) return minus.error();
        return withOptions(std::make_unique<Sarsa2Q<P, N>>(std::move(*plus), std::move(*minus), s->control, s->split),
                           s->options, parts);
      },
      *positive, *negative);
}

Status checkHandMade(const Task& task) {
  if (task.handMade) return Done{};
  return Error{"agent: scripted is for environments that have a hand-made controller: leo."};
}

}  // namespace

void registerAgents(Registry& r) {
  r.agents.push_back({{"sarsa", "Sarsa", "Sarsa(λ), the on-policy rule of the thesis."},
                      declare<OneEstimate<SarsaTarget>>,
                      makeControl<SarsaTarget>});
  r.agents.push_back({{"sarsa-2q", "Sarsa_2Q", "Sarsa(λ) with expected gains and losses in two Q-functions."},
                      declare<TwoEstimates>,
                      makeSarsa2Q});
  r.agents.push_back({{"q-learning", "Q-learning", "Watkins's Q(λ), off-policy."},
                      declare<OneEstimate<WatkinsTarget>>,
                      makeControl<WatkinsTarget>});
  r.agents.push_back({{"scripted", "Hand-made", "The environment's own controller, which does not learn."},
                      [](const Task& task, const std::string&, Parameters&) { return checkHandMade(task); },
                      [](const AgentParts& parts) -> Result<std::unique_ptr<Agent>> {
                        if (const Status s = checkHandMade(parts.task); !s) return s.error();
                        return std::unique_ptr<Agent>(std::make_unique<Scripted>(parts.actions()));
                      }});
  r.agents.push_back({{"true-online-sarsa", "True online Sarsa",
                       "Sarsa(λ) that equals its forward view, but for the cut-off of its traces."},
                      declare<OneEstimate<TrueOnlineTarget>>,
                      makeControl<TrueOnlineTarget>});
  r.agents.push_back(
      {{"expected-sarsa", "Expected Sarsa", "Expected Sarsa(λ): the mean over the policy in place of one draw."},
       declare<OneEstimate<ExpectedTarget>>,
       makeControl<ExpectedTarget>});
}

}  // namespace surefoot
