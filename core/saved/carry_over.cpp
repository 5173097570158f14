// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/saved/carry_over.h"

#include <algorithm>
#include <cmath>

#include "core/basics/random.h"

namespace surefoot {

namespace {

constexpr double kShares[] = {1.0, 1.0, 0.7, 0.5, 0.3, 0.2, 0.1, 0.05};  // share of the error that each pass closes
constexpr double kStatesPerFeature = 8.0;
constexpr double kFewest = 1e4, kMost = 2e6;  // states of a pass
constexpr int kCheck = 20'000;                // states that the error is taken over

/// A state drawn uniformly from the whole range.
void draw(const Task& task, Random& random, std::vector<double>& state) {
  for (std::size_t d = 0; d < state.size(); ++d) {
    const StateVariable& v = task.state[d];
    state[d] = v.whole ? std::floor(random.uniform(v.low, v.high + 1)) : random.uniform(v.low, v.high);
  }
}

std::size_t featuresOf(const ActionValueFunction& f) {
  std::size_t most = 0;
  for (const MemoryUse& use : f.memoryUse()) most = std::max(most, use.slots);
  return most;
}

CarriedError errorBetween(const ActionValueFunction& a, const ActionValueFunction& b, const Task& task) {
  Random random(2);
  std::vector<double> state(task.state.size()), qa(task.actions.size()), qb(qa.size());
  CarriedError error;
  error.states = kCheck;
  double squares = 0.0, squaresVisited = 0.0;
  for (int i = 0; i < kCheck; ++i) {
    draw(task, random, state);
    a.evaluate(state, Layer::Sum, qa);
    b.evaluate(state, Layer::Sum, qb);
    const bool visited = a.visits(state) > 0;
    error.visited += visited;
    for (std::size_t k = 0; k < qa.size(); ++k) {
      const double difference = qb[k] - qa[k];
      squares += difference * difference;
      if (visited) squaresVisited += difference * difference;
      error.largest = std::max(error.largest, std::abs(difference));
    }
  }
  const auto count = static_cast<double>(qa.size());
  error.rms = std::sqrt(squares / (count * kCheck));
  if (error.visited > 0) error.rmsVisited = std::sqrt(squaresVisited / (count * static_cast<double>(error.visited)));
  return error;
}

}  // namespace

CarriedError carryOver(const ActionValueFunction& from, Agent& to, const Task& task,
                       const std::atomic<bool>* interrupted) {
  std::vector<Layer> layers = {Layer::Sum};
  if (from.split()) layers = {Layer::Positive, Layer::Negative};
  if (from.hasRisk() && to.values().hasRisk()) layers.push_back(Layer::Risk);
  const auto features = static_cast<double>(std::max(featuresOf(from), featuresOf(to.values())));
  const auto states = static_cast<int>(std::clamp(kStatesPerFeature * features, kFewest, kMost));
  Random random(1);
  std::vector<double> state(task.state.size()), q(task.actions.size());
  for (const double share : kShares)
    for (int i = 0; i < states && !(interrupted && *interrupted); ++i) {
      draw(task, random, state);
      const double visits = from.visits(state);
      for (const Layer layer : layers) {
        from.evaluate(state, layer, q);
        to.fit(state, layer, q, share, visits);
      }
    }
  return errorBetween(from, to.values(), task);
}

}  // namespace surefoot
