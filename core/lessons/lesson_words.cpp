// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/lesson_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/text/printable.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

using QuantityKind = LessonQuantity::Kind;

struct OfALife {
  std::string_view name;
  QuantityKind kind;
  double low;
};

constexpr OfALife kOfALife[] = {
    {"episodes", QuantityKind::Episodes, 0.0},   {"falls", QuantityKind::Falls, 0.0},
    {"successes", QuantityKind::Successes, 0.0}, {"steps", QuantityKind::Steps, 0.0},
    {"minutes", QuantityKind::Minutes, 0.0},     {"average_reward", QuantityKind::AverageReward, -kInfinity},
    {"exploring", QuantityKind::Exploring, 0.0}, {"pushes", QuantityKind::Pushes, 0.0}};

/// "0.75", "−0.75", "up": the number of an action.
std::optional<std::size_t> actionOf(const Task& task, std::string_view name) {
  for (std::size_t a = 0; a < task.actionNames.size(); ++a)
    if (task.actionNames[a] == name) return a;
  double value = 0.0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), value);
  if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
  const auto found = std::find(task.actions.begin(), task.actions.end(), value);
  if (found == task.actions.end()) return std::nullopt;
  return static_cast<std::size_t>(found - task.actions.begin());
}

std::vector<std::string> actionNames(const Task& task) {
  constexpr std::size_t kMost = 12;
  std::vector<std::string> names = task.actionNames;
  for (std::size_t a = names.size(); a < task.actions.size(); ++a) names.push_back(fmt::format("{}", task.actions[a]));
  if (names.size() > kMost) names.resize(kMost), names.emplace_back("…");
  return names;
}

}  // namespace

Quantity LessonWords::placed(LessonQuantity quantity, double low, double high) const {
  auto found = std::find(quantities_.begin(), quantities_.end(), quantity);
  if (found == quantities_.end()) found = quantities_.insert(found, std::move(quantity));
  return {static_cast<int>(found - quantities_.begin()), ValueKind::Number, low, high};
}

Result<Quantity> LessonWords::find(std::string_view name, std::optional<std::string_view> argument) const {
  if (argument) return withArgument(name, *argument);
  const bool before = name.starts_with("before.");
  const std::string_view plain = before ? name.substr(7) : name;
  for (const OfALife& q : kOfALife) {
    if (q.name != plain) continue;
    if (q.kind == QuantityKind::Minutes && !task_.stepTime)
      return Error{"this task has no clock; count steps or episodes."};
    return placed({.kind = q.kind, .before = before}, q.low);
  }
  if (before)
    return Error{fmt::format("of the life before there are {}.",
                             "episodes, falls, successes, steps, minutes, average_reward, exploring and pushes")};
  if (name == "replays") return placed({.kind = QuantityKind::Replays}, 0.0);
  if (name == "pointed" && known_.pointing) return placed({.kind = QuantityKind::Pointed});
  if (name == "visits") return placed({.kind = QuantityKind::Visits}, 0.0);
  if (const Parameters::Entry* entry = parameters_.find(name))
    return placed({.kind = QuantityKind::Parameter, .key = std::string(name)}, entry->parameter.low,
                  entry->parameter.high);
  for (std::size_t d = 0; d < task_.state.size(); ++d)
    if (task_.state[d].key == name)
      return placed({.kind = QuantityKind::State, .index = d}, task_.state[d].low, task_.state[d].high);
  for (const char* needs :
       {"q", "risk", "probability", "observed", "predicted", "mean", "least", "most", "lower", "tells"})
    if (name == needs) return Error{fmt::format("{} needs something in parentheses.", name)};
  return Error{};
}

std::optional<std::size_t> LessonWords::wayNamed(std::string_view label) const {
  const auto way = std::find(known_.ways.begin(), known_.ways.end(), label);
  if (way == known_.ways.end()) return std::nullopt;
  return static_cast<std::size_t>(way - known_.ways.begin());
}

/// "ε 0.05, ε 0.25": the labels of two ways.
Result<Quantity> LessonWords::ofTwoWays(QuantityKind kind, std::string_view argument) const {
  for (std::size_t comma = argument.find(", "); comma != argument.npos; comma = argument.find(", ", comma + 1)) {
    const auto first = wayNamed(argument.substr(0, comma)), second = wayNamed(argument.substr(comma + 2));
    if (!first || !second) continue;
    Quantity quantity = placed({.kind = kind, .index = *first, .other = *second}, 0.0, 1.0);
    quantity.kind = ValueKind::Flag;
    return quantity;
  }
  return Error{fmt::format("\"{}\" are not two ways of lives up to this step, with a comma between them.",
                           printable(shortened(argument)))};
}

Result<Quantity> LessonWords::withArgument(std::string_view name, std::string_view argument) const {
  if (name == "q" || name == "risk" || name == "probability") {
    const auto action = actionOf(task_, argument);
    if (!action)
      return Error{fmt::format("there is no action \"{}\"; there are {}.", printable(shortened(argument)),
                               joinWords(actionNames(task_), "and"))};
    if (name == "q") return placed({.kind = QuantityKind::ActionValue, .index = *action});
    if (name == "risk") return placed({.kind = QuantityKind::Risk, .index = *action});
    return placed({.kind = QuantityKind::Probability, .index = *action}, 0.0, 1.0);
  }
  const std::pair<std::string_view, QuantityKind> ofWays[] = {
      {"mean", QuantityKind::Mean}, {"least", QuantityKind::Least}, {"most", QuantityKind::Most}};
  for (const auto& [word, kind] : ofWays) {
    if (word != name) continue;
    const auto way = wayNamed(argument);
    if (!way) return Error{fmt::format("no lives are called \"{}\" up to this step.", printable(shortened(argument)))};
    return placed({.kind = kind, .index = *way});
  }
  if (name == "lower") return ofTwoWays(QuantityKind::Lower, argument);
  if (name == "tells") return ofTwoWays(QuantityKind::Tells, argument);
  if (name != "observed" && name != "predicted") return Error{};
  const std::vector<bool>& may = name == "observed" ? known_.observes : known_.predicts;
  std::size_t step = 0;
  const auto [end, error] = std::from_chars(argument.data(), argument.data() + argument.size(), step);
  if (error != std::errc() || end != argument.data() + argument.size() || step < 1 || step > may.size() ||
      !may[step - 1])
    return Error{fmt::format("step {} {} nothing; {} takes the number of this step or an earlier one that does.",
                             printable(shortened(argument)), name == "observed" ? "observes" : "predicts", name)};
  return placed({.kind = name == "observed" ? QuantityKind::Observed : QuantityKind::Predicted, .index = step - 1});
}

std::vector<std::string> LessonWords::names() const {
  std::vector<std::string> all = {"visits", "replays", "q(",    "probability(", "observed(", "predicted(",
                                  "mean(",  "least(",  "most(", "lower(",       "tells("};
  if (known_.pointing) all.emplace_back("pointed");
  for (const OfALife& q : kOfALife) {
    all.emplace_back(q.name);
    all.push_back("before." + std::string(q.name));
  }
  for (const auto& entry : parameters_.all()) all.push_back(entry.parameter.key);
  for (const StateVariable& v : task_.state) all.push_back(v.key);
  return all;
}

}  // namespace surefoot
