// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reports/list_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/manual/known.h"
#include "core/basics/typed_json.h"
#include "core/formulas.h"
#include "core/glossary.h"
#include "core/recipes/figure.h"

namespace surefoot {

using OrderedJson = nlohmann::ordered_json;

namespace {

OrderedJson describe(const Parameters::Entry& entry) {
  const Parameter& p = entry.parameter;
  OrderedJson json = {{"name", p.key}, {"title", p.title}, {"symbol", p.symbol}, {"unit", p.unit}};
  if (p.kind == Kind::Choice) {
    json["range"] = p.choices;
    json["default"] = formatValue(p, p.fallback);
  } else {
    json["range"] = {p.low, p.high};
    json["default"] = p.fallback;
  }
  json["applies"] = whenName(p.when);
  json["origin"] = p.origin;
  json["help"] = p.help;
  json["formula"] = formulaOf(p);
  return json;
}

template <class Entry>
OrderedJson describe(const std::vector<Entry>& entries) {
  OrderedJson list = OrderedJson::array();
  for (const Entry& entry : entries) {
    OrderedJson json = {{"name", entry.name}, {"title", entry.title}, {"help", entry.help}};
    if (const Word* word = wordOf(entry.name)) {
      json["formula"] = word->formula;
      json["meaning"] = word->text;
      json["source"] = word->source;
    }
    if constexpr (std::is_same_v<Entry, AssignmentEntry>) {
      json["environment"] = entry.environment;
      json["values"] = OrderedJson::object();
      for (const auto& [key, value] : entry.values) json["values"][key] = value;
    }
    list.push_back(std::move(json));
  }
  return list;
}

template <class Entry>
std::string table(const char* heading, const std::vector<Entry>& entries) {
  std::string text = fmt::format("{}\n", heading);
  for (const Entry& entry : entries) {
    text += fmt::format("  {:<18}{}\n", entry.name, entry.help.empty() ? entry.title : entry.help);
    const Word* word = wordOf(entry.name);
    if (word && !word->formula.empty()) text += fmt::format("{:20}{}\n", "", word->formula);
    if (word) text += fmt::format("{:20}{} ({})\n", "", word->text, word->source);
  }
  return text + "\n";
}

std::string table(const Parameters& parameters) {
  std::string text = "parameters (--set KEY=VALUE)\n";
  for (const auto& entry : parameters.all()) {
    const Parameter& p = entry.parameter;
    std::string name = p.symbol.empty() ? p.key : fmt::format("{} ({})", p.key, p.symbol);
    text += fmt::format("  {:<32} default {}{}, {}, applies {}\n      {} Default: {}.\n      {}\n", name,
                        formatValue(p, p.fallback), p.unit.empty() ? "" : " " + p.unit, rangeText(p), whenName(p.when),
                        p.help, p.origin, formulaOf(p));
  }
  return text;
}

std::string figureTable() {
  std::string text = "figures of plans (kind = NAME)\n";
  for (const FigureKind& kind : figureKinds()) text += fmt::format("  {:<22}{}\n", kind.name, kind.shows);
  return text + "\n";
}

OrderedJson describeFigures() {
  OrderedJson list = OrderedJson::array();
  for (const FigureKind& kind : figureKinds()) list.push_back({{"name", kind.name}, {"shows", kind.shows}});
  return list;
}

std::string robotTable(const Registry& registry) {
  const auto robots = shelvedRobots(registry);
  return robots.empty() ? "" : table("robots from files (surefoot check NAME tells more of one)", robots);
}

OrderedJson describeRobots(const Registry& registry) {
  OrderedJson list = OrderedJson::array();
  for (const EnvironmentEntry& robot : shelvedRobots(registry))
    list.push_back({{"name", robot.name}, {"title", robot.title}, {"help", robot.help}});
  return list;
}

}  // namespace

std::string listAsJson(const Registry& r) {
  OrderedJson list = OrderedJson::array();
  const Parameters parameters = everyParameter(r);
  for (const auto& entry : parameters.all()) list.push_back(describe(entry));
  const OrderedJson json = {{"environments", describe(r.environments)},
                            {"robots", describeRobots(r)},
                            {"features", describe(r.features)},
                            {"agents", describe(r.agents)},
                            {"policies", describe(r.policies)},
                            {"presets", describe(r.presets)},
                            {"scenarios", describe(r.scenarios)},
                            {"figures", describeFigures()},
                            {"parameters", list}};
  return jsonText(json, 2) + "\n";
}

std::string listAsTable(const Registry& r) {
  return table("environments", r.environments) + robotTable(r) + table("features", r.features) +
         table("agents", r.agents) + table("policies", r.policies) + table("presets", r.presets) +
         table("scenarios", r.scenarios) + figureTable() + table(everyParameter(r));
}

}  // namespace surefoot
