// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of policies and representations themselves: made from a condition's configuration, not from its lives.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/experiment/configuration_json.h"
#include "core/laboratory/figure.h"

namespace surefoot {

namespace {

Result<Configuration> configurationOf(const Registry& registry, const Evidence& e) {
  return configurationFromJson(registry, e.configuration, e.name());
}

Interval exactly(double value) {
  return {value, value, value};
}

/// π over the actions, whose values are spec.q.
Result<FigureSeries> probabilities(const Registry& registry, const FigureSpec& spec, const Evidence& e) {
  const auto c = configurationOf(registry, e);
  if (!c) return c.error();
  const auto policy = makePolicy(registry, c->names.policy, c->parameters);
  if (!policy) return policy.error();
  std::vector<double> pi(spec.q.size());
  (*policy)->probabilities(spec.q, pi);
  FigureSeries series{.name = e.name(), .policy = c->names.policy, .x = {}, .y = {}, .marked = {}};
  for (std::size_t a = 0; a < pi.size(); ++a) {
    series.x.push_back(static_cast<double>(a + 1));
    series.y.push_back(exactly(pi[a]));
  }
  return series;
}

/// q̂(s, first action) along the first state variable, after q̂ was moved by 1 at spec.state alone.
Result<FigureSeries> generalisation(const Registry& registry, const FigureSpec& spec, const Evidence& e,
                                    Figure& figure) {
  const auto c = configurationOf(registry, e);
  if (!c) return c.error();
  const auto environment = makeEnvironment(registry, *c);
  if (!environment) return environment.error();
  const Task& task = (*environment)->task();
  if (spec.state.size() != task.state.size())
    return Error{
        fmt::format("state: {} has {} variables, and {} are given", e.name(), task.state.size(), spec.state.size())};
  const auto entry = findEntry(registry.agents, "agent", c->names.agent);
  if (!entry) return entry.error();
  auto agent = (*entry)->make({task, c->names.features, c->parameters, 0});
  if (!agent) return agent.error();
  const auto valueAt = [&](const std::vector<double>& state) {
    std::vector<double> q(task.actions.size());
    (*agent)->values().evaluate(state, Layer::Sum, q);
    return q[0];
  };
  const StateVariable& along = task.state[0];
  figure.xTitle = along.title;
  FigureSeries series{.name = e.name(), .policy = c->names.policy, .x = {}, .y = {}, .marked = {}};
  const double step = along.whole ? 1.0 : (along.high - along.low) / 200;
  std::vector<double> state = spec.state, before;
  for (double x = along.low; x <= along.high + 1e-9; x += step) {
    state[0] = x;
    series.x.push_back(x);
    before.push_back(valueAt(state));
  }
  std::vector<double> target(task.actions.size());
  (*agent)->values().evaluate(spec.state, Layer::Sum, target);
  for (double& q : target) q += 1.0;
  (*agent)->fit(spec.state, Layer::Sum, target, 1.0, 1.0);
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    state[0] = series.x[i];
    series.y.push_back(exactly(valueAt(state) - before[i]));
  }
  return series;
}

}  // namespace

Result<Figure> makeLiveFigure(const Registry& registry, const FigureSpec& spec,
                              const std::vector<const Evidence*>& chosen) {
  const bool policies = spec.kind == "probabilities";
  const auto refuse = [&](const std::string& what) { return Error{fmt::format("figure {}: {}.", spec.name, what)}; };
  const bool finite = std::all_of(spec.q.begin(), spec.q.end(), [](double v) { return std::isfinite(v); });
  if (policies && (spec.q.empty() || spec.q.size() > kMaxActions || !finite))
    return refuse("q: a list of action values is needed");
  Figure figure{.name = spec.name,
                .title = spec.title,
                .xTitle = "action",
                .yTitle = policies ? "probability" : "change of the value",
                .labels = {},
                .series = {}};
  for (const Evidence* e : chosen) {
    auto series = policies ? probabilities(registry, spec, *e) : generalisation(registry, spec, *e, figure);
    if (!series) return refuse(series.error().message);
    figure.series.push_back(std::move(*series));
  }
  return figure;
}

}  // namespace surefoot
