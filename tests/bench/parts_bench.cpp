// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a step, and what the window and the files ask for.
#include <benchmark/benchmark.h>

#include "core/expression/compile.h"
#include "core/features/tile_coder.h"
#include "core/saved/q_file.h"
#include "core/values/deferred_trace.h"
#include "core/values/eligibility_trace.h"
#include "tests/full_registry.h"

namespace surefoot {

namespace {

/// A pendulum that has learned for two minutes.
struct Learned {
  Registry registry = fullRegistry();
  Configuration configuration;
  std::unique_ptr<Life> life;
  Learned() {
    configuration = *configure(registry, {}, {});
    configuration.minutes = 2.0;
    life = std::move(*makeLife(registry, configuration, 0, false));
    while (!life->finished()) life->step();
  }
};

void tileCoder(benchmark::State& state) {
  const Registry registry = fullRegistry();
  const auto environment = (*findEntry(registry.environments, "environment", "pendulum"))->make();  // three variables
  const auto coder = TileCoder::create(environment->task(), TileSettings(environment->task()));
  Random random(1);
  std::vector<double> s(environment->task().state.size());
  TileCoder::Active x;
  for (auto _ : state) {
    for (double& value : s) value += random.uniform(-0.1, 0.1);
    benchmark::DoNotOptimize(coder->find(s, x));
  }
}
BENCHMARK(tileCoder);

/// A step of a trace of 16 marks, with marks that wander over a table of 10^5 weights.
template <class Trace>
void trace(benchmark::State& state) {
  WeightTable table(100'000);
  Trace trace;
  Random random(1);
  double centre = 50'000;
  const double factor = static_cast<double>(state.range(0)) / 1000.0;
  for (auto _ : state) {
    centre += random.uniform(-40, 40);
    if (centre < 1000 || centre > 99'000) centre = 50'000;
    trace.decay(table, factor, 0.01);
    for (int i = 0; i < 16; ++i) trace.replace(table, static_cast<Index>(centre + 30 * i));
    trace.add(table, 0.001);
  }
}
BENCHMARK(trace<EligibilityTrace>)->Arg(500)->Arg(900)->Arg(980);
BENCHMARK(trace<DeferredTrace>)->Arg(500)->Arg(900)->Arg(980);

void policy(benchmark::State& state, const char* name) {
  const Registry registry = fullRegistry();
  const auto entry = findEntry(registry.policies, "policy", name);
  const auto policy = (*entry)->make();
  const std::vector<double> q = {1.0, 60.0, 3.0, 70.0, 5.0};
  std::vector<double> pi(q.size());
  for (auto _ : state) {
    policy->probabilities({.q = q}, pi);
    benchmark::DoNotOptimize(pi.data());
  }
}
BENCHMARK_CAPTURE(policy, epsilon_greedy, "epsilon-greedy");
BENCHMARK_CAPTURE(policy, trl, "trl");
BENCHMARK_CAPTURE(policy, softmax, "softmax");

/// What a window asks for ten times a second.
void snapshot(benchmark::State& state) {
  const Learned learned;
  const ActionValueFunction& values = learned.life->agent().values();
  const auto copy = values.clone();
  for (auto _ : state) copy->assign(values);
}
BENCHMARK(snapshot)->Unit(benchmark::kMillisecond);

/// A map of 100 × 100 points.
void slice(benchmark::State& state) {
  const Learned learned;
  const ActionValueFunction& values = learned.life->agent().values();
  std::vector<double> q(5);
  for (auto _ : state)
    for (int i = 0; i < 100; ++i)
      for (int j = 0; j < 100; ++j) {
        const double s[] = {-1.4 + 0.028 * i, -12 + 0.24 * j, 0.0};
        values.evaluate(s, Layer::Sum, q);
        benchmark::DoNotOptimize(q.data());
      }
}
BENCHMARK(slice)->Unit(benchmark::kMillisecond);

/// Conditions of lessons and, later, expressions of robots.
class TwoNames final : public Vocabulary {
 public:
  Result<Quantity> find(std::string_view name, std::optional<std::string_view>) const override {
    return Quantity{name == "falls" ? 0 : 1};
  }
  std::vector<std::string> names() const override { return {}; }
};

void expression(benchmark::State& state, const char* text) {
  const auto compiled = compile(text, ValueKind::Flag, TwoNames());
  double values[] = {17.0, 0.3};
  for (auto _ : state) {
    values[0] += 1e-9;
    benchmark::DoNotOptimize(compiled->evaluate(values));
  }
}
BENCHMARK_CAPTURE(expression, condition, "falls >= 2 * x and falls < 200");
BENCHMARK_CAPTURE(expression, reward, "-2 * square(x) - 0.1 * square(falls) - 1");
BENCHMARK_CAPTURE(expression, sine, "sin(x) * falls + cos(x)");

void saveQ(benchmark::State& state) {
  const Learned learned;
  for (auto _ : state) benchmark::DoNotOptimize(qFileOf(*learned.life, learned.configuration).write());
}
BENCHMARK(saveQ)->Unit(benchmark::kMillisecond);

void loadQ(benchmark::State& state) {
  const Learned learned;
  const std::string bytes = qFileOf(*learned.life, learned.configuration).write();
  for (auto _ : state) {
    Configuration c = learned.configuration;
    beginWith(c, std::make_shared<const TensorFile>(*TensorFile::parse(bytes, "q")));
    benchmark::DoNotOptimize(makeLife(learned.registry, c, 0, false));
  }
}
BENCHMARK(loadQ)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace surefoot
