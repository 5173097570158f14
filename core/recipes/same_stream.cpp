// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recipes/same_stream.h"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

/// A policy that chooses the action it was given.
class Dictated final : public Policy {
 public:
  Action action = 0;

 protected:
  void declareRule(Fields&) override {}
  void among(std::span<const double>, std::span<double> pi) const override {
    std::fill(pi.begin(), pi.end(), 0.0);
    pi[static_cast<std::size_t>(action)] = 1.0;
  }
};

Result<std::unique_ptr<Agent>> makeAgent(const Registry& registry, const Configuration& c, const Task& task) {
  const auto entry = findEntry(registry.agents, "agent", c.names.agent);
  if (!entry) return entry.error();
  return (*entry)->make({task, c.names.features, c.parameters, 0});
}

}  // namespace

Result<double> largestDifference(const Registry& registry, const Configuration& first, const Configuration& second,
                                 int steps) {
  const auto environment = makeEnvironment(registry, first);
  if (!environment) return environment.error();
  Environment& world = **environment;
  const std::size_t actions = world.task().actions.size();
  Dictated policy;
  std::vector<std::unique_ptr<Agent>> agents;
  for (const Configuration* c : {&first, &second}) {
    auto agent = makeAgent(registry, *c, world.task());
    if (!agent) return agent.error();
    (*agent)->setPolicy(policy);
    agents.push_back(std::move(*agent));
  }

  Random random(first.seed);
  std::vector<std::vector<double>> visited;
  bool inEpisode = false;
  for (int i = 0; i < steps; ++i) {
    if (!inEpisode) world.reset(random);
    const Action before = policy.action;
    policy.action = static_cast<Action>(random.uniform() * static_cast<double>(actions));
    if (!inEpisode) {
      for (auto& agent : agents) agent->start(world.state(), random);
      inEpisode = true;
      continue;
    }
    const Outcome outcome = world.step(before);
    inEpisode = outcome.ending == Ending::None;
    for (auto& agent : agents) {
      if (inEpisode)
        agent->step(outcome, world.state(), random);
      else if (outcome.ending == Ending::Terminal)
        agent->end(outcome);
      else
        agent->truncate(outcome, world.state(), random);
    }
    if (i % 10 == 0) visited.emplace_back(world.state().begin(), world.state().end());
  }

  double largest = 0;
  std::vector<double> q1(actions), q2(actions);
  for (const auto& state : visited) {
    agents[0]->values().evaluate(state, Layer::Sum, q1);
    agents[1]->values().evaluate(state, Layer::Sum, q2);
    for (std::size_t a = 0; a < actions; ++a) largest = std::max(largest, std::abs(q1[a] - q2[a]));
  }
  return largest;
}

}  // namespace surefoot
