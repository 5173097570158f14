// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson as text, checked while it is typed, with a preview of the step under the caret.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/lessons/lesson_check.h"
#include "ui/support/background.h"

class QLabel;
class QPlainTextEdit;
class QVBoxLayout;

namespace surefoot {

class MarkdownView;
class TextButton;

class LessonEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit LessonEditor(const Registry& registry, QWidget* parent = nullptr);
  /// Shows a text; `path` is its file, empty: it has none yet.
  void edit(const QString& text, const QString& path);
  QString text() const;
  const QString& path() const { return path_; }
  bool hasEdits() const;
  /// What is wrong with the text now, checked; empty: nothing.
  const std::vector<Complaint>& complaints() const { return complaints_; }
  /// The lesson of the last text without an error.
  const std::optional<Lesson>& lesson() const { return lesson_; }
  void save();
  void saveAs();

 Q_SIGNALS:
  void checked();
  void tryAsked();
  void closeAsked();
  void saved(const QString& path);
  void refused(const QString& sentence);

 private:
  QWidget* makeBar();
  void check();
  void liveThrough();
  void showComplaints();
  void showStep();
  void goToFirst();
  void writeTo(const QString& path);
  int stepAtCaret() const;

  const Registry& registry_;
  QString path_, saved_;
  QPlainTextEdit* edit_;
  QLabel *name_, *verdict_, *where_, *kind_, *question_;
  MarkdownView* say_;
  TextButton *try_ = nullptr, *live_ = nullptr;
  std::vector<Complaint> complaints_;
  std::optional<Lesson> lesson_;
  std::vector<ToldStep> told_;
  Background checking_;
};

}  // namespace surefoot
