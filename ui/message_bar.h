// SPDX-License-Identifier: GPL-3.0-or-later
// One sentence over the panels, with what can be done about it. No dialog boxes; nothing below it moves.
#pragma once

#include <QWidget>
#include <functional>

class QLabel;
class QPushButton;

namespace surefoot {

class MessageBar final : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kTop = 48;  ///< below the toolbar
  /// Lies over its parent, as wide as it is.
  explicit MessageBar(QWidget* parent);
  /// Shows a sentence with only Dismiss.
  void say(const QString& sentence);
  /// Shows a question; `answer` is the text of the button that calls `then`.
  void ask(const QString& sentence, const QString& answer, std::function<void()> then);
  void dismiss();

 protected:
  void paintEvent(QPaintEvent*) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  QLabel* text_;
  QPushButton *answer_, *dismiss_;
  std::function<void()> then_;
};

}  // namespace surefoot
