// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recipes/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "core/basics/typed_json.h"
#include "core/experiment/configuration_json.h"
#include "core/parameters.h"
#include "core/recipes/claim.h"
#include "core/recipes/live_scene.h"
#include "core/statistics/statistics_text.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

constexpr std::size_t kCurvePoints = 361;  // points of a curve against time

std::string policyOf(const Evidence& e) {
  return textIn(e.configuration, "policy");
}

double parameterOf(const Evidence& e, const std::string& key) {
  return numberIn(partOf(e.configuration, "parameters"), key);
}

/// |A(k) − A(k − 250)| against k, from 251 on.
Curve settlingOf(const Evidence& e) {
  constexpr std::size_t kSpan = 250;
  Curve curve;
  for (std::size_t k = kSpan + 1; k <= e.averages.size(); ++k) {
    const double change = std::abs(e.averages[k - 1] - e.averages[k - 1 - kSpan]);
    curve.x.push_back(static_cast<double>(k));
    curve.y.push_back({change, change, change});
  }
  return curve;
}

/// The share of lives with at most x falls during learning, for every x that occurs.
Curve profileOf(const Evidence& e) {
  const std::vector<double> falls = valuesOf(e, "falls");
  const Units units = unitsOf(e.record);
  Curve curve;
  for (const double x : std::set<double>(falls.begin(), falls.end())) {
    std::vector<double> within;
    for (const double f : falls) within.push_back(f <= x ? 1.0 : 0.0);
    const Interval share = intervalOf(estimateOf(within, units));
    const Interval before = curve.y.empty() ? Interval{} : curve.y.back();
    curve.x.insert(curve.x.end(), {x, x});  // a staircase
    curve.y.insert(curve.y.end(), {before, {share.value, std::max(0.0, share.low), std::min(1.0, share.high)}});
  }
  return curve;
}

using Chosen = std::vector<const Evidence*>;

/// A figure with a curve for each condition.
struct CurveKind {
  std::string_view name;
  const char* xTitle;  ///< empty: the simulated time, or episodes where the task has no clock
  const char* yTitle;
  Curve (*of)(const Evidence& e);
};

constexpr CurveKind kCurveKinds[] = {
    {"learning-curve", "", "average reward", [](const Evidence& e) { return learningCurve(e.record, kCurvePoints); }},
    {"reward-against-falls", "falls", "average reward", [](const Evidence& e) { return rewardAgainstFalls(e.record); }},
    {"cumulative-falls", "", "falls so far", [](const Evidence& e) { return cumulativeFalls(e.record, kCurvePoints); }},
    {"settling", "episodes", "change in 250 episodes", settlingOf},
    {"profile", "falls during learning", "share of lives", profileOf}};

void addCurves(Figure& figure, const CurveKind& kind, const Chosen& chosen) {
  const bool clock = chosen[0]->record.condition.stepTime > 0;
  figure.xTitle = *kind.xTitle ? kind.xTitle : clock ? "simulated time [min]" : "episodes";
  figure.yTitle = kind.yTitle;
  for (const Evidence* e : chosen) {
    Curve curve = kind.of(*e);
    figure.series.push_back({e->name(), policyOf(*e), std::move(curve.x), std::move(curve.y), {}});
  }
}

std::string number(double value) {
  constexpr int kDigits = 9;
  return numberCell(value, kDigits);
}

bool differs(const Evidence& e, const std::vector<Evidence>& all, const std::string& measure) {
  for (const Evidence& reference : all) {
    if (reference.name() != e.record.condition.reference || &reference == &e) continue;
    const auto test = testOfUnits(reference, e, measure);
    return test && test->p < 0.01;
  }
  return false;
}

void addBars(Figure& figure, const FigureSpec& spec, const Chosen& chosen, const std::vector<Evidence>& all) {
  figure.bars = true;
  figure.yTitle = measureTitle(spec.measure, all);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const Evidence& e = *chosen[i];
    figure.labels.push_back(e.name());
    figure.series.push_back({e.name(),
                             policyOf(e),
                             {static_cast<double>(i)},
                             {meanOf(e, spec.measure)},
                             {differs(e, all, spec.measure)},
                             {}});
  }
}

void addFrontier(Figure& figure, const FigureSpec& spec, const Chosen& chosen, const std::vector<Evidence>& all) {
  figure.points = true;
  figure.xTitle = measureTitle("falls", all);
  figure.yTitle = measureTitle(spec.measure, all);
  for (const Evidence* e : chosen) {
    const Interval falls = meanOf(*e, "falls"), end = meanOf(*e, spec.measure);
    if (!std::isfinite(falls.value) || !std::isfinite(end.value)) continue;
    figure.series.push_back(
        {.name = e->name(), .policy = policyOf(*e), .x = {falls.value}, .y = {end}, .marked = {}, .spread = {falls}});
  }
}

/// The name of a parameter for people: "Q⁻ step size α".
std::string titleOf(const Registry& registry, const Evidence& e, const std::string& key) {
  const auto c = configurationFromJson(registry, e.configuration, e.name());
  const Parameters::Entry* entry = c ? c->parameters.find(key) : nullptr;
  if (!entry) return key;
  const Parameter& p = entry->parameter;
  return p.title + (p.symbol.empty() ? "" : " " + p.symbol) + (p.unit.empty() ? "" : " [" + p.unit + "]");
}

Status addAgainst(const Registry& registry, Figure& figure, const FigureSpec& spec, const Chosen& chosen,
                  const std::vector<Evidence>& all) {
  figure.xTitle = titleOf(registry, *chosen[0], spec.along);
  figure.yTitle = measureTitle(spec.measure, all);
  FigureSeries series{.name = figure.yTitle, .policy = policyOf(*chosen[0]), .x = {}, .y = {}, .marked = {}};
  std::map<double, const Evidence*> inOrder;
  for (const Evidence* e : chosen) {
    const double x = parameterOf(*e, spec.along);
    if (!std::isfinite(x))
      return Error{fmt::format("figure {}: along: \"{}\" is no number of {}.", spec.name, spec.along, e->name())};
    inOrder[x] = e;
  }
  for (const auto& [x, e] : inOrder) series.x.push_back(x), series.y.push_back(meanOf(*e, spec.measure));
  figure.series.push_back(std::move(series));
  return Done{};
}

/// Fills in the learning rule, the reference and the number of lives of every series.
void describeSeries(Figure& figure, const Chosen& chosen) {
  for (FigureSeries& series : figure.series)
    for (const Evidence* e : chosen) {
      if (e->name() != series.name) continue;
      series.agent = textIn(e->configuration, "agent");
      series.reference = e->record.condition.reference;
      series.lives = static_cast<int>(e->lives.size()) + e->record.diverged;
      series.planned = e->record.condition.lives;
    }
}

}  // namespace

Result<Figure> makeFigure(const Registry& registry, const FigureSpec& spec, const std::vector<Evidence>& evidence) {
  Chosen chosen;
  for (const Evidence& e : evidence) {
    const bool wanted =
        spec.conditions.empty() || std::any_of(spec.conditions.begin(), spec.conditions.end(),
                                               [&](const std::string& pattern) { return fits(e.name(), pattern); });
    if (wanted && !e.lives.empty()) chosen.push_back(&e);
  }
  if (chosen.empty()) return Error{fmt::format("figure {}: no condition fits.", spec.name)};
  if (const Status s = checkFigure(spec, measureNames(taskMeasuresOf(evidence))); !s) return s.error();
  if (!needsLives(spec.kind)) return makeLiveFigure(registry, spec, chosen);

  Figure figure{.name = spec.name, .title = spec.title, .xTitle = {}, .yTitle = {}, .labels = {}, .series = {}};
  const auto curve = std::find_if(std::begin(kCurveKinds), std::end(kCurveKinds),
                                  [&](const CurveKind& k) { return k.name == spec.kind; });
  if (curve != std::end(kCurveKinds))
    addCurves(figure, *curve, chosen);
  else if (spec.kind == "bars")
    addBars(figure, spec, chosen, evidence);
  else if (spec.kind == "frontier")
    addFrontier(figure, spec, chosen, evidence);
  else if (spec.kind != "against")
    return Error{fmt::format("figure {}: nothing draws the kind {}.", spec.name, spec.kind)};
  else if (const Status s = addAgainst(registry, figure, spec, chosen, evidence); !s)
    return s.error();
  describeSeries(figure, chosen);
  return figure;
}

std::string figureAsCsv(const Figure& figure) {
  if (figure.scene) return sceneAsCsv(*figure.scene);
  fmt::memory_buffer out;
  const auto to = std::back_inserter(out);
  fmt::format_to(to, "series,{},value,low,high{}\n", figure.bars ? "bar" : "x", figure.bars ? ",thesis" : "");
  for (const FigureSeries& s : figure.series) {
    const std::string name = csvCell(s.name);
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      fmt::format_to(to, "{},{:.9g},{},{},{}", name, s.x[i], number(s.y[i].value), number(s.y[i].low),
                     number(s.y[i].high));
      if (figure.bars) fmt::format_to(to, ",{}", s.thesis ? fmt::format("{:.9g}", *s.thesis) : "");
      out.push_back('\n');
    }
  }
  return fmt::to_string(out);
}

}  // namespace surefoot
