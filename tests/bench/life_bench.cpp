// SPDX-License-Identifier: GPL-3.0-or-later
// The whole learning loop: environment, features, choice, update, log. The counter is steps per CPU-second.
#include <benchmark/benchmark.h>

#include "tests/bench/living.h"
#include "tests/full_registry.h"

namespace surefoot {

namespace {

const Registry& registry() {
  static const Registry filled = fullRegistry();
  return filled;
}

void pendulum(benchmark::State& state, const char* agent, const char* features, const char* policy) {
  live(state, registry(), {.environment = "pendulum", .agent = agent, .features = features, .policy = policy}, {});
}
BENCHMARK_CAPTURE(pendulum, sarsa, "sarsa", "tile-coder", "epsilon-greedy");
BENCHMARK_CAPTURE(pendulum, trl, "sarsa", "tile-coder", "trl");
BENCHMARK_CAPTURE(pendulum, softmax, "sarsa", "tile-coder", "softmax");
BENCHMARK_CAPTURE(pendulum, sarsa_2q, "sarsa-2q", "tile-coder", "epsilon-greedy");
BENCHMARK_CAPTURE(pendulum, radial_basis, "sarsa", "radial-basis", "epsilon-greedy");

void mountainCar(benchmark::State& state, const char* lambda) {
  live(state, registry(),
       {.environment = "mountain-car", .agent = "sarsa", .features = "tile-coder", .policy = "greedy"},
       {{"agent.trace_decay", lambda}, {"agent.discount", "1"}, {"features.initial_high", "0"}});
}
BENCHMARK_CAPTURE(mountainCar, lambda_0, "0");
BENCHMARK_CAPTURE(mountainCar, lambda_50, "0.5");
BENCHMARK_CAPTURE(mountainCar, lambda_90, "0.9");
BENCHMARK_CAPTURE(mountainCar, lambda_98, "0.98");

void tilings(benchmark::State& state) {
  live(state, registry(),
       {.environment = "mountain-car", .agent = "sarsa", .features = "tile-coder", .policy = "greedy"},
       {{"agent.discount", "1"}, {"features.tilings", std::to_string(state.range(0))}, {"features.initial_high", "0"}});
}
BENCHMARK(tilings)->RangeMultiplier(2)->Range(1, 128);

void cliff(benchmark::State& state) {
  live(state, registry(), {.environment = "cliff", .agent = "sarsa", .features = "table", .policy = "epsilon-greedy"},
       {{"agent.trace_decay", "0"}});
}
BENCHMARK(cliff);

/// The world alone, with random actions.
void world(benchmark::State& state, const char* name) {
  const auto entry = findEntry(registry().environments, "environment", name);
  const auto environment = (*entry)->make();
  Random random(1);
  environment->reset(random);
  const auto actions = static_cast<std::uint64_t>(environment->task().actions.size());
  for (auto _ : state)
    if (environment->step(static_cast<Action>(random.next() % actions)).ending != Ending::None)
      environment->reset(random);
  state.counters["steps/s"] = benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(world, pendulum, "pendulum");
BENCHMARK_CAPTURE(world, mountain_car, "mountain-car");

}  // namespace
}  // namespace surefoot
