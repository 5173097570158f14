// SPDX-License-Identifier: GPL-3.0-or-later
// A line below a page's toolbar that says what the page shows ("Following results.sqlite, read only"), with words to
// click at its right end. Hidden while it has nothing to say.
#pragma once

#include <functional>

#include "ui/style/painted.h"

class QHBoxLayout;
class QLabel;

namespace surefoot {

class LinkButton;

class NoticeStrip final : public Painted<> {
  Q_OBJECT

 public:
  explicit NoticeStrip(QWidget* parent = nullptr);
  /// An empty head hides it. `warns`: what it says is no good news.
  void say(const QString& head, const QString& text, bool warns = false);
  /// Everything that it says.
  QString said() const;
  LinkButton* addLink(const QString& text, const QString& tip, std::function<void()> then);

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  QHBoxLayout* row_;
  QLabel *head_, *text_;
  bool warns_ = false;
};

}  // namespace surefoot
