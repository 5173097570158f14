// SPDX-License-Identifier: GPL-3.0-or-later
// What a step costs as the problem grows: a random walk in so many dimensions with so many actions, 16 tilings.
#include <fmt/format.h>

#include "core/register/register.h"
#include "core/registry.h"
#include "tests/bench/living.h"

namespace surefoot {

namespace {

/// Every action shifts every variable a little; an episode takes 100 steps.
class Meadow final : public Environment {
 public:
  Meadow(int dimensions, int actions) : x_(static_cast<std::size_t>(dimensions)) {
    for (int d = 0; d < dimensions; ++d)
      task_.state.push_back({.key = fmt::format("x{}", d), .span = 1.0, .resolution = 4.0});
    for (int a = 0; a < actions; ++a) task_.actions.push_back(a);
    task_.rewardTerms = {"time"};
  }
  void declare(Fields&) override {}
  const Task& task() const override { return task_; }
  void reset(Random& random) override {
    steps_ = 0;
    for (double& x : x_) x = random.uniform();
  }
  Outcome step(Action action) override {
    for (std::size_t d = 0; d < x_.size(); ++d) {
      const int way = (action >> d) & 1 ? 1 : -1;
      x_[d] += 0.03 * way;
      if (x_[d] < 0 || x_[d] > 1) x_[d] = 0.5;
    }
    return {.reward = -1, .ending = ++steps_ < 100 ? Ending::None : Ending::Terminal, .terms = {-1.0}};
  }
  std::span<const double> state() const override { return x_; }
  std::vector<double> pose() const override { return x_; }
  void draw(std::span<const double>, Scene&) const override {}
  std::vector<ReadOut> readOuts(std::span<const double>) const override { return {}; }

 private:
  Task task_;
  std::vector<double> x_;
  int steps_ = 0;
};

void meadow(benchmark::State& state, int dimensions, int actions) {
  Registry registry;
  registerCore(registry);
  registry.environments.push_back({{"meadow", "", ""}, [=] { return std::make_unique<Meadow>(dimensions, actions); }});
  live(state, registry,
       {.environment = "meadow", .agent = "sarsa", .features = "tile-coder", .policy = "epsilon-greedy"}, {});
}
void actions(benchmark::State& state) {
  meadow(state, 2, static_cast<int>(state.range(0)));
}
BENCHMARK(actions)->Arg(2)->Arg(3)->Arg(5)->Arg(9)->Arg(27)->Arg(81)->Arg(343);

void dimensions(benchmark::State& state) {
  meadow(state, static_cast<int>(state.range(0)), 3);
}
BENCHMARK(dimensions)->DenseRange(1, 6);

}  // namespace
}  // namespace surefoot
