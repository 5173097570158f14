// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of policies and representations themselves: made from a condition's configuration, not from its lives.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/experiment/configuration_json.h"
#include "core/recipes/live_scene.h"

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
  (*policy)->probabilities({.q = spec.q}, pi);
  FigureSeries series{.name = e.name(), .policy = c->names.policy, .x = {}, .y = {}, .marked = {}};
  for (std::size_t a = 0; a < pi.size(); ++a) {
    series.x.push_back(static_cast<double>(a + 1));
    series.y.push_back(exactly(pi[a]));
  }
  return series;
}

/// A learner that has learned nothing, and q̂(s, first action) along its task's first state variable.
class Section {
 public:
  static Result<Section> make(const Registry& registry, const Configuration& c, const std::vector<double>& state) {
    Section section;
    auto environment = makeEnvironment(registry, c);
    if (!environment) return environment.error();
    section.environment_ = std::move(*environment);
    const Task& task = section.environment_->task();
    if (state.size() != task.state.size())
      return Error{fmt::format("state: there are {} variables, and {} are given", task.state.size(), state.size())};
    const auto entry = findEntry(registry.agents, "agent", c.names.agent);
    if (!entry) return entry.error();
    auto agent = (*entry)->make({task, c.names.features, c.parameters, 0});
    if (!agent) return agent.error();
    section.agent_ = std::move(*agent);
    section.state_ = state;
    const StateVariable& along = task.state[0];
    constexpr int kPoints = 1000;
    const int points = along.whole ? static_cast<int>(along.high - along.low) : kPoints;
    for (int i = 0; i <= points; ++i) section.x_.push_back(along.low + i * (along.high - along.low) / points);
    return section;
  }
  const std::string& title() const { return environment_->task().state[0].title; }
  const std::vector<double>& x() const { return x_; }
  std::vector<double> values() const {
    std::vector<double> state = state_, values;
    for (const double x : x_) state[0] = x, values.push_back(at(state)[0]);
    return values;
  }
  /// q̂(state, ·) ← q̂(state, ·) + 1.
  void raise() {
    auto target = at(state_);
    for (double& q : target) q += 1.0;
    agent_->fit(state_, Layer::Sum, target, 1.0, 1.0);
  }

 private:
  std::vector<double> at(const std::vector<double>& state) const {
    std::vector<double> q(environment_->task().actions.size());
    agent_->values().evaluate(state, Layer::Sum, q);
    return q;
  }
  std::unique_ptr<Environment> environment_;
  std::unique_ptr<Agent> agent_;
  std::vector<double> state_, x_;
};

/// Kind "values": the values. Kind "generalisation": how they change when the value at spec.state is raised by 1.
Result<FigureSeries> section(const Registry& registry, const FigureSpec& spec, const Evidence& e, Figure& figure) {
  const auto c = configurationOf(registry, e);
  if (!c) return c.error();
  auto section = Section::make(registry, *c, spec.state);
  if (!section) return Error{e.name() + ": " + section.error().message};
  figure.xTitle = section->title();
  FigureSeries series{.name = e.name(), .policy = c->names.policy, .x = section->x(), .y = {}, .marked = {}};
  const auto before = section->values();
  if (spec.kind == "generalisation") section->raise();
  const auto after = section->values();
  for (std::size_t i = 0; i < after.size(); ++i)
    series.y.push_back(exactly(spec.kind == "generalisation" ? after[i] - before[i] : after[i]));
  return series;
}

}  // namespace

Result<Figure> makeLiveFigure(const Registry& registry, const FigureSpec& spec,
                              const std::vector<const Evidence*>& chosen) {
  const auto refuse = [&](const std::string& what) { return Error{fmt::format("figure {}: {}.", spec.name, what)}; };
  if (needsLives(spec.kind)) return refuse(fmt::format("\"{}\" is no figure without lives", spec.kind));
  if (spec.kind == "world" || spec.kind == "tilings") {
    const auto c = configurationOf(registry, *chosen[0]);
    if (!c) return refuse(c.error().message);
    auto drawn = (spec.kind == "world" ? drawWorld : drawTilings)(registry, spec, *c);
    return drawn ? std::move(drawn) : refuse(drawn.error().message);
  }
  const bool policies = spec.kind == "probabilities";
  const bool finite = std::all_of(spec.q.begin(), spec.q.end(), [](double v) { return std::isfinite(v); });
  if (policies && (spec.q.empty() || spec.q.size() > kMaxActions || !finite))
    return refuse("q: a list of action values is needed");
  Figure figure{.name = spec.name,
                .title = spec.title,
                .xTitle = "action",
                .yTitle = policies                ? "probability"
                          : spec.kind == "values" ? "initial value"
                                                  : "change of the value",
                .labels = {},
                .series = {}};
  for (const Evidence* e : chosen) {
    auto series = policies ? probabilities(registry, spec, *e) : section(registry, spec, *e, figure);
    if (!series) return refuse(series.error().message);
    figure.series.push_back(std::move(*series));
  }
  return figure;
}

}  // namespace surefoot
