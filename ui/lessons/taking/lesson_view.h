// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson being taken: its toolbar, its column and the panels of the step.
#pragma once

#include <QWidget>

#include "ui/lessons/driver/lesson_driver.h"
#include "ui/lessons/taking/curve_names.h"

namespace surefoot {

class LessonBar;
class LessonColumn;
class LessonPanels;

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
  void makeActions();
  void refresh();
  void refreshPrediction();
  std::optional<double> timeOf(const LessonPrediction& prediction, std::size_t step) const;
  void showLastFall();

  std::unique_ptr<LessonDriver> driver_;
  CurveNames names_;
  LessonBar* bar_;
  LessonColumn* column_;
  LessonPanels* panels_;
};

}  // namespace surefoot
