// SPDX-License-Identifier: GPL-3.0-or-later
// The text of a step: Markdown without HTML, pictures or addresses outside. It is as high as its text.
#pragma once

#include <QTextBrowser>

class QTextBlock;

namespace surefoot {

class MarkdownView final : public QTextBrowser {
  Q_OBJECT

 public:
  explicit MarkdownView(QWidget* parent = nullptr);
  void show(const QString& markdown);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 Q_SIGNALS:
  /// A link to a lesson: its name.
  void lessonAsked(const QString& name);

 protected:
  /// Nothing is fetched, whatever the text names.
  QVariant loadResource(int, const QUrl&) override { return {}; }
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
  void changeEvent(QEvent* event) override;

 private:
  void style();
  void stress(const QTextBlock& block);
  QString markdown_;
};

}  // namespace surefoot
