// SPDX-License-Identifier: GPL-3.0-or-later
// Above a lesson: run, restart, turbo and pace, as far as the step shows them, and how often it fell.
#pragma once

#include <QWidget>
#include <functional>

class QAction;
class QHBoxLayout;
class QLabel;

namespace surefoot {

class BarButton;
class LessonDriver;
class Slider;

class LessonBar final : public QWidget {
  Q_OBJECT

 public:
  LessonBar(LessonDriver& driver, QWidget* parent);
  /// Those of the lesson that have keys of their own: Run, Restart, Turbo.
  QList<QAction*> keyActions() const { return {run_, restart_, turbo_}; }
  void refresh();

 Q_SIGNALS:
  void allLessonsAsked();
  void teacherAsked();
  void refused(const QString& sentence);

 private:
  void makeActions();
  void addButtons(QHBoxLayout& row);
  void addPace(QHBoxLayout& row);
  void addCounts(QHBoxLayout& row);

  LessonDriver& driver_;
  QAction *run_, *restart_, *turbo_;
  BarButton* runButton_ = nullptr;
  std::vector<std::pair<std::string, QWidget*>> parts_;  // by the words of the step's `show`
  QLabel *falls_ = nullptr, *episodes_ = nullptr, *minutes_ = nullptr;
};

}  // namespace surefoot
