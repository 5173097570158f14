// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/options.h"

namespace surefoot {

ShapingParts::ShapingParts(const Task& task) : representation(task) {
  representation.tiles.tilings = 1;  // an aggregation of states
  representation.tiles.scale = representation.gaussians.scale = 0.5;
}

void ShapingParts::declare(const std::string& features, Fields& f) {
  f.under("shaping.", "V", [&](Fields& g) { representation.declare(features, g); });
  for (const auto& field : f.all())
    if (field.parameter.key.starts_with("shaping.")) f.setOrder(field.parameter.key, 3);
  f.setNeeds("shaping.", "shaping.rewards");
  f.under("shaping.", "", [&](Fields& g) { shaping.declare(g); });
}

void RiskParts::declare(const std::string& features, Fields& f) {
  f.under("risk.", "ρ", [&](Fields& g) {
    learning.declare(g);
    representation.declare(features, g);
  });
  for (const auto& field : f.all())
    if (const std::string& key = field.parameter.key; key.starts_with("risk."))
      f.setPlace(key, Group::Risk, key == "risk.step_size" || key == "risk.scale" ? 1 : 3);
  f.setNeeds("risk.", "risk.learn");
  f.under("risk.", "", [&](Fields& g) { risk.declare(g); });
}

void OptionParts::declare(const std::string& features, Fields& f) {
  shaping.declare(features, f);
  budget.declare(f);
  risk.declare(features, f);
}

std::vector<std::string> termsOf(const Task& task) {
  std::vector<std::string> terms = task.rewardTerms;
  terms.emplace_back("shaping");
  terms.emplace_back("price_of_fall");
  return terms;
}

namespace {

bool knowsRisk(const TensorFile& file) {
  const auto estimates = file.about.find("estimates");
  return estimates != file.about.end() && estimates->is_object() && estimates->contains("risk");
}

/// An agent that learns the risk of a fall, too.
Result<std::unique_ptr<Agent>> withRisk(std::unique_ptr<Agent> agent, const RiskParts& r, const TensorFile* stored,
                                        const AgentParts& parts) {
  auto features = makeFeatures(parts.task, parts.features, r.representation, "risk.");
  if (!features) return features.error();
  return std::visit(
      [&]<class F>(F& map) -> Result<std::unique_ptr<Agent>> {
        const InitialValue initial{r.risk.initial, r.risk.initial};
        auto risk = makeEstimate("risk", std::move(map), parts.actions(), initial, 0, r.learning, stored);
        if (!risk) return risk.error();
        return std::unique_ptr<Agent>(std::make_unique<RiskAgent<F>>(std::move(agent), std::move(*risk), r.risk));
      },
      *features);
}

Result<std::unique_ptr<Agent>> withShaping(std::unique_ptr<Agent> agent, const ShapingParts& s,
                                           const AgentParts& parts) {
  auto features = makeFeatures(parts.task, parts.features, s.representation, "shaping.");
  if (!features) return features.error();
  return std::visit(
      [&]<class F>(F& map) -> Result<std::unique_ptr<Agent>> {
        const EstimateSettings learning{s.shaping.stepSize, 0.0};
        auto potential =
            makeEstimate("potential", std::move(map), 1, InitialValue{0.0, 0.0}, 0, learning, parts.stored);
        if (!potential) return potential.error();
        return std::unique_ptr<Agent>(std::make_unique<ShapedAgent<F>>(std::move(agent), std::move(*potential),
                                                                       s.shaping, parts.task.rewardTerms.size()));
      },
      *features);
}

Status readTables(Agent& agent, const TensorFile* stored) {
  if (!stored) return Done{};
  Archive archive = Archive::reader(*stored);
  agent.transferValues(archive);
  return archive.status();
}

}  // namespace

Result<std::unique_ptr<Agent>> withOptions(std::unique_ptr<Agent> agent, const OptionParts& o,
                                           const AgentParts& parts) {
  if (o.shaping.shaping.kind != Shaping::Off) {
    auto shaped = withShaping(std::move(agent), o.shaping, parts);
    if (!shaped) return shaped.error();
    agent = std::move(*shaped);
  }
  if (o.budget.kind == Budgeting::On)
    agent = std::make_unique<FallsBudget>(std::move(agent), o.budget, parts.task.rewardTerms.size() + 1);
  const bool risk = o.risk.risk.learn == RiskLearning::On, known = parts.stored && knowsRisk(*parts.stored);
  if (risk && !known)
    if (const Status s = readTables(*agent, parts.stored); !s) return s.error();
  if (risk) {
    auto both = withRisk(std::move(agent), o.risk, known ? parts.stored : nullptr, parts);
    if (!both) return both.error();
    agent = std::move(*both);
  }
  if (!risk || known)
    if (const Status s = readTables(*agent, parts.stored); !s) return s.error();
  return agent;
}

}  // namespace surefoot
