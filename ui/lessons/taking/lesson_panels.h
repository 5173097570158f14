// SPDX-License-Identifier: GPL-3.0-or-later
// The panels that a step shows, beside its column: the world above, the others below it. Panels are made when they are
// first shown; what a step does not show is hidden, not greyed.
#pragma once

#include <QWidget>
#include <map>
#include <string>

#include "ui/live/charts/learning_charts.h"

class QSplitter;

namespace surefoot {

class ChartSpan;
class LessonDriver;
class PanelHeader;
class PanelRow;
struct LessonLives;
class WorldView;

class LessonPanels final : public QWidget {
  Q_OBJECT

 public:
  explicit LessonPanels(LessonDriver& driver, QWidget* parent = nullptr);
  /// ◇ on one of the charts, "falls" or "reward"; on none of the others.
  void setPrediction(const std::string& chart, const std::optional<ChartPrediction>& prediction);
  /// Words beside the numbers of the curves, by the numbers of their lives: "ε 0.05".
  void setRunWords(const std::function<QString(const RunCurve&)>& words);
  ChartSpan& span() { return *span_; }
  /// The first panel, for the focus; nullptr: none is shown.
  QWidget* first() const;

 Q_SIGNALS:
  void predictionMoved(double value);
  void refused(const QString& sentence);

 private:
  struct Part {
    QWidget* box;  ///< header and content
    QWidget* content;
    PanelHeader* header;
  };
  void showStep();
  Part& part(const std::string& name);
  Part make(const std::string& name);
  /// `name`: of the panel; empty: it is none of the Live page's.
  Part wrap(const QString& title, const QString& note, QWidget* content, const std::string& name = {});
  QWidget* makeContent(const std::string& name, QString& title, QString& note);
  void makeMaps(Part& part);
  QWidget* makeLives(const LessonLives& lives);
  void toggleFull(QWidget* box);
  void noteWorld();

  LessonDriver& driver_;
  ChartSpan* span_;
  QSplitter* rows_;
  PanelRow* below_;
  std::map<std::string, Part> parts_;
  QWidget *lives_ = nullptr, *full_ = nullptr;
  std::function<QString(const RunCurve&)> words_;
};

}  // namespace surefoot
