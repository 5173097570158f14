// SPDX-License-Identifier: GPL-3.0-or-later
// A row of states and two actions, walked through as a test says, to compute what an agent learns by hand.
#pragma once

#include <gtest/gtest.h>

#include "core/agents/td_control.h"
#include "core/features/tile_coder.h"

namespace surefoot {

/// Always the action that the test names; or, if `second` is set, the second of two with that probability.
class NamedActions final : public Policy {
 public:
  Action action = 0;
  double second = 0.0;
  void declareRule(Fields&) override {}
  void among(std::span<const double> q, std::span<double> pi) const override {
    for (std::size_t a = 0; a < q.size(); ++a) pi[a] = static_cast<int>(a) == action ? 1.0 : 0.0;
    if (second > 0.0) pi[0] = 1.0 - second, pi[1] = second;
  }
};

/// α, γ, λ and the kind of trace; the cut-off is 0.
struct RowSettings {
  double stepSize, discount, traceDecay;
  TraceKind trace = TraceKind::Replacing;
  OtherActions otherActions = OtherActions::Keep;
};

/// States 0, 1, 2, … each with a tile of its own; two actions; weights from 0.
template <class Target = SarsaTarget>
struct RowOfStates {
  explicit RowOfStates(const RowSettings& s, int tilings = 1) {
    Task task;
    task.state = {{.key = "s", .title = "s", .low = 0, .high = 9, .span = 1, .resolution = 1}};
    task.actions = {0, 1};
    TileCoder::Settings tiles(task);
    tiles.tilings = tilings;
    LinearActionValue<TileCoder> values(*TileCoder::create(task, tiles), 2, {0.0, 0.0}, 1);
    agent = std::make_unique<TdControl<Target, TileCoder>>(
        Estimate<TileCoder>(std::move(values), EstimateSettings{s.stepSize, s.traceDecay}),
        ControlSettings{s.discount, TraceSettings{0.0, s.trace, s.otherActions}});
    agent->setPolicy(policy);
  }
  double q(double state, Action a) const {
    std::vector<double> values(2);
    agent->values().evaluate(std::vector<double>{state}, Layer::Sum, values);
    return values[static_cast<std::size_t>(a)];
  }
  void start(double s) { agent->start(std::vector<double>{s}, random); }
  void step(double reward, double s) { agent->step({.reward = reward}, std::vector<double>{s}, random); }
  void truncate(double reward, double s) { agent->truncate({.reward = reward}, std::vector<double>{s}, random); }
  void end(double reward) { agent->end({.reward = reward}); }

  NamedActions policy;
  Random random{1};
  std::unique_ptr<Agent> agent;
};

}  // namespace surefoot
