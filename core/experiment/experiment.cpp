// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/experiment.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/basics/cpu_time.h"
#include "core/experiment/meter.h"
#include "core/experiment/work_pool.h"
#include "core/life/life_measures.h"

namespace surefoot {

LifeResult summarise(const Life& life, int index, double cpuSeconds) {
  LifeResult r;
  r.life = index;
  r.totals = life.log().totals();
  r.steps = life.steps();
  r.simulatedSeconds = life.simulatedSeconds();
  r.averageReward = life.log().averageReward();
  r.statesOutside = life.agent().statesOutside();
  r.flewApart = life.environment().cutOffs().all;
  r.testSeconds = life.testSeconds();
  r.cpuSeconds = std::max(0.0, cpuSeconds - r.testSeconds);
  r.hash = life.hash();
  if (life.diverged()) r.divergence = life.divergence();
  r.unanswered = life.unanswered();
  r.complete = life.finished() && !life.diverged() && r.unanswered.empty();
  r.changes = life.changes();
  r.changesLeftOut = life.changesLeftOut();
  r.memory = life.agent().values().memoryUse();
  r.ruleOfThumb = ruleOfThumbOf(life);
  r.taskMeasures = life.environment().task().measures;
  r.testEvery = life.environment().task().testEvery;
  r.greedyTests = life.greedyTests();
  r.rows = life.log().rows();
  const auto share = [&](std::int64_t steps) { return static_cast<double>(steps) / static_cast<double>(r.steps); };
  if (r.steps > 0) r.exploring = share(life.agent().explored()), r.guarded = share(life.agent().guarded());
  if (const Calibration* calibration = life.agent().calibration()) r.calibration = calibration->report();
  r.priceOfFall = life.agent().priceOfFall();
  r.mayRewind = life.mayRewind();
  return r;
}

namespace {

double valueNamed(const std::vector<NamedValue>& values, std::string_view name) {
  const auto found = std::find_if(values.begin(), values.end(), [&](const NamedValue& v) { return v.name == name; });
  return found == values.end() ? std::nan("") : found->value;
}

}  // namespace

std::vector<NamedValue> measuresOf(const LifeResult& r) {
  std::vector<NamedValue> all;
  const double hours = r.simulatedSeconds / 3600.0;
  if (r.steps > 0) all.push_back({"exploring", r.exploring});
  if (r.guarded > 0) all.push_back({"guarded", r.guarded});
  if (r.calibration && r.calibration->all.count > 0) {
    all.push_back({"risk_said", r.calibration->all.said});
    all.push_back({"risk_fell", r.calibration->all.fell});
    all.push_back({"risk_error", r.calibration->error()});
  }
  if (r.priceOfFall) all.push_back({"price_of_fall", *r.priceOfFall});
  if (r.mayRewind) all.push_back({"rewinds", static_cast<double>(r.totals.rewinds)});
  if (r.final) all.push_back({"final_falls", r.final->falls}), all.push_back({"final_reward", r.final->reward});
  if (r.taskMeasures.empty()) return all;
  for (std::size_t m = 0; m < r.taskMeasures.size(); ++m) {
    const double value = valueOfALife(r.taskMeasures[m], r.totals.measures[m], r.totals.episodes);
    if (std::isfinite(value)) all.push_back({r.taskMeasures[m].key, value});
  }
  if (hours > 0) all.push_back({"falls_per_hour", static_cast<double>(r.totals.falls) / hours});
  if (r.greedyTests.empty()) return all;

  constexpr std::size_t kLast = 10;
  const std::span<const GreedyTest> last = std::span(r.greedyTests).last(std::min(kLast, r.greedyTests.size()));
  const auto mean = [&](const auto& of) {
    double sum = 0.0;
    for (const GreedyTest& t : last) sum += of(t);
    return sum / static_cast<double>(last.size());
  };
  for (std::size_t m = 0; m < r.taskMeasures.size(); ++m)
    all.push_back({"greedy_" + r.taskMeasures[m].key, mean([m](const GreedyTest& t) { return t.measures[m]; })});
  all.push_back({"greedy_reward", mean([](const GreedyTest& t) { return t.reward; })});
  all.push_back({"greedy_falls", mean([](const GreedyTest& t) { return static_cast<double>(t.falls); })});
  if (!r.final)
    for (const char* what : {"reward", "falls"})
      all.push_back({std::string("final_") + what, valueNamed(all, std::string("greedy_") + what)});
  if (const GreedyTest* walk = firstWalk(r.greedyTests, r.taskMeasures); walk && hours > 0)
    all.push_back({"walks_after", 60.0 * hours * static_cast<double>(walk->lifeSteps) / static_cast<double>(r.steps)});
  return all;
}

namespace {

/// The first multiple of `every` behind `steps`.
std::int64_t after(std::int64_t steps, std::int64_t every) {
  return every == kNever ? kNever : (steps / every + 1) * every;
}

/// A whole life, with its visits.
void liveAndVisit(Life& life, int index, const RunOptions& options, const WorkPool& pool, Meter& meter) {
  constexpr std::int64_t kRowsEvery = 1 << 16;  // steps
  const bool visits = options.visitEvery != kNever;
  if (visits) life.keepInputs();
  std::int64_t visit = after(life.steps(), options.visitEvery);
  while (!life.finished() && !pool.stopping()) {
    live(life, options.takeRows ? std::min(visit, after(life.steps(), kRowsEvery)) : visit, pool, meter);
    if (options.takeRows) options.takeRows(index, life.takeRows());
    if (life.steps() < visit) continue;
    if (options.visit && !life.finished()) options.visit(life);
    visit = after(life.steps(), options.visitEvery);
  }
  if (options.takeRows) options.takeRows(index, life.takeRows());
  if (options.visit) options.visit(life);
}

}  // namespace

Result<std::vector<LifeResult>> runLives(const Registry& registry, const Configuration& configuration,
                                         const RunOptions& options) {
  std::vector<std::optional<LifeResult>> results(static_cast<std::size_t>(configuration.lives));
  std::vector<Meter> meters(results.size());
  std::atomic<bool> anything = false;  // has been lived
  WorkPool pool(options.jobs, options.interrupted);
  const auto work = [&](std::int64_t i) -> Status {
    const auto index = static_cast<int>(i);
    const double start = threadCpuSeconds();
    auto life = options.make ? options.make(index) : makeLife(registry, configuration, index, options.keepRows);
    if (!life) return life.error();
    Meter& meter = meters[static_cast<std::size_t>(i)];
    const std::int64_t before = (*life)->steps();
    (*life)->begin();
    liveAndVisit(**life, index, options, pool, meter);
    if ((*life)->unanswered().empty() || (*life)->steps() > before) anything = true;
    meter.done = true;
    results[static_cast<std::size_t>(i)] = summarise(**life, index, threadCpuSeconds() - start);
    return Done{};
  };
  const auto tick = [&] { options.progress(sum(meters)); };
  if (const Status s = pool.run(configuration.lives, work, options.progress ? tick : std::function<void()>{}); !s)
    return s.error();
  std::vector<LifeResult> lives;
  for (auto& result : results)
    if (result && !anything && !pool.stopping()) return Error{result->unanswered, ErrorKind::Unanswered};
  for (auto& result : results)
    if (result) lives.push_back(std::move(*result));
  return lives;
}

}  // namespace surefoot
