// SPDX-License-Identifier: GPL-3.0-or-later
// The options that every learner has: reward shaping, a falls budget, the risk of a fall. Each is an agent around the
// agent.
#pragma once

#include <memory>

#include "core/agents/falls_budget.h"
#include "core/agents/representation.h"
#include "core/agents/risk.h"
#include "core/agents/shaped.h"

namespace surefoot {

/// Reward shaping by a coarse state-value function.
struct ShapingParts {
  ShapingSettings shaping;
  RepresentationSettings representation;
  explicit ShapingParts(const Task& task);
  void declare(const std::string& features, Fields& f);
};

/// The risk of a fall, learned beside the values.
struct RiskParts {
  RiskSettings risk;
  EstimateSettings learning;
  RepresentationSettings representation;
  explicit RiskParts(const Task& task) : representation(task) {}
  void declare(const std::string& features, Fields& f);
};

/// All of them, from the inside to the outside.
struct OptionParts {
  ShapingParts shaping;
  BudgetSettings budget;
  RiskParts risk;
  explicit OptionParts(const Task& task) : shaping(task), risk(task) {}
  void declare(const std::string& features, Fields& f);
};

/// The named terms of a reward: the task's, and those that options add.
std::vector<std::string> termsOf(const Task& task);

/// The agent itself, or with its options around it; it gets the stored tables, if they were given. Of risk a file may
/// know nothing: then ρ begins at its initial value.
Result<std::unique_ptr<Agent>> withOptions(std::unique_ptr<Agent> agent, const OptionParts& o, const AgentParts& parts);

}  // namespace surefoot
