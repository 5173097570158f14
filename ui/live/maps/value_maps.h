// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of value maps: a quantity of one's choice large; visits and eligibility small, or the risk of a fall and
// visits where risk is learned, or, under Sarsa_2Q, its two parts. All maps share axes and cursor. The cursor is the
// mouse's or, with the focus, the keyboard's: arrows move it a cell, Enter fixes it, Escape lets go; the cell is spoken
// as the widget's description.
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <limits>
#include <memory>
#include <utility>

#include "core/policy.h"
#include "ui/live/maps/map_choice.h"
#include "ui/live/maps/value_map.h"
#include "ui/style/painted.h"
#include "ui/support/exporting.h"

namespace surefoot {

class Looking;
class RunningLife;

class ValueMaps final : public Painted<>, public CsvSource {
  Q_OBJECT

 public:
  explicit ValueMaps(RunningLife& life, Looking& looking, QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({440, 264}); }
  QSize minimumSizeHint() const override { return scaled({300, 160}); }

  const MapChoice& choice() const { return choice_; }
  void setChoice(const MapChoice& choice);
  /// The state under the cursor, or the fixed state, in words; empty: none.
  QString spoken() const;
  /// A text about the outlined tiles, which an update there would reach; empty: the features have no tiles.
  QString reached() const;
  std::string asCsv() const override;

 Q_SIGNALS:
  /// The choice, or a number in it, changed.
  void shown();
  /// A click asks for the world to be put into this state.
  void placeAsked(const std::vector<double>& state);

 protected:
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override { recompute(); }
  void changeEvent(QEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  static constexpr int kCell = 3, kSmallCell = 2;  // [px]
  static constexpr double kFamiliar = 0.25;        // share of the active tiles below which a state was never visited
  static constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
  /// Where the maps and their bars lie; Q, Q⁺ and Q⁻ share one bar.
  struct Geometry {
    QRectF square, big, bigBar, upper, upperBar, lower, lowerBar;  // `square`: the room of the big one
    double bigBarRoom;                                             // for numbers beside its bar
    double upperTitleEnd, lowerTitleEnd;                           // right ends of the small maps' titles
    QPointF key;                                                   // "never visited"
    std::pair<double, double> xTitle;                              // room of the title below the big map
  };
  bool split() const;
  bool risky() const;   ///< the small maps are risk and visits
  bool valued() const;  ///< the large map is in units of reward
  ValueMap::Quantity quantity(Layer layer) const;
  ValueMap::Quantity partOf(Layer layer) const;
  ValueMap::Quantity bestActions() const;
  ValueMap::Quantity risk() const;
  std::optional<double> riskLimit() const;
  void rebuildPolicy();
  ValueMap::Quantity visits() const;
  ValueMap::Quantity eligibility() const;
  MapScale scaleOf(const ValueMap& map) const;
  void computeSmall(int cells, bool dark);
  void recompute();
  void followLive();
  std::vector<QPointF> directions() const;
  void speak();
  void moveCursor(int columns, int rows);
  std::optional<std::vector<double>> stateAt(const QPointF& at) const;

  Geometry geometry() const;
  Geometry besideEachOther() const;
  Geometry belowEachOther() const;
  QRectF areaOf(const QRectF& square) const;
  QString title() const;
  void drawAxes(QPainter& painter, const Geometry& geometry, const Theme& theme) const;
  /// Whether values lie on both sides of the threshold; only then a contour is drawn.
  bool thresholdCuts() const;
  void drawLimitNote(QPainter& painter, const Geometry& geometry, const Theme& theme) const;
  void drawThresholdNote(QPainter& painter, const Geometry& geometry, const Theme& theme) const;
  void drawTitles(QPainter& painter, const Geometry& geometry, const Theme& theme) const;
  void drawNumbers(QPainter& painter, const QRectF& map, const Theme& theme, bool horizontal) const;
  void drawBigBar(QPainter& painter, const Geometry& geometry, const Theme& theme) const;
  void drawSmallMaps(QPainter& painter, const Geometry& geometry, const Theme& theme) const;
  void drawKey(QPainter& painter, const Geometry& geometry, const Theme& theme) const;
  void drawFootprints(QPainter& painter, const Geometry& geometry, const Theme& theme) const;
  void drawReading(QPainter& painter, const Geometry& geometry, const Theme& theme) const;
  MapMarks marks(double ring) const;

  RunningLife& life_;
  Looking& looking_;
  MapChoice choice_;
  ValueMap big_, upper_, lower_, best_, risk_;
  std::unique_ptr<Policy> policy_;  // the one in force: what is greedy, and which risk it allows
  std::vector<double> drawn_;       // the live state, as it was drawn last
  QElapsedTimer sinceDrawn_;
  MapScale bigScale_, visitScale_{MapScale::Kind::Viridis, 1, 10}, eligibilityScale_{MapScale::Kind::Positive, 0, 1},
      riskScale_{MapScale::Kind::Risk, 0, 1};
  MapSlice slice_;
  bool any_ = false;
};

}  // namespace surefoot
