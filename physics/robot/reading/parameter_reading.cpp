// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/text/number_text.h"
#include "core/text/words.h"
#include "physics/robot/reading/sections.h"

namespace surefoot {

namespace {

using Where = RobotReader::Where;

/// A number that is known at once: of a parameter's own table.
double known(TomlReader& reader, RobotReader& in, std::string_view key, double otherwise) {
  const auto formula = in.maybe(reader, key, Where::Parameter);
  return formula ? (*formula)({}) : otherwise;
}

std::optional<std::pair<double, double>> knownPair(TomlReader& reader, RobotReader& in, std::string_view key) {
  const TomlNode* node = reader.find(key);
  if (!node) return std::nullopt;
  if (node->kind != TomlNode::Kind::List || node->list.size() != 2)
    return reader.complain(key, "it takes the lowest and the highest value, such as [0, 10]."), std::nullopt;
  const auto low = in.formula(node->list[0], key, Where::Parameter);
  const auto high = in.formula(node->list[1], key, Where::Parameter);
  if (!low || !high) return std::nullopt;
  const std::pair range{(*low)({}), (*high)({})};
  if (range.first < range.second) return range;
  reader.complain(key, fmt::format("the lowest, {}, must be below the highest, {}.", range.first, range.second));
  return std::nullopt;
}

std::string titleFrom(std::string key) {
  std::replace(key.begin(), key.end(), '_', ' ');
  if (!key.empty()) key[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(key[0])));
  return key;
}

void readParameter(const TomlNode& node, RobotReader& in) {
  constexpr std::pair<const char*, Group> kGroups[] = {{"model", Group::Model}, {"rewards", Group::Rewards}};
  TomlReader reader(node, in.complaints());
  Parameter p{.key = reader.neededText("key")};
  p.title = reader.text("title", titleFrom(p.key));
  p.label = reader.text("label");
  p.symbol = reader.text("symbol");
  p.unit = reader.text("unit");
  p.help = reader.text("help");
  p.origin = reader.text("origin");
  p.order = static_cast<int>(reader.whole("order", 1, 3, 1));
  p.group = in.choice(reader, "group", kGroups, Group::Model);
  // A program is told of its parameters when an episode begins.
  p.when = p.group == Group::Rewards && !in.spec().names.hasChild() ? When::Now : When::NextEpisode;
  if (reader.flag("whole")) p.kind = Kind::Integer;
  reader.need("value");
  reader.need("range");
  const double value = known(reader, in, "value", 0);
  const auto range = knownPair(reader, in, "range");
  if (range) std::tie(p.low, p.high) = *range;
  constexpr double kMostWhole = 2e9;
  if (p.kind == Kind::Integer && (p.low < -kMostWhole || p.high > kMostWhole)) {
    reader.complain("range", "whole numbers go to 2,000,000,000 at most.");
    p.low = 0, p.high = 1;
  }
  if (const auto slider = knownPair(reader, in, "slider")) {
    p.sliderLow = std::max(slider->first, p.low);
    p.sliderHigh = std::min(slider->second, p.high);
    if (p.sliderLow >= p.sliderHigh) reader.complain("slider", "it lies outside the range.");
  }
  reader.end();
  if (range && node.find("value") && !checkValue(p, value))
    reader.complain(
        "value", p.kind == Kind::Integer && value >= p.low && value <= p.high
                     ? fmt::format("{} is no whole number.", value)
                     : fmt::format("{} lies outside its range {} … {}.", value, boundText(p.low), boundText(p.high)));
  in.spec().parameters.push_back(std::move(p));
  in.spec().defaults.push_back(value);
}

}  // namespace

void readParameters(const TomlNode& root, RobotReader& in) {
  TomlReader reader(root, in.complaints());
  for (const TomlNode* node : reader.tables("parameter")) readParameter(*node, in);
}

void readConstants(const TomlNode& root, RobotReader& in) {
  const TomlNode* all = root.find("constants");
  int above = 0;
  for (const auto& [name, node] : all ? all->table : decltype(all->table){}) {
    in.setConstants(above++);
    in.spec().constants.push_back({name, in.formula(node, name, Where::Fixed).value_or(formulaOf(0))});
  }
  in.setConstants(above);
}

namespace {

void readSettingsOf(const std::string& name, const TomlNode& node, RobotReader& in, SettingsSpec& settings) {
  TomlReader reader(node, in.complaints());
  settings.name = name;
  settings.title = reader.text("title", titleFrom(name));
  settings.help = reader.text("help");
  settings.place = node.keyAt;
  const TomlNode* set = reader.table("set");
  reader.end();
  for (const auto& [key, value] : set ? set->table : decltype(set->table){}) {
    const auto formula = in.formula(value, key, Where::Parameter);
    const RobotNames::Name* parameter = in.spec().names.find(key);
    const bool own = parameter && parameter->kind == NameKind::Parameter;
    if (!formula) continue;
    if (!own && key.find('.') == std::string::npos) {
      const std::string near = nearestWord(key, in.spec().names.all(NameKind::Parameter));
      in.complaints().push_back(
          {value.keyAt, fmt::format("there is no parameter \"{}\"{}.", key,
                                    near.empty() ? "" : fmt::format(" (did you mean {}?)", near))});
      continue;
    }
    const double number = (*formula)({});
    if (own) {
      const Parameter& p = in.spec().parameters[static_cast<std::size_t>(parameter->index)];
      if (const auto checked = checkValue(p, number); !checked)
        in.complaints().push_back({value.at, checked.error().message});
    }
    settings.values.emplace_back(own ? "environment." + key : key, number);
  }
}

/// Short words for what every learning rule and every representation has; other keys are given in full.
void addLearning(const std::string& key, const TomlNode& node, double value, RobotReader& in) {
  constexpr std::string_view kRule[] = {"step_size", "trace_decay"};
  constexpr std::string_view kTable[] = {"tilings", "initial_high", "initial_low", "memory"};
  constexpr std::string_view kFull[] = {"agent.", "features.", "positive.", "negative.", "policy.", "risk."};
  const auto isOne = [&](const auto& words) {
    return std::find(std::begin(words), std::end(words), key) != std::end(words);
  };
  auto& learning = in.spec().learning;
  if (isOne(kRule)) {
    for (const char* estimate : {"agent.", "positive.", "negative.", "risk."})
      learning.emplace_back(estimate + key, value);
  } else if (isOne(kTable)) {
    for (const char* part : {"features.", "positive.", "negative."}) learning.emplace_back(part + key, value);
    if (key == "tilings" || key == "memory") learning.emplace_back("risk." + key, value);
  } else if (key == "discount") {
    learning.emplace_back("agent.discount", value);
  } else if (std::any_of(std::begin(kFull), std::end(kFull), [&](std::string_view f) { return key.starts_with(f); })) {
    learning.emplace_back(key, value);
  } else {
    in.complaints().push_back({node.keyAt, fmt::format("[learning] knows no \"{}\"; it takes step_size, trace_decay, "
                                                       "discount, tilings, initial_high, initial_low, memory, or a "
                                                       "key in full, such as \"agent.step_size\".",
                                                       key)});
  }
}

}  // namespace

void readSettings(const TomlNode& root, RobotReader& in) {
  for (const auto& [heading, all] :
       {std::pair{"preset", &in.spec().presets}, std::pair{"scenario", &in.spec().scenarios}}) {
    const TomlNode* tables = root.find(heading);
    for (const auto& [name, node] : tables ? tables->table : decltype(tables->table){})
      readSettingsOf(name, node, in, all->emplace_back());
  }
  const TomlNode* learning = root.find("learning");
  for (const auto& [key, node] : learning ? learning->table : decltype(learning->table){})
    if (const auto formula = in.formula(node, key, Where::Parameter)) {
      addLearning(key, node, (*formula)({}), in);
      in.spec().learningAt.resize(in.spec().learning.size(), node.at);
    }
}

}  // namespace surefoot
