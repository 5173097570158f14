// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of figures.
#include <fmt/format.h>

#include <algorithm>

#include "core/findings/evidence.h"
#include "core/parameters.h"
#include "core/recipes/figure.h"
#include "core/text/words.h"

namespace surefoot {

std::span<const FigureKind> figureKinds() {
  using Needs = FigureKind::Needs;
  static constexpr FigureKind kKinds[] = {
      {"learning-curve", Needs::Lives, "the average reward against time, with 95 % bands"},
      {"reward-against-falls", Needs::Lives, "the average reward against the falls so far"},
      {"cumulative-falls", Needs::Lives, "the falls so far against time, with 95 % bands"},
      {"settling", Needs::Lives, "|A(k) − A(k − 250)| of the average reward A against the episode k"},
      {"profile", Needs::Lives, "the share of lives with at most so many falls during learning, with 95 % bands"},
      {"frontier", Needs::Measure, "a condition a point: its falls during learning against a measure of its end"},
      {"bars", Needs::Measure, "the mean of a measure, an X where it differs from the reference with p < .01"},
      {"against", Needs::Measure, "the mean of a measure against the parameter `along` that was varied"},
      {"probabilities", Needs::Nothing, "of actions whose values are `q`"},
      {"generalisation", Needs::Nothing, "how the value along the first state variable changes, moved by 1 in `state`"},
      {"values", Needs::Nothing, "along the first state variable, before anything is learned"},
      {"world", Needs::Nothing, "a picture of it"},
      {"tilings", Needs::Nothing, "the tilings, and which tiles hold `state`"}};
  return kKinds;
}

namespace {

const FigureKind* kindOf(const std::string& name) {
  for (const FigureKind& kind : figureKinds())
    if (kind.name == name) return &kind;
  return nullptr;
}

}  // namespace

bool needsLives(const std::string& kind) {
  const FigureKind* k = kindOf(kind);
  return !k || k->needs != FigureKind::Needs::Nothing;
}

Status checkFigure(const FigureSpec& spec, const std::vector<std::string>& measures) {
  const FigureKind* kind = kindOf(spec.kind);
  if (!kind) {
    std::vector<std::string> names;
    for (const FigureKind& k : figureKinds()) names.emplace_back(k.name);
    return Error{
        fmt::format("figure {}: kind: there is no \"{}\"; it takes {}.", spec.name, spec.kind, joinWords(names, "or"))};
  }
  if (kind->needs == FigureKind::Needs::Measure &&
      std::find(measures.begin(), measures.end(), spec.measure) == measures.end())
    return Error{fmt::format("figure {}: measure: there is no \"{}\"; it takes {}.", spec.name, spec.measure,
                             joinWords(measures, "or"))};
  return Done{};
}

}  // namespace surefoot
