// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot bench`: how fast this machine learns. Medians of five runs, CPU time of the learning threads.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/process/interrupt.h"
#include "core/basics/typed_json.h"
#include "core/experiment/experiment.h"

namespace surefoot {

namespace {

constexpr int kRuns = 5;

struct Case {
  const char* name;
  Names names;
  std::vector<Assignment> assignments;
  std::int64_t steps;  // steps of a run
  const char* limit;   // a sentence on the known limits of such a loop
};

/// The limits were measured on a virtual machine with an AMD EPYC processor, 2 cores.
std::vector<Case> cases() {
  return {{"pendulum, Sarsa",
           {.environment = "pendulum", .agent = "sarsa", .features = "tile-coder", .policy = "epsilon-greedy"},
           {},
           1'000'000,
           "3.3 M: Box2D's share (245 ns) and a learner of 50 ns"},
          {"pendulum, Sarsa_2Q",
           {.environment = "pendulum", .agent = "sarsa-2q", .features = "tile-coder", .policy = "epsilon-greedy"},
           {},
           600'000,
           ""},
          {"mountain car, λ 0.5",
           {.environment = "mountain-car", .agent = "sarsa", .features = "tile-coder", .policy = "greedy"},
           {{"agent.trace_decay", "0.5"}, {"agent.discount", "1"}},
           2'000'000,
           ""},
          {"mountain car, λ 0.9",
           {.environment = "mountain-car", .agent = "sarsa", .features = "tile-coder", .policy = "greedy"},
           {{"agent.trace_decay", "0.9"}, {"agent.discount", "1"}},
           2'000'000,
           "8.1 M: equations for a world and a lazy trace"},
          {"mountain car, λ 0.98",
           {.environment = "mountain-car", .agent = "sarsa", .features = "tile-coder", .policy = "greedy"},
           {{"agent.trace_decay", "0.98"}, {"agent.discount", "1"}},
           2'000'000,
           ""},
          {"cliff, table, λ 0",
           {.environment = "cliff", .agent = "sarsa", .features = "table", .policy = "epsilon-greedy"},
           {{"agent.trace_decay", "0"}},
           3'000'000,
           ""}};
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Steps per CPU-second of one case; 0 if it was interrupted.
Result<double> measure(const Registry& registry, const Case& which, const std::atomic<bool>& interrupted) {
  auto c = configure(registry, which.names, which.assignments);
  if (!c) return c.error();
  std::vector<double> speeds;
  for (int run = 0; run < kRuns && !interrupted; ++run) {
    c->seed = static_cast<std::uint64_t>(run + 1);
    RunOptions options{};
    options.interrupted = &interrupted;
    options.make = [&](int) { return makeLife(registry, *c, 0, false, which.steps); };
    const auto lives = runLives(registry, *c, options);
    if (!lives) return lives.error();
    if (!lives->empty()) speeds.push_back(static_cast<double>(lives->front().steps) / lives->front().cpuSeconds);
  }
  return speeds.empty() || interrupted ? 0.0 : median(speeds);
}

/// How much more two threads do than one. Two lives run one after the other, at once, and one after the other again, so
/// that a change of the machine's speed does not count. Measured in CPU time, which other programs do not change: the
/// loss of two threads to each other (memory, locks) shows in the CPU time of their lives.
Result<double> gainOfTwoThreads(const Registry& registry, const std::atomic<bool>& interrupted) {
  auto c = configure(registry, {}, {});
  if (!c) return c.error();
  c->lives = 2;
  c->minutes = 60.0;
  std::vector<double> gains;
  for (int run = 0; run < kRuns && !interrupted; ++run) {
    double oneByOne = 0, atOnce = 0;
    for (const int jobs : {1, 2, 1}) {
      RunOptions options{};
      options.jobs = jobs;
      options.interrupted = &interrupted;
      const auto lives = runLives(registry, *c, options);
      if (!lives) return lives.error();
      for (const LifeResult& life : *lives) (jobs == 1 ? oneByOne : atOnce) += life.cpuSeconds;
    }
    gains.push_back(oneByOne / atOnce);  // 2 · (half of the lives that were lived one by one) / those at once
  }
  return gains.empty() || interrupted ? 0.0 : median(gains);
}

}  // namespace

int benchCommand(const Registry& registry, const BenchRequest& request) {
  const std::atomic<bool>& interrupted = watchForInterrupt();
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  std::string text = "learning steps per CPU-second, median of 5\n";
  for (const Case& which : cases()) {
    const auto speed = measure(registry, which, interrupted);
    if (!speed) return fail(speed.error());
    json[which.name] = *speed;
    const std::string limit = *which.limit ? fmt::format("   limit {}", which.limit) : "";
    text += fmt::format("  {:<22}{:>7.2f} M{}\n", which.name, *speed * 1e-6, limit);
  }
  const auto gain = gainOfTwoThreads(registry, interrupted);
  if (!gain) return fail(gain.error());
  if (interrupted) return fail({"interrupted; a speed needs all its runs.", ErrorKind::Interrupted});
  json["two threads against one"] = *gain;
  text += fmt::format("  {:<22}{:>7.2f} ×\n", "two threads", *gain);
  return print(request.json ? jsonText(nlohmann::ordered_json{{"steps_per_cpu_second", json}}, 2) + "\n" : text);
}

}  // namespace surefoot
