// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reports/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/basics/typed_json.h"
#include "core/basics/version.h"
#include "core/experiment/configuration_json.h"
#include "core/life/life_measures.h"
#include "core/saved/q_file.h"
#include "core/statistics/statistics.h"
#include "core/store/store.h"

namespace surefoot {

using OrderedJson = nlohmann::ordered_json;

namespace {

/// A mean, or null where there was nothing to average.
OrderedJson mean(std::int64_t sum, std::int64_t count) {
  return count > 0 ? OrderedJson(static_cast<double>(sum) / static_cast<double>(count)) : OrderedJson(nullptr);
}

OrderedJson finite(double value) {
  return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}

/// The memory use of every table.
OrderedJson memoryAsJson(const std::vector<MemoryUse>& tables) {
  OrderedJson list = OrderedJson::array();
  for (const MemoryUse& use : tables) {
    OrderedJson table = {{"features", use.slots}};
    if (use.occupied) table["occupied"] = *use.occupied;
    if (use.failedLookUps) table["failed_look_ups"] = *use.failedLookUps;
    list.push_back(std::move(table));
  }
  return list;
}

OrderedJson orNull(const std::optional<double>& value) {
  return value ? OrderedJson(*value) : OrderedJson(nullptr);
}

OrderedJson ruleAsJson(const std::optional<RuleOfThumb>& rule) {
  if (!rule) return nullptr;
  return {{"threshold", rule->threshold},       {"transitions", rule->transitions},
          {"discount", rule->discount},         {"reward", rule->reward},
          {"time_reward", rule->timeReward},    {"lower_limit", orNull(rule->lower)},
          {"upper_limit", orNull(rule->upper)}, {"pre_learned", rule->preLearned}};
}

/// Every greedy test, column by column.
OrderedJson testsAsJson(const LifeResult& r) {
  OrderedJson columns;
  for (const GreedyTest& t : r.greedyTests) {
    columns["episode"].push_back(t.episode);
    if (r.steps > 0 && std::isfinite(r.simulatedSeconds))
      columns["minutes"].push_back(r.simulatedSeconds / 60.0 * static_cast<double>(t.lifeSteps) /
                                   static_cast<double>(r.steps));
    columns["reward"].push_back(t.reward);
    columns["falls"].push_back(t.falls);
    for (std::size_t m = 0; m < r.taskMeasures.size(); ++m) columns[r.taskMeasures[m].key].push_back(t.measures[m]);
  }
  return columns;
}

OrderedJson binAsJson(const Calibration::Bin& bin) {
  OrderedJson json = {{"actions", bin.count}, {"said", bin.said}, {"fell", bin.fell}};
  if (std::isfinite(bin.low)) json["from"] = bin.low;
  if (std::isfinite(bin.high)) json["to"] = bin.high;
  return json;
}

/// What ρ said of the last actions, and what came.
OrderedJson calibrationAsJson(const Calibration::Report& report) {
  OrderedJson json = binAsJson(report.all);
  json["half_width"] = report.halfWidth;
  for (const Calibration::Bin& bin : report.bins) json["bins"].push_back(binAsJson(bin));
  return json;
}

/// "213.5 ± 8.9": mean and 95 % half-width (Student t over the lives); just the value for one life.
std::string meanText(const std::vector<double>& values, int decimals) {
  const auto interval = meanInterval(values);
  if (!interval) return fmt::format("{:.{}f}", values[0], decimals);
  return fmt::format("{:.{}f} ± {:.{}f}", interval->value, decimals, interval->high - interval->value, decimals);
}

}  // namespace

std::string resultAsJson(const Configuration& configuration, const std::vector<LifeResult>& lives) {
  OrderedJson list = OrderedJson::array();
  for (const LifeResult& r : lives) {
    OrderedJson life = {
        {"life", r.life},
        {"episodes", r.totals.episodes},
        {"falls", r.totals.falls},
        {"successes", r.totals.successes},
        {"steps", r.steps},
        {"simulated_minutes", finite(r.simulatedSeconds / 60.0)},
        {"average_reward", r.totals.episodes > 0 ? finite(r.averageReward) : OrderedJson(nullptr)},
        {"transitions_success", mean(r.totals.successSteps, r.totals.successes)},
        {"transitions_failure", mean(r.totals.failureSteps, r.totals.failures)},
        {"states_outside", r.statesOutside},
        {"tables", memoryAsJson(r.memory)},
        {"rule_of_thumb", ruleAsJson(r.ruleOfThumb)},
        {"complete", r.complete},
        {"steps_per_second", finite(r.cpuSeconds > 0 ? static_cast<double>(r.steps) / r.cpuSeconds : std::nan(""))},
        {"hash", fmt::format("{:016x}", r.hash)}};
    if (isMovedByProgram(configuration)) life["same_bits"] = "machine";
    for (const NamedValue& m : measuresOf(r)) life[m.name] = finite(m.value);
    if (r.calibration) life["risk_calibration"] = calibrationAsJson(*r.calibration);
    if (!r.greedyTests.empty()) life["test_seconds"] = finite(r.testSeconds);
    if (!r.greedyTests.empty()) life["greedy_tests"] = testsAsJson(r);
    if (r.flewApart > 0) life["flew_apart"] = r.flewApart;
    if (!r.divergence.empty()) life["diverged"] = r.divergence;
    for (const Change& change : r.changes)
      life["changes"].push_back(
          {{"step", change.step}, {"key", change.key}, {"before", change.before}, {"after", change.after}});
    list.push_back(std::move(life));
  }
  OrderedJson result = {
      {"version", kVersion}, {"configuration", configurationAsJson(configuration)}, {"seed", configuration.seed}};
  if (!configuration.beganWith.is_null()) result["began_with"] = configuration.beganWith;
  if (const auto& teacher = configuration.teacher) {
    const std::string name = std::filesystem::path(teacher->name).filename().string();
    result["guardian"] = {{"file", name}, {"content", contentOf(*teacher)}};
  }
  result["lives"] = list;
  return jsonText(result, 2) + "\n";
}

std::string logHeads(const std::vector<TaskMeasure>& measures, bool rewinds) {
  std::string heads = "life,episode,transitions,reward,falls,ending,average_reward,steps,simulated_minutes";
  for (const TaskMeasure& m : measures) heads += "," + std::string(m.key);
  return heads + (rewinds ? ",rewinds\n" : "\n");
}

std::string logRows(int life, const std::vector<EpisodeRow>& rows, const std::vector<TaskMeasure>& measures,
                    std::optional<double> stepTime, bool rewinds) {
  fmt::memory_buffer out;
  const auto to = std::back_inserter(out);
  for (const EpisodeRow& row : rows) {
    fmt::format_to(to, "{},{},{},{},{},{},{},{},", life, row.episode, row.steps, row.reward, row.falls,
                   endingName(endingCode(row)), row.averageReward, row.lifeSteps);
    if (stepTime) fmt::format_to(to, "{:.9g}", static_cast<double>(row.lifeSteps) * *stepTime / 60.0);
    for (std::size_t m = 0; m < measures.size(); ++m) fmt::format_to(to, ",{:.9g}", row.measures[m]);
    if (rewinds) fmt::format_to(to, ",{}", row.rewinds);
    fmt::format_to(to, "\n");
  }
  return fmt::to_string(out);
}

std::string logAsCsv(const std::vector<LifeResult>& lives, std::optional<double> stepTime) {
  const bool rewinds = std::any_of(lives.begin(), lives.end(), [](const LifeResult& r) { return r.mayRewind; });
  std::string text = logHeads(lives.empty() ? std::vector<TaskMeasure>{} : lives[0].taskMeasures, rewinds);
  for (const LifeResult& r : lives) text += logRows(r.life, r.rows, r.taskMeasures, stepTime, rewinds);
  return text;
}

std::string resultAsTable(const Configuration& c, const std::vector<LifeResult>& lives) {
  if (lives.empty()) return "No life was started.\n";
  const auto column = [&](auto value, int decimals) {
    std::vector<double> values;
    for (const LifeResult& r : lives)
      if (const double v = value(r); std::isfinite(v)) values.push_back(v);
    return values.empty() ? std::string("none") : meanText(values, decimals);
  };
  const auto ratio = [](std::int64_t sum, std::int64_t count) {
    return count > 0 ? static_cast<double>(sum) / static_cast<double>(count) : std::nan("");
  };
  const std::string variant = c.names.scenario.empty() ? c.names.preset : c.names.scenario;
  const std::string head =
      fmt::format("{}{}{}, {}, {}, {}, seed {}: {} {}\n", c.names.environment, variant.empty() ? "" : " ", variant,
                  c.names.agent, c.names.features, c.names.policy, c.seed, lives.size(),
                  lives.size() == 1 ? "life" : "lives, mean ± 95 % interval");
  std::vector<std::pair<std::string, std::string>> rows;
  const auto row = [&rows](const std::string& name, std::string value) { rows.emplace_back(name, std::move(value)); };
  row("falls", column([](const LifeResult& r) { return static_cast<double>(r.totals.falls); }, 1));
  row("episodes", column([](const LifeResult& r) { return static_cast<double>(r.totals.episodes); }, 1));
  row("average reward, last 80",
      column([](const LifeResult& r) { return r.totals.episodes > 0 ? r.averageReward : std::nan(""); }, 1));
  row("transitions of a success",
      column([&](const LifeResult& r) { return ratio(r.totals.successSteps, r.totals.successes); }, 1));
  row("transitions of a failure",
      column([&](const LifeResult& r) { return ratio(r.totals.failureSteps, r.totals.failures); }, 1));
  const bool tested = lives[0].testEvery > 0;
  for (const LifeMeasure& measure : lifeMeasures(lives[0].taskMeasures))
    if (tested || !measure.ofGreedyTests)
      row(measure.titleWithUnit(), column(
                                       [&measure](const LifeResult& r) {
                                         for (const NamedValue& m : measuresOf(r))
                                           if (m.name == measure.name) return m.value;
                                         return std::nan("");
                                       },
                                       1));
  const auto has = [&](auto what) { return std::any_of(lives.begin(), lives.end(), what); };
  if (has([](const LifeResult& r) { return r.guarded > 0; }))
    row("guardian acted, %", column([](const LifeResult& r) { return 100 * r.guarded; }, 1));
  if (has([](const LifeResult& r) { return r.calibration && r.calibration->all.count > 0; })) {
    const auto percent = [&](auto part) {
      return column([&](const LifeResult& r) { return r.calibration ? 100 * part(r.calibration->all) : std::nan(""); },
                    1);
    };
    row("risk said at the end, %", percent([](const Calibration::Bin& b) { return b.said; }));
    row("fell where it was said, %", percent([](const Calibration::Bin& b) { return b.fell; }));
  }
  if (has([](const LifeResult& r) { return r.priceOfFall.has_value(); }))
    row("price of a fall", column([](const LifeResult& r) { return r.priceOfFall.value_or(std::nan("")); }, 1));
  if (has([](const LifeResult& r) { return r.mayRewind; }))
    row("falls taken back", column([](const LifeResult& r) { return static_cast<double>(r.totals.rewinds); }, 1));
  if (has([](const LifeResult& r) { return r.flewApart > 0; }))
    row("episodes that flew apart", column([](const LifeResult& r) { return static_cast<double>(r.flewApart); }, 1));
  row("simulated minutes", column([](const LifeResult& r) { return r.simulatedSeconds / 60.0; }, 2));
  row("steps per CPU-second",
      column([](const LifeResult& r) { return static_cast<double>(r.steps) / r.cpuSeconds; }, 0));
  if (lives.size() == 1)
    row(isMovedByProgram(c) ? "hash, on this machine" : "hash", fmt::format("{:016x}", lives[0].hash));

  std::size_t widest = 26;
  for (const auto& [name, value] : rows) widest = std::max(widest, name.size());
  std::string text = head;
  for (const auto& [name, value] : rows) text += fmt::format("  {:<{}}  {}\n", name, widest, value);
  return text;
}

}  // namespace surefoot
