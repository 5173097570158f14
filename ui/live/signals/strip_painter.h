// SPDX-License-Identifier: GPL-3.0-or-later
// Draws strips one below the other on one time axis: names at the left, numbers of the moment at the right; what a
// second one did is drawn behind, lighter and dashed. Without a widget, so that files and films have the same picture.
#pragma once

#include <QPainter>
#include <QRectF>
#include <optional>
#include <utility>
#include <vector>

#include "ui/live/signals/strips.h"

namespace surefoot {

struct Theme;

struct StripPicture {
  const SignalTable* table = nullptr;
  const SignalTable* second = nullptr;  ///< nullptr: none
  double secondLater = 0.0;             ///< to be added to the second's times
  QString names[2]{};                   ///< of both, for the legend
  std::vector<Strip> strips{};
  double from = 0.0, to = 1.0;                      ///< the time that is shown
  std::optional<std::size_t> row{};                 ///< of the moment
  std::optional<std::pair<double, double>> band{};  ///< a time that is marked
  QColor learner{};                                 ///< of the policy, for values
  bool clock = true;                                ///< time is in seconds
};

/// Lengths are pixels at text size 1. Used by one thread.
class StripPainter {
 public:
  StripPainter(const Theme& theme, const StripPicture& picture, const QRectF& area);
  /// The height in which every strip can be read.
  static double leastHeight(const StripPicture& picture);
  /// The height of the time axis at the lower edge.
  static constexpr double kTimes = 28;

  void paint(QPainter& p) const;
  /// The time axis with the moment alone, and the legend.
  void paintTimes(QPainter& p) const;
  const QRectF& plot() const { return plot_; }
  /// Where each strip is, over the whole width.
  const std::vector<QRectF>& strips() const { return places_; }
  double timeAt(double x) const { return picture_.from + (x - plot_.left()) / plot_.width() * span(); }
  double xOf(double time) const { return plot_.left() + (time - picture_.from) / span() * plot_.width(); }

 private:
  static constexpr double kNames = 150, kNumbers = 76;  ///< columns at the left and the right [px]
  static constexpr double kTop = 14, kBetween = 6;      ///< above, between strips [px]
  static constexpr double kRowHeight = 16;              ///< of an on/off signal [px]
  /// One of the two that are drawn.
  struct Life {
    const SignalTable& table;
    double later;  ///< to be added to its times
    bool first;
  };
  struct Range {
    double low, high, step;
  };
  double span() const { return picture_.to - picture_.from; }
  /// How much of the room a strip wants, and what it needs at least [px].
  struct Want {
    double share, least;
  };
  static Want wantOf(const StripSignals& strip);
  Range rangeOf(const StripSignals& strip, double height) const;
  void drawTimes(QPainter& p) const;
  void drawName(QPainter& p, const StripSignals& strip, const QRectF& where) const;
  void drawAxis(QPainter& p, const QRectF& where, const Range& range) const;
  void drawMoment(QPainter& p) const;
  void drawNumbers(QPainter& p, const StripSignals& strip, const QRectF& where, const Range& range) const;
  void drawLegend(QPainter& p) const;
  void drawStrip(QPainter& p, const StripSignals& strip, const QRectF& where, const Range& range) const;
  void drawSecond(QPainter& p, const StripSignals& strip, const QRectF& where, const Range& range) const;
  void drawCurve(QPainter& p, const Life& life, const std::vector<double>& values, const QRectF& where,
                 const Range& range, StripLook look) const;
  void drawBars(QPainter& p, const StripSignals& strip, const QRectF& where, const Range& range) const;
  void drawOnOff(QPainter& p, const Life& life, const StripSignals& strip, const QRectF& where) const;
  Life first() const { return {*picture_.table, 0.0, true}; }
  /// None: there is no second, or it has no rows.
  std::optional<Life> second() const;
  /// Of a signal of the first's; nullptr: this one does not have it.
  const std::vector<double>* columnOf(const Life& life, std::size_t place) const;
  /// The rows that are shown, with one more at either end.
  std::pair<std::size_t, std::size_t> rowsOf(const Life& life) const;
  std::optional<std::size_t> secondRow() const;
  QColor colourOf(const StripSignals& strip, std::size_t index) const;
  QPen secondPen(const QColor& ofFirst) const;

  const Theme& theme_;
  const StripPicture& picture_;
  QRectF plot_;
  std::vector<StripSignals> signals_;
  std::vector<QRectF> places_;
};

}  // namespace surefoot
