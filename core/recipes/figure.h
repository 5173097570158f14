// SPDX-License-Identifier: GPL-3.0-or-later
// The content of a figure as numbers: for its CSV file and for drawing it.
#pragma once

#include <span>
#include <string_view>

#include "core/findings/evidence.h"
#include "core/scene.h"

namespace surefoot {

/// A kind of figure: figure_kinds.cpp lists them.
struct FigureKind {
  enum class Needs { Nothing, Lives, Measure };  ///< Nothing: it shows policies and representations themselves
  std::string_view name;
  Needs needs;             ///< Measure: lives, and which measure of them
  std::string_view shows;  ///< for a list of all kinds
};
std::span<const FigureKind> figureKinds();

/// A figure as a recipe states it.
struct FigureSpec {
  std::string name;  ///< "4.5a"
  std::string title, kind;
  std::vector<std::string> conditions{};  ///< names or patterns; empty: all
  std::string measure = "falls";          ///< for the kinds bars, against and frontier: the measure that is drawn
  std::string along{};                    ///< for the kind against: the key of the parameter
  std::vector<double> q{}, state{};       ///< q: for probabilities; state: for generalisation, values, tilings
};

struct FigureSeries {
  std::string name, policy;
  std::vector<double> x;
  std::vector<Interval> y;
  std::vector<bool> marked;        ///< bars: differs from the reference
  std::optional<double> thesis{};  ///< bars: where the thesis's number would put it
  std::vector<Interval> spread{};  ///< frontier: the intervals of x
  std::string agent{};             ///< the learning rule
  std::string reference{};         ///< the condition that it is compared with; empty: none
  int lives = 0, planned = 0;      ///< lives of the condition; 0, 0: it needs none

  bool complete() const { return lives >= planned; }
};

struct Figure {
  std::string name, title, xTitle, yTitle;
  bool bars = false, points = false;  ///< points: each series is one, with intervals of both its numbers
  std::vector<std::string> labels;    ///< for bars: one label per bar
  std::vector<FigureSeries> series;
  std::optional<Scene> scene{};  ///< in place of series: a picture
};

/// An error names the figure and what is wrong with it.
Result<Figure> makeFigure(const Registry& registry, const FigureSpec& spec, const std::vector<Evidence>& evidence);

/// Makes a figure of a kind that needs no lives.
Result<Figure> makeLiveFigure(const Registry& registry, const FigureSpec& spec,
                              const std::vector<const Evidence*>& chosen);

bool needsLives(const std::string& kind);

/// Whether kind and measure exist; the error names the ones that do. `measures`: from measureNames().
Status checkFigure(const FigureSpec& spec, const std::vector<std::string>& measures);

/// One row per point: series, x, value, low, high, and for bars thesis; for a picture shape, x, y.
std::string figureAsCsv(const Figure& figure);

}  // namespace surefoot
