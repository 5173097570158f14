// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/notice_strip.h"

#include <QHBoxLayout>
#include <QLabel>

#include "ui/controls/labels.h"
#include "ui/controls/link_button.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"
#include "ui/support/plain_text.h"

namespace surefoot {

NoticeStrip::NoticeStrip(QWidget* parent)
    : Painted(parent),
      row_(new QHBoxLayout(this)),
      head_(makeText({}, 13, 500, false, this)),
      text_(new OneLine(13, this)) {
  row_->addWidget(head_);
  row_->addWidget(text_, 1);
  whenScaled(this, [this] {
    row_->setContentsMargins(scaled({15, 0, 12, 0}));
    row_->setSpacing(scaled(12));
    setFixedHeight(scaled(32));
  });
  hide();
}

void NoticeStrip::say(const QString& head, const QString& text, bool warns) {
  setVisible(!head.isEmpty());
  if (head_->text() != head) head_->setText(head);
  if (text_->text() != text) {
    text_->setText(text);
    text_->setToolTip(tipText(text));
  }
  setAccessibleName(said());
  if (std::exchange(warns_, warns) != warns) update();
}

QString NoticeStrip::said() const {
  return head_->text() + ' ' + text_->text();
}

LinkButton* NoticeStrip::addLink(const QString& text, const QString& tip, std::function<void()> then) {
  auto* link = new LinkButton(text);
  link->setToolTip(tipText(tip));
  row_->addWidget(link);
  connect(link, &QToolButton::clicked, this, [then = std::move(then)] { then(); });
  return link;
}

void NoticeStrip::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  QPainter p(this);
  p.fillRect(QWidget::rect(), t.panel);
  p.fillRect(QRect(0, 0, scaled(3), QWidget::height()), warns_ ? t.caution : t.ink);
  p.fillRect(QRect(0, QWidget::height() - 1, QWidget::width(), 1), t.hairline);
}

}  // namespace surefoot

#include "moc_notice_strip.cpp"
