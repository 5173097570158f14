// SPDX-License-Identifier: GPL-3.0-or-later
// All steps are done: what one knows now, own words beside the model answers, and where to go on.
#pragma once

#include <QWidget>

class QVBoxLayout;

namespace surefoot {

class LessonDriver;

class LessonEnd final : public QWidget {
  Q_OBJECT

 public:
  /// `name` and `title` of the lesson after this one; empty: there is none.
  LessonEnd(const LessonDriver& driver, const QString& name, const QString& title, QWidget* parent);

 Q_SIGNALS:
  void lessonAsked(const QString& name);
  void allLessonsAsked();

 private:
  void add(const QString& head, const std::string& text);
  void addLine();
  QVBoxLayout* column_;
};

}  // namespace surefoot
