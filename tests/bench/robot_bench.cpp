// SPDX-License-Identifier: GPL-3.0-or-later
// Robots from files beside the compiled worlds that they describe. The counter is steps per CPU-second.
#include "core/environment_library.h"
#include "core/environment_programs.h"
#include "tests/bench/living.h"
#include "tests/full_registry.h"

namespace surefoot {

namespace {

const Registry& worlds() {
  static const Registry filled = [] {
    Registry registry = fullRegistry();
    registry.programs->allowAll();
    registry.programs->setModules(std::string(SUREFOOT_SOURCE) + "/resources/robots/child");
    return registry;
  }();
  return filled;
}

std::string pathOf(const std::string& name) {
  return std::string(SUREFOOT_SOURCE) + "/resources/robots/" + name + ".toml";
}

void learns(benchmark::State& state, const std::string& environment) {
  live(state, worlds(), {.environment = environment}, {});
}
BENCHMARK_CAPTURE(learns, pendulum, "pendulum");
BENCHMARK_CAPTURE(learns, pendulum_file, pathOf("pendulum-file"));
BENCHMARK_CAPTURE(learns, compass, "compass");
BENCHMARK_CAPTURE(learns, compass_file, pathOf("compass-file"));
BENCHMARK_CAPTURE(learns, leo, "leo");
BENCHMARK_CAPTURE(learns, leo_file, pathOf("leo-file"));

/// The world alone, with random actions.
void moves(benchmark::State& state, const std::string& name) {
  const auto named = environmentNamed(worlds(), name);
  if (!named) return state.SkipWithError(named.error().message.c_str());
  const auto environment = (*findEnvironment(worlds(), *named))->make();
  Random random(1);
  environment->reset(random);
  const auto actions = static_cast<std::uint64_t>(environment->task().actions.size());
  for (auto _ : state)
    if (environment->step(static_cast<Action>(random.next() % actions)).ending != Ending::None)
      environment->reset(random);
  state.counters["steps/s"] = benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(moves, pendulum, "pendulum");
BENCHMARK_CAPTURE(moves, pendulum_file, pathOf("pendulum-file"));
BENCHMARK_CAPTURE(moves, compass, "compass");
BENCHMARK_CAPTURE(moves, compass_file, pathOf("compass-file"));
BENCHMARK_CAPTURE(moves, hopper, pathOf("hopper"));
BENCHMARK_CAPTURE(moves, biped, pathOf("biped"));

/// A program in Python, by the wall clock: most of the time is the kernel's.
BENCHMARK_CAPTURE(moves, car_in_python, pathOf("child/car"))->UseRealTime();

}  // namespace
}  // namespace surefoot
