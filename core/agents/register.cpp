// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/register.h"

#include <fmt/format.h>

#include "core/agents/representation.h"
#include "core/agents/risk.h"
#include "core/agents/sarsa_2q.h"
#include "core/agents/scripted.h"
#include "core/agents/shaped.h"
#include "core/agents/td_control.h"

namespace surefoot {

namespace {

/// The option that every agent has: reward shaping by a coarse state-value function.
struct ShapingParts {
  ShapingSettings shaping;
  RepresentationSettings representation;
  explicit ShapingParts(const Task& task) : representation(task) {
    representation.tiles.tilings = 1;  // an aggregation of states
    representation.tiles.scale = representation.gaussians.scale = 0.5;
  }
  void declare(const std::string& features, Fields& f) {
    f.under("shaping.", "V", [&](Fields& g) { representation.declare(features, g); });
    for (const auto& field : f.all())
      if (field.parameter.key.starts_with("shaping.")) f.setOrder(field.parameter.key, 3);
    f.setNeeds("shaping.", "shaping.rewards");
    f.under("shaping.", "", [&](Fields& g) { shaping.declare(g); });
  }
};

/// The other option: the risk of a fall, learned beside the values.
struct RiskParts {
  RiskSettings risk;
  EstimateSettings learning;
  RepresentationSettings representation;
  explicit RiskParts(const Task& task) : representation(task) {}
  void declare(const std::string& features, Fields& f) {
    f.under("risk.", "ρ", [&](Fields& g) {
      learning.declare(g);
      representation.declare(features, g);
    });
    for (const auto& field : f.all())
      if (field.parameter.key.starts_with("risk.")) f.setOrder(field.parameter.key, 3);
    f.setNeeds("risk.", "risk.learn");
    f.under("risk.", "", [&](Fields& g) { risk.declare(g); });
  }
};

/// An estimate's features and its learning, as numbers; the initial values are shared by all estimates of an agent.
struct EstimateParts {
  EstimateSettings learning;
  RepresentationSettings representation;
  explicit EstimateParts(const Task& task) : representation(task) {}
};

/// Everything that an agent with one estimate is made from, declared under the keys that files and the command line
/// know.
struct OneEstimate {
  EstimateParts estimate;
  ControlSettings control;
  InitialValue initial;
  ShapingParts shaping;
  RiskParts risk;
  explicit OneEstimate(const Task& task) : estimate(task), shaping(task), risk(task) {}
  Fields fields(const std::string& features) {
    Fields f("agent.");
    estimate.learning.declare(f);
    control.declare(f);
    f.under("features.", "", [&](Fields& g) {
      estimate.representation.declare(features, g);
      initial.declare(g);
    });
    shaping.declare(features, f);
    risk.declare(features, f);
    return f;
  }
};

/// The terms of a reward, with the term that shaping adds.
std::vector<std::string> termsOf(const Task& task) {
  std::vector<std::string> terms = task.rewardTerms;
  terms.emplace_back("shaping");
  return terms;
}

/// The same for Sarsa_2Q.
struct TwoEstimates {
  EstimateParts positive, negative;
  ControlSettings control;
  InitialValue initial;
  RewardSplit split;
  ShapingParts shaping;
  RiskParts risk;
  explicit TwoEstimates(const Task& task)
      : positive(task),
        negative(task),
        split(termsOf(task)),
        shaping(task),
        risk(task) {}
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
    shaping.declare(features, f);
    risk.declare(features, f);
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

/// An agent that learns the risk of a fall, too.
Result<std::unique_ptr<Agent>> withRisk(std::unique_ptr<Agent> agent, const RiskParts& r, const AgentParts& parts) {
  auto features = makeFeatures(parts.task, parts.features, r.representation);
  if (!features) return Error{"risk: " + features.error().message};
  return std::visit(
      [&]<class F>(F& map) -> Result<std::unique_ptr<Agent>> {
        const InitialValue initial{r.risk.initial, r.risk.initial};
        auto risk = makeEstimate("risk", std::move(map), parts.actions(), initial, 0, r.learning, parts.stored);
        if (!risk) return risk.error();
        return std::unique_ptr<Agent>(std::make_unique<RiskAgent<F>>(std::move(agent), std::move(*risk), r.risk));
      },
      *features);
}

/// The agent itself, or with shaping around it and risk beside it; it gets the stored tables, if they were given.
Result<std::unique_ptr<Agent>> complete(std::unique_ptr<Agent> agent, const ShapingParts& s, const RiskParts& r,
                                        const AgentParts& parts) {
  if (s.shaping.kind != Shaping::Off) {
    auto features = makeFeatures(parts.task, parts.features, s.representation);
    if (!features) return Error{"shaping: " + features.error().message};
    Result<std::unique_ptr<Agent>> shaped = std::visit(
        [&]<class F>(F& map) -> Result<std::unique_ptr<Agent>> {
          const EstimateSettings learning{s.shaping.stepSize, 0.0};
          auto potential =
              makeEstimate("potential", std::move(map), 1, InitialValue{0.0, 0.0}, 0, learning, parts.stored);
          if (!potential) return potential.error();
          return std::unique_ptr<Agent>(std::make_unique<ShapedAgent<F>>(std::move(agent), std::move(*potential),
                                                                         s.shaping, parts.task.rewardTerms.size()));
        },
        *features);
    if (!shaped) return shaped.error();
    agent = std::move(*shaped);
  }
  if (r.risk.learn == RiskLearning::On) {
    auto both = withRisk(std::move(agent), r, parts);
    if (!both) return both.error();
    agent = std::move(*both);
  }
  if (parts.stored) {
    Archive archive = Archive::reader(*parts.stored);
    agent->transferValues(archive);
    if (!archive.good()) return archive.status().error();
  }
  return agent;
}

template <class Target>
Result<std::unique_ptr<Agent>> makeControl(const AgentParts& parts) {
  const auto s = settingsFrom<OneEstimate>(parts);
  if (!s) return s.error();
  auto features = makeFeatures(parts.task, parts.features, s->estimate.representation);
  if (!features) return features.error();
  return std::visit(
      [&]<class F>(F& map) -> Result<std::unique_ptr<Agent>> {
        auto estimate = makeEstimate("q", std::move(map), parts.actions(), s->initial, parts.weightSeed,
                                     s->estimate.learning, parts.stored);
        if (!estimate) return estimate.error();
        return complete(std::make_unique<TdControl<Target, F>>(std::move(*estimate), s->control), s->shaping, s->risk,
                        parts);
      },
      *features);
}

Result<std::unique_ptr<Agent>> makeSarsa2Q(const AgentParts& parts) {
  const auto s = settingsFrom<TwoEstimates>(parts);
  if (!s) return s.error();
  auto positive = makeFeatures(parts.task, parts.features, s->positive.representation);
  auto negative = makeFeatures(parts.task, parts.features, s->negative.representation);
  if (!positive) return Error{"Q⁺: " + positive.error().message};
  if (!negative) return Error{"Q⁻: " + negative.error().message};
  return std::visit(
      [&]<class P, class N>(P& gains, N& losses) -> Result<std::unique_ptr<Agent>> {
        auto plus = makeEstimate("positive", std::move(gains), parts.actions(), s->initial, parts.weightSeed,
                                 s->positive.learning, parts.stored);
        if (!plus) return plus.error();
        auto minus = makeEstimate("negative", std::move(losses), parts.actions(), s->initial, mix64(parts.weightSeed),
                                  s->negative.learning, parts.stored);
        if (!minus) return minus.error();
        return complete(std::make_unique<Sarsa2Q<P, N>>(std::move(*plus), std::move(*minus), s->control, s->split),
                        s->shaping, s->risk, parts);
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
                      declare<OneEstimate>,
                      makeControl<SarsaTarget>});
  r.agents.push_back({{"sarsa-2q", "Sarsa_2Q", "Sarsa(λ) with expected gains and losses in two Q-functions."},
                      declare<TwoEstimates>,
                      makeSarsa2Q});
  r.agents.push_back(
      {{"q-learning", "Q-learning", "Watkins's Q(λ), off-policy."}, declare<OneEstimate>, makeControl<WatkinsTarget>});
  r.agents.push_back({{"scripted", "Hand-made", "The environment's own controller, which does not learn."},
                      [](const Task& task, const std::string&, Parameters&) { return checkHandMade(task); },
                      [](const AgentParts& parts) -> Result<std::unique_ptr<Agent>> {
                        if (const Status s = checkHandMade(parts.task); !s) return s.error();
                        return std::unique_ptr<Agent>(std::make_unique<Scripted>(parts.actions()));
                      }});
  r.agents.push_back(
      {{"expected-sarsa", "Expected Sarsa", "Expected Sarsa(λ): the mean over the policy in place of one draw."},
       declare<OneEstimate>,
       makeControl<ExpectedTarget>});
}

}  // namespace surefoot
