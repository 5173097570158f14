// SPDX-License-Identifier: GPL-3.0-or-later
// What a figure shows, as numbers: for its CSV and for whoever draws it.
#pragma once

#include <span>
#include <string_view>

#include "core/findings/evidence.h"
#include "core/scene.h"

namespace surefoot {

/// A kind of figure: figure_kinds.cpp lists them.
struct FigureKind {
  enum class Needs { Nothing, Lives, Measure };  ///< Nothing: it is of policies and representations themselves
  std::string_view name;
  Needs needs;             ///< Measure: lives, and which measure of them
  std::string_view shows;  ///< for a list of all kinds
};
std::span<const FigureKind> figureKinds();

/// As a recipe states it.
struct FigureSpec {
  std::string name;  ///< "4.5a"
  std::string title, kind;
  std::vector<std::string> conditions;  ///< names or patterns; empty: all
  std::string measure = "falls";        ///< of bars and against
  std::string along;                    ///< of against: the key of the parameter
  std::vector<double> q, state;         ///< of probabilities; of generalisation, values and tilings
};

struct FigureSeries {
  std::string name, policy;
  std::vector<double> x;
  std::vector<Interval> y;
  std::vector<bool> marked;        ///< bars: differs from the reference
  std::optional<double> thesis{};  ///< bars: where the thesis's number would put it
  std::string agent{};             ///< the learning rule
  std::string reference{};         ///< the condition that it is compared with; empty: none
  int lives = 0, planned = 0;      ///< of the condition; 0, 0: it needs none

  bool complete() const { return lives >= planned; }
};

struct Figure {
  std::string name, title, xTitle, yTitle;
  bool bars = false;
  std::vector<std::string> labels;  ///< of bars, one each
  std::vector<FigureSeries> series;
  std::optional<Scene> scene{};  ///< in place of series: a picture
};

/// An error names the figure and what is wrong with it.
Result<Figure> makeFigure(const Registry& registry, const FigureSpec& spec, const std::vector<Evidence>& evidence);

/// Of the kinds that need no lives.
Result<Figure> makeLiveFigure(const Registry& registry, const FigureSpec& spec,
                              const std::vector<const Evidence*>& chosen);

bool needsLives(const std::string& kind);

/// Whether there is such a kind, and such a measure; an error names what there is.
Status checkFigure(const FigureSpec& spec);

/// A row a point: series, x, value, low, high, and of bars thesis; of a picture shape, x, y.
std::string figureAsCsv(const Figure& figure);

}  // namespace surefoot
