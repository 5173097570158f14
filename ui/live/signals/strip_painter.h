// SPDX-License-Identifier: GPL-3.0-or-later
// Draws strips one below the other on one time axis: names at the left, numbers of the moment at the right. Without a
// widget, so that files and films have the same picture.
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
  const SignalTable* second = nullptr;  ///< drawn thin and dashed behind; nullptr: none
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

  void paint(QPainter& p) const;
  const QRectF& plot() const { return plot_; }
  /// Where each strip is, over the whole width.
  const std::vector<QRectF>& strips() const { return places_; }
  double timeAt(double x) const { return picture_.from + (x - plot_.left()) / plot_.width() * span(); }
  double xOf(double time) const { return plot_.left() + (time - picture_.from) / span() * plot_.width(); }

 private:
  static constexpr double kNames = 150, kNumbers = 76;           ///< columns at the left and the right [px]
  static constexpr double kTop = 14, kTimes = 28, kBetween = 6;  ///< above, the time axis below, between strips [px]
  static constexpr double kRowHeight = 16;                       ///< of an on/off signal [px]
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
  void drawCurve(QPainter& p, const SignalTable& table, std::size_t place, const QRectF& where, const Range& range,
                 StripLook look) const;
  void drawBars(QPainter& p, const StripSignals& strip, const QRectF& where, const Range& range) const;
  void drawOnOff(QPainter& p, const StripSignals& strip, const QRectF& where) const;
  /// The rows of a table that are shown, with one more at either end.
  std::pair<std::size_t, std::size_t> rowsOf(const SignalTable& table) const;
  std::optional<std::size_t> secondRow() const;
  QColor colourOf(const StripSignals& strip, std::size_t index) const;

  const Theme& theme_;
  const StripPicture& picture_;
  QRectF plot_;
  std::vector<StripSignals> signals_;
  std::vector<QRectF> places_;
};

}  // namespace surefoot
