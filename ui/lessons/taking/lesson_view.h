// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson being taken: its toolbar, its column and the panels of the step.
#pragma once

#include <QWidget>

#include "ui/lessons/taking/lesson_driver.h"
#include "ui/style/painted.h"

class QAction;
class QLabel;

namespace surefoot {

class BarButton;
class LessonColumn;
class LessonPanels;
class Slider;

class LessonView final : public QWidget {
  Q_OBJECT

 public:
  LessonView(const Registry& registry, Lesson lesson, HandIn handIn, QWidget* parent = nullptr);
  ~LessonView() override;
  static constexpr double kMostColumn = 0.45;  ///< of the width, for the column
  LessonDriver& driver() { return *driver_; }
  /// Begins, or goes on, with a step.
  void begin(std::size_t step);
  void focusHome();
  void showHint();
  /// The lesson after this one, for its end; empty: none.
  void setNext(const QString& name, const QString& title);

 Q_SIGNALS:
  void allLessonsAsked();
  void exploreAsked();
  void teacherAsked();
  void lessonAsked(const QString& name);
  void refused(const QString& sentence);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeBar();
  void makeActions();
  QAction* act(const QString& text, const QList<QKeySequence>& keys, const std::function<void()>& what);
  void refresh();
  void refreshPrediction();
  void nameRun();
  void showLastFall();
  QString knobWords() const;
  bool hasSeveralRules() const;

  std::unique_ptr<LessonDriver> driver_;
  QAction *run_, *restart_, *turbo_;
  std::vector<QWidget*> runButtons_;
  QLabel *falls_, *episodes_, *paceWord_;
  Slider* pace_;
  LessonColumn* column_;
  LessonPanels* panels_;
  std::map<int, QString> runWords_;     // by the numbers of lives
  std::map<int, std::size_t> namedIn_;  // the steps in which they were named
};

}  // namespace surefoot
