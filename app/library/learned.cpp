// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/library/learned.h"

#include <fmt/format.h>

#include <cmath>

#include "app/library/handle.h"
#include "core/text/words.h"
#include "core/values_of_state.h"

namespace surefoot {

namespace {

constexpr Layer kLayers[] = {Layer::Sum, Layer::Positive, Layer::Negative, Layer::Risk};
constexpr const char* kLayerNames[] = {"sum", "positive", "negative", "risk"};

bool has(const ActionValueFunction& function, Layer layer) {
  if (layer == Layer::Risk) return function.hasRisk();
  return layer == Layer::Sum || function.split();
}

/// Every number of the states is finite, and the place for the answer is as large as it must be.
Status check(const Task& task, const States& states, const void* place, std::size_t count, std::size_t each,
             const char* name) {
  if (const Status s = checkArray(place, count, states.n * each, name); !s) return s;
  if (!states.values && states.n > 0) return Error{"states: it is NULL."};
  const std::size_t d = task.state.size();
  for (std::size_t i = 0; i < states.n * d; ++i)
    if (!std::isfinite(states.values[i]))
      return Error{fmt::format("states: {} of state {} is {}; only finite numbers are allowed.", task.state[i % d].key,
                               i / d, states.values[i])};
  return Done{};
}

std::span<const double> row(const Task& task, const States& states, std::size_t i) {
  return {states.values + i * task.state.size(), task.state.size()};
}

}  // namespace

std::vector<std::string> layersOf(const ActionValueFunction& function) {
  std::vector<std::string> names;
  for (const Layer layer : kLayers)
    if (has(function, layer)) names.emplace_back(kLayerNames[static_cast<std::size_t>(layer)]);
  return names;
}

Status valuesOf(const ActionValueFunction& function, const Task& task, int32_t layer, const States& states,
                double* values, std::size_t count) {
  const auto actions = static_cast<std::size_t>(function.actions());
  if (layer < SUREFOOT_LAYER_SUM || layer > SUREFOOT_LAYER_RISK)
    return Error{fmt::format("layer: {} is not allowed; it goes from 0 to 3.", layer)};
  const Layer which = kLayers[static_cast<std::size_t>(layer)];
  if (!has(function, which))
    return Error{fmt::format("layer: this learner does not keep \"{}\"; it has {}.",
                             kLayerNames[static_cast<std::size_t>(layer)], joinWords(layersOf(function), "and"))};
  if (const Status s = check(task, states, values, count, actions, "values"); !s) return s;
  for (std::size_t i = 0; i < states.n; ++i)
    function.evaluate(row(task, states, i), which, {values + i * actions, actions});
  return Done{};
}

Status probabilitiesOf(const ActionValueFunction& function, const Task& task, const Policy& policy,
                       const States& states, double* pi, std::size_t count) {
  const auto actions = static_cast<std::size_t>(function.actions());
  if (const Status s = check(task, states, pi, count, actions, "pi"); !s) return s;
  ValuesOfState here;
  for (std::size_t i = 0; i < states.n; ++i) {
    here.evaluate(function, row(task, states, i));
    policy.probabilities(here.view(), {pi + i * actions, actions});
  }
  return Done{};
}

Status visitsOf(const ActionValueFunction& function, const Task& task, const States& states, double* visits,
                std::size_t count) {
  if (const Status s = check(task, states, visits, count, 1, "visits"); !s) return s;
  for (std::size_t i = 0; i < states.n; ++i) visits[i] = function.visits(row(task, states, i));
  return Done{};
}

}  // namespace surefoot
