// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/robustness/robustness_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/basics/typed_json.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

using OrderedJson = nlohmann::ordered_json;

double secondsOf(const RobustnessPlan& plan, std::int64_t steps) {
  return static_cast<double>(steps) * *plan.stepTime;
}

/// Calls for every cell: functions, then models, then pushes.
template <class Call>
void forEachCell(const Robustness& r, Call call) {
  for (std::size_t f = 0; f < r.plan.functions.size(); ++f)
    for (std::size_t m = 0; m < r.plan.models.size(); ++m)
      for (std::size_t p = 0; p < r.plan.pushes.size(); ++p) call(f, m, p, r.at(f, m, p));
}

OrderedJson cellAsJson(const Robustness& r, std::size_t f, std::size_t m, std::size_t p) {
  const Tally& tally = r.at(f, m, p);
  OrderedJson cell = {
      {"file", r.plan.functions[f]}, {"model", m}, {"push", r.plan.pushes[p]}, {"trials", tally.trials}};
  const auto add = [&](const char* count, std::int64_t number, const char* share, const Interval& interval) {
    cell[count] = number;
    cell[share] = interval.value;
    cell[share + std::string("_low")] = interval.low;
    cell[share + std::string("_high")] = interval.high;
  };
  add("falls", tally.falls, "fallen", tally.fallen());
  add("successes", tally.successes, "succeeded", tally.succeeded());
  cell["flew_apart"] = tally.flewApart;
  if (r.plan.functions.size() > 1) cell["differs"] = r.differ(m, p);
  return cell;
}

/// How many letters a text has: bytes that go on with a letter do not count (UTF-8).
std::size_t lettersOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

/// A table of counts. Two functions stand beside each other: "12|45*".
std::string countsTable(const Robustness& r, const char* what, std::int64_t Tally::*count, bool marks) {
  const RobustnessPlan& plan = r.plan;
  std::vector<std::vector<std::string>> columns(plan.pushes.size() + 1);
  columns[0].push_back(fmt::format("{} by push [N s]", what));
  for (const TriedModel& model : plan.models) columns[0].push_back(model.title);
  for (std::size_t p = 0; p < plan.pushes.size(); ++p) {
    columns[p + 1].push_back(fmt::format("{:.6g}", plan.pushes[p]));
    for (std::size_t m = 0; m < plan.models.size(); ++m) {
      std::string cell = fmt::format("{}", r.at(0, m, p).*count);
      if (plan.functions.size() > 1)
        cell += fmt::format("|{}{}", r.at(1, m, p).*count, !marks ? "" : r.differ(m, p) ? "*" : " ");
      columns[p + 1].push_back(std::move(cell));
    }
  }
  std::string text;
  for (std::size_t row = 0; row <= plan.models.size(); ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      std::size_t width = 0;
      for (const std::string& cell : columns[c]) width = std::max(width, lettersOf(cell));
      const std::string blanks(width - lettersOf(columns[c][row]), ' ');
      text += c == 0 ? columns[c][row] + blanks : "  " + blanks + columns[c][row];
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::string robustnessAsJson(const Robustness& r) {
  const RobustnessPlan& plan = r.plan;
  OrderedJson json = {{"files", plan.functions},
                      {"environment", plan.environment},
                      {"policy", plan.policy},
                      {"starts", plan.starts},
                      {"seed", plan.seed}};
  if (plan.stepTime) {
    json["seconds"] = secondsOf(plan, plan.after);
    json["push_at"] = {secondsOf(plan, plan.earliest), secondsOf(plan, plan.latest)};
  }
  json["pushes"] = plan.pushes;
  json["models"] = OrderedJson::array();
  for (const TriedModel& model : plan.models) {
    OrderedJson values = OrderedJson::object();
    for (const auto& [key, value] : model.values) values[key] = value;
    json["models"].push_back({{"title", model.title}, {"scenario", model.scenario}, {"values", values}});
  }
  json["cells"] = OrderedJson::array();
  forEachCell(r, [&](std::size_t f, std::size_t m, std::size_t p, const Tally&) {
    json["cells"].push_back(cellAsJson(r, f, m, p));
  });
  return jsonText(json) + "\n";
}

std::string robustnessAsCsv(const Robustness& r) {
  const bool two = r.plan.functions.size() > 1;
  std::string text = "file,scenario";
  for (const std::string& key : r.plan.keys) text += "," + csvCell(key);
  text +=
      ",push,trials,falls,fallen,fallen_low,fallen_high,successes,succeeded,succeeded_low,succeeded_high,flew_apart";
  text += two ? ",differs\n" : "\n";
  forEachCell(r, [&](std::size_t f, std::size_t m, std::size_t p, const Tally& tally) {
    const TriedModel& model = r.plan.models[m];
    text += csvCell(r.plan.functions[f]) + "," + csvCell(model.scenario);
    for (const std::string& setting : model.settings) text += "," + setting;
    const Interval fallen = tally.fallen(), succeeded = tally.succeeded();
    text += fmt::format(",{},{},{},{:.6g},{:.6g},{:.6g},{},{:.6g},{:.6g},{:.6g},{}", r.plan.pushes[p], tally.trials,
                        tally.falls, fallen.value, fallen.low, fallen.high, tally.successes, succeeded.value,
                        succeeded.low, succeeded.high, tally.flewApart);
    text += two ? fmt::format(",{}\n", r.differ(m, p) ? 1 : 0) : "\n";
  });
  return text;
}

std::string robustnessAsTable(const Robustness& r) {
  std::string text;
  for (std::size_t f = 0; f < r.plan.functions.size(); ++f)
    text += r.plan.functions.size() > 1 ? fmt::format("{}: {}\n", f == 0 ? "left" : "right", r.plan.functions[f]) : "";
  text += robustnessConditions(r.plan) + "\n\n";
  if (r.plan.canFall) text += countsTable(r, "falls", &Tally::falls, true);
  if (r.plan.canSucceed)
    text += (r.plan.canFall ? "\n" : "") + countsTable(r, "successes", &Tally::successes, !r.plan.canFall);
  std::int64_t apart = 0;
  bool differs = false;
  forEachCell(r, [&](std::size_t, std::size_t m, std::size_t p, const Tally& tally) {
    apart += tally.flewApart;
    differs |= r.differ(m, p);
  });
  if (differs) text += "* the two differ: their 95 % intervals (Wilson) have nothing in common\n";
  if (apart > 0) text += fmt::format("{} trials ended because the robot flew apart\n", apart);
  return text;
}

std::string robustnessConditions(const RobustnessPlan& plan) {
  std::string text = fmt::format("{} starts a cell", countText(static_cast<double>(plan.starts)));
  if (plan.stepTime) {
    const double from = secondsOf(plan, plan.earliest), to = secondsOf(plan, plan.latest);
    text += from == to ? fmt::format(", pushed at {:.6g} s", from)
                       : fmt::format(", pushed between {:.6g} and {:.6g} s", from, to);
    text += fmt::format(", followed for {:.6g} s", secondsOf(plan, plan.after));
  }
  return text + fmt::format(", policy {}, seed {}", plan.policy, plan.seed);
}

std::string cellText(const RobustnessPlan& plan, const Tally& tally) {
  const Interval share = plan.canFall ? tally.fallen() : tally.succeeded();
  const auto count = [](std::int64_t number) { return countText(static_cast<double>(number)); };
  return fmt::format("{} of {} {}, {:.0f} % (95 %: {:.0f} … {:.0f} %)",
                     count(plan.canFall ? tally.falls : tally.successes), count(tally.trials),
                     plan.canFall ? "fell" : "succeeded", 100 * share.value, 100 * share.low, 100 * share.high);
}

}  // namespace surefoot
