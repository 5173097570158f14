// SPDX-License-Identifier: GPL-3.0-or-later
// What the robot would do now: a row an action, with its value and its probability under the three policies side by
// side (the thesis's Figure 4.1, live). The threshold of TRL is a line to drag. Where an action is a combination, a
// column a variable of it, with a row a level.
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <memory>
#include <vector>

#include "core/policy.h"
#include "ui/exporting.h"

class QPainter;

namespace surefoot {

class Session;
struct Theme;

class ActionRows final : public QWidget, public CsvSource {
  Q_OBJECT

 public:
  explicit ActionRows(Session& session, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {576, 240}; }
  QSize minimumSizeHint() const override { return {480, 200}; }
  /// A row an action: its value, the parts of it, its probability under each policy.
  std::string asCsv() const override;

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  struct Column {
    std::string name;
    QString title;
    std::unique_ptr<Policy> policy;
    std::vector<double> pi;
  };
  /// Where things stand; depends on the size only.
  struct Geometry {
    double top, row, bottom;           // first row, height of a row, below the last
    double label;                      // right end of the actions' values
    double qLeft, qRight, qNumber;     // scale of Q, right end of its number
    double first, pitch, bar, number;  // columns of the policies: left ends, bar length, right end of the number
  };

  /// A level of an action variable.
  struct Level {
    std::vector<double> chance;  // under each policy
    double best = 0.0;           // the highest value of an action that has it
  };
  struct LevelPlace {
    double left, bar, percent, best, middle, row;
  };

  void rebuild();
  void nextFrame();
  void takeValues();
  void sumLevels();
  void drawLevels(QPainter& p, const Theme& t) const;
  void drawPolicyKey(QPainter& p, const Theme& t) const;
  void drawLevelsOf(QPainter& p, const Theme& t, std::size_t variable, double left, double pitch) const;
  void drawLevel(QPainter& p, const Theme& t, const Level& level, bool chosen, const LevelPlace& at) const;
  Geometry geometry() const;
  double xOf(double value, const Geometry& g) const;
  void drawHead(QPainter& p, const Theme& t, const Geometry& g) const;
  void drawRow(QPainter& p, const Theme& t, const Geometry& g, std::size_t action) const;
  void drawScales(QPainter& p, const Theme& t, const Geometry& g) const;
  void drawThreshold(QPainter& p, const Theme& t, const Geometry& g) const;
  bool onThreshold(const QPointF& at) const;

  Session& session_;
  std::vector<Column> columns_;
  std::vector<double> q_, positive_, negative_;  // the parts are empty where the agent keeps one estimate
  std::vector<std::vector<Level>> levels_;       // [action variable][level]; empty: an action is one number
  Action chosen_ = kNoAction;
  double low_ = -100, high_ = 200;  // scale of Q
  bool dragging_ = false;
  QElapsedTimer sinceUpdate_;
};

}  // namespace surefoot
