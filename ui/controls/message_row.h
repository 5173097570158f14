// SPDX-License-Identifier: GPL-3.0-or-later
// One line of the message bar: a sentence and its buttons.
#pragma once

#include <QElapsedTimer>
#include <QKeySequence>
#include <QWidget>
#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;

namespace surefoot {

class MessageRow final : public QWidget {
  Q_OBJECT

 public:
  explicit MessageRow(QWidget* parent);
  QString sentence() const;
  void setSentence(const QString& sentence);
  /// A button at the right end. Only its own key (Alt and a letter) presses it, unless Tab gave it the focus.
  void addButton(const QString& text, std::function<void()> then, bool withKey = true);
  /// Good news has a quiet stripe.
  void setGood(bool good);
  /// The time since its sentence was set [ms].
  qint64 age() const { return shown_.isValid() ? shown_.elapsed() : 0; }

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  QHBoxLayout* row_;
  QLabel* text_;
  QKeySequence freeKey(const QString& text) const;

  QElapsedTimer shown_;
  bool good_ = false;
};

}  // namespace surefoot
