// SPDX-License-Identifier: GPL-3.0-or-later
// What a figure shows, as numbers: for its CSV and for whoever draws it. Kinds: learning-curve, reward-against-falls,
// cumulative-falls (curves with 95 % bands), settling (|A(k) − A(k − 250)| against episodes), bars (the mean of a
// measure, an X where it differs from the reference with p < .01), against (the mean of a measure against a varied
// parameter).
//
// Of policies and representations themselves: probabilities (of actions whose values are `q`), generalisation (how the
// value changes along the first state variable when it is moved by 1 in `state`), values (along the first state
// variable, before anything is learned), world (a picture of it), tilings (and which tiles hold `state`).
#pragma once

#include "core/findings/evidence.h"
#include "core/scene.h"

namespace surefoot {

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

bool isLiveFigure(const std::string& kind);

/// A row a point: series, x, value, low, high, and of bars thesis; of a picture shape, x, y.
std::string figureAsCsv(const Figure& figure);

}  // namespace surefoot
