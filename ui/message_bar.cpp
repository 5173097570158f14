// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/message_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "ui/theme.h"

namespace surefoot {

MessageBar::MessageBar(QWidget* parent)
    : QWidget(parent),
      text_(new QLabel),
      answer_(new QPushButton),
      dismiss_(new QPushButton(tr("Dismiss"))) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(15, 4, 12, 5);
  row->setSpacing(8);
  text_->setWordWrap(true);
  row->addWidget(text_, 1);
  row->addWidget(answer_);
  row->addWidget(dismiss_);
  connect(answer_, &QPushButton::clicked, this, [this] {
    const auto then = std::move(then_);
    dismiss();
    if (then) then();
  });
  connect(dismiss_, &QPushButton::clicked, this, &MessageBar::dismiss);
  parent->installEventFilter(this);
  hide();
}

void MessageBar::place() {
  setGeometry(0, kTop, parentWidget()->width(), std::max(36, sizeHint().height()));
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QWidget::eventFilter(watched, event);
}

void MessageBar::say(const QString& sentence) {
  text_->setText(sentence);
  setAccessibleName(sentence);
  answer_->hide();
  dismiss_->setText(tr("Dismiss"));
  place();
  show();
  raise();
}

void MessageBar::ask(const QString& sentence, const QString& answer, std::function<void()> then) {
  say(sentence);
  then_ = std::move(then);
  answer_->setText(answer);
  answer_->show();
  dismiss_->setText(tr("Cancel"));
}

void MessageBar::dismiss() {
  then_ = nullptr;
  hide();
}

void MessageBar::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  QPainter p(this);
  p.fillRect(rect(), t.fill);
  p.fillRect(QRect(0, 0, 3, height()), t.caution);
  p.fillRect(QRect(0, height() - 1, width(), 1), t.hairline);
}

}  // namespace surefoot
