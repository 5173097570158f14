// SPDX-License-Identifier: GPL-3.0-or-later
// "What the robot would do now": one row per action, with its value and its probability under the three policies side
// by side (the thesis's Figure 4.1, live). The threshold of TRL is a line to drag. Where the risk of a fall is learned
// it stands between them; the limit of the policy's caution is another such line, and a sentence says what it leaves
// out. If an action is a combination, there is one column per action variable, with one row per level.
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/policy.h"
#include "ui/style/painted.h"
#include "ui/support/exporting.h"

class QPainter;

namespace surefoot {

class Editing;
class Looking;
class RunningLife;
struct Theme;

class ActionRows final : public Painted<>, public CsvSource {
  Q_OBJECT

 public:
  explicit ActionRows(RunningLife& life, Looking& looking, Editing& editing, QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({576, 240}); }
  QSize minimumSizeHint() const override { return scaled({400, 190}); }
  /// Probabilities of these policies and of the one in force; empty: of all.
  void setPolicies(std::set<std::string> policies);
  /// One row per action: its value, the parts of the value, its probability under each policy.
  std::string asCsv() const override;
  /// Least and greatest value on the scale of Q.
  std::pair<double, double> scaleOfQ() const { return {low_, high_}; }
  /// Right end of the scale of Q, and left end of its numbers [px]; they do not overlap.
  std::pair<double, double> scaleAndNumbers() const;
  /// What caution does with the action that is worth most, in a sentence; empty: nothing.
  QString sentence() const;

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
    std::vector<double> worth;  // what it chooses by; −∞: not allowed
  };
  /// A level of an action variable.
  struct Level {
    std::vector<double> chance;  // under each policy
    double best = 0.0;           // the highest value of an action with this level
  };
  /// The positions of all parts; they depend on the size, on the texts and on their widths.
  struct Geometry {
    double top, row, bottom;                 // first row, height of a row, below the last
    double label;                            // right end of the actions' values
    double qLeft, qRight, qNumber;           // scale of Q, right end of its number
    double riskLeft, riskRight, riskNumber;  // scale of the risk, right end of its number; 0: there is none
    double first, pitch, bar, number;        // columns of the policies: left ends, bar length, right end of the number
    std::vector<std::size_t> columns;        // the columns that have room
    bool below;                              // "in force" stands below the policy's name
  };
  struct LevelPlace {
    double left, bar, percent, best, middle, row;
  };

  void rebuild();
  void nextFrame();
  void takeValues();
  void fitScale();
  void sumLevels();
  bool inForce(std::size_t column) const;
  static QString valueText(double q);
  QFont rowFont(double row, int weight) const;
  void drawLevels(QPainter& p, const Theme& t) const;
  void drawLevelsOf(QPainter& p, const Theme& t, std::size_t variable, double left, double pitch) const;
  void drawLevelScale(QPainter& p, const Theme& t, const LevelPlace& at, double bottom) const;
  void drawLevelBars(QPainter& p, const Theme& t, const Level& level, const LevelPlace& at) const;
  void drawLevelNumbers(QPainter& p, const Theme& t, const Level& level, bool chosen, const LevelPlace& at) const;
  Geometry geometry() const;
  double xOf(double value, const Geometry& g) const;
  bool onScale(double value) const { return value >= low_ && value <= high_; }
  void drawHead(QPainter& p, const Theme& t, const Geometry& g) const;
  void drawBars(QPainter& p, const Theme& t, const Geometry& g, std::size_t action) const;
  void drawNumbers(QPainter& p, const Theme& t, const Geometry& g, std::size_t action) const;
  void drawScales(QPainter& p, const Theme& t, const Geometry& g) const;
  void drawThreshold(QPainter& p, const Theme& t, const Geometry& g) const;
  bool onThreshold(const QPointF& at) const;

  // The risk (action_rows_risk.cpp).
  bool riskIsYoung() const;
  QString sentenceOfSeveral(const std::vector<std::size_t>& out) const;
  QString sentenceOfMany(std::optional<double> limit) const;
  void drawSentence(QPainter& p, const Theme& t, double top) const;
  std::optional<double> riskLimit() const;
  double foot() const;
  double xOfRisk(double risk, const Geometry& g) const;
  void drawRisk(QPainter& p, const Theme& t, const Geometry& g) const;
  void drawRiskScale(QPainter& p, const Theme& t, const Geometry& g) const;
  void drawRiskLimit(QPainter& p, const Theme& t, const Geometry& g) const;
  bool onRiskLimit(const QPointF& at) const;
  void dragRiskLimit(double x);

  RunningLife& life_;
  Looking& looking_;
  Editing& editing_;
  std::set<std::string> policies_;  // with a column
  std::vector<Column> columns_;
  std::vector<double> q_, positive_, negative_, risk_;  // what the agent does not learn is empty
  std::vector<std::vector<Level>> levels_;              // [action variable][level]; empty: an action is one number
  Action chosen_ = kNoAction;
  double numberWidth_ = 0;          // the widest number of Q so far, in the usual size of text [px]
  double low_ = -100, high_ = 200;  // scale of Q
  double share_ = 0;                // share of the task's range of returns that the scale shows
  bool dragging_ = false;
  bool draggingLimit_ = false;
  QElapsedTimer sinceUpdate_;
};

}  // namespace surefoot
