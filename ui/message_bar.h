// SPDX-License-Identifier: GPL-3.0-or-later
// One sentence at the foot of the panels, with what can be done about it. No dialog boxes; nothing below it moves.
#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <array>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace surefoot {

class MessageBar final : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kStatusLine = 24;  ///< [px] below it
  /// Lies over the foot of its parent, as wide as it is, where it covers the fewest things that one works with.
  explicit MessageBar(QWidget* parent);
  /// Shows a sentence with only Dismiss.
  void say(const QString& sentence);
  /// The same for good news, which goes away by itself.
  void tell(const QString& sentence);
  /// A button that answers a question, and what it does.
  struct Answer {
    QString text;
    std::function<void()> then;
  };
  /// Shows a question with one or two answers; it takes the focus, and Escape is Cancel.
  void ask(const QString& sentence, std::vector<Answer> answers);
  void dismiss();
  /// Unless it is a question.
  void dismissRemark();

 protected:
  void paintEvent(QPaintEvent*) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void place();

  QPointer<QWidget> before_;  // had the focus before a question took it
  QLabel* text_;
  std::array<QPushButton*, 2> answers_;
  QPushButton* dismiss_;
  QTimer leaving_;
  bool good_ = false;
  std::array<std::function<void()>, 2> then_;
};

}  // namespace surefoot
