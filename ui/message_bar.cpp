// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/message_bar.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "ui/theme.h"

namespace surefoot {

MessageBar::MessageBar(QWidget* parent)
    : QWidget(parent),
      text_(new QLabel),
      answers_{new QPushButton, new QPushButton},
      dismiss_(new QPushButton(tr("Dismiss"))) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(15, 4, 12, 5);
  row->setSpacing(8);
  text_->setTextFormat(Qt::PlainText);
  text_->setWordWrap(true);
  row->addWidget(text_, 1);
  for (std::size_t i = 0; i < answers_.size(); ++i) {
    row->addWidget(answers_[i]);
    connect(answers_[i], &QPushButton::clicked, this, [this, i] {
      const auto then = std::move(then_[i]);
      dismiss();
      if (then) then();
    });
  }
  row->addWidget(dismiss_);
  connect(dismiss_, &QPushButton::clicked, this, &MessageBar::dismiss);
  leaving_.setSingleShot(true);
  connect(&leaving_, &QTimer::timeout, this, &MessageBar::dismiss);
  parent->installEventFilter(this);
  hide();
}

void MessageBar::place() {
  const int h = std::max(36, sizeHint().height());
  setGeometry(0, parentWidget()->height() - kStatusLine - h, parentWidget()->width(), h);
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QWidget::eventFilter(watched, event);
}

void MessageBar::tell(const QString& sentence) {
  constexpr int kStays = 8000;  // [ms]
  say(sentence);
  good_ = true;
  leaving_.start(kStays);
}

void MessageBar::say(const QString& sentence) {
  leaving_.stop();
  good_ = false;
  text_->setText(sentence);
  setAccessibleName(sentence);
  for (QPushButton* answer : answers_) answer->hide();
  then_ = {};
  dismiss_->setText(tr("Dismiss"));
  dismiss_->setAccessibleName(dismiss_->text());
  place();
  show();
  raise();
}

void MessageBar::ask(const QString& sentence, std::vector<Answer> answers) {
  say(sentence);
  for (std::size_t i = 0; i < std::min(answers.size(), answers_.size()); ++i) {
    then_[i] = std::move(answers[i].then);
    answers_[i]->setText(answers[i].text);
    answers_[i]->setAccessibleName(answers[i].text);
    answers_[i]->show();
  }
  dismiss_->setText(tr("Cancel"));
  dismiss_->setAccessibleName(dismiss_->text());
  before_ = QApplication::focusWidget();
  answers_[0]->setFocus(Qt::OtherFocusReason);
}

// Escape, wherever in the bar the focus is, before it is anyone's shortcut.
bool MessageBar::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

void MessageBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return dismiss();
  QWidget::keyPressEvent(event);
}

void MessageBar::dismissRemark() {
  if (!then_[0]) dismiss();
}

void MessageBar::dismiss() {
  then_ = {};
  const bool hadFocus = isAncestorOf(QApplication::focusWidget());
  if (hadFocus && before_) before_->setFocus();
  before_ = nullptr;
  hide();
}

void MessageBar::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  QPainter p(this);
  p.fillRect(rect(), t.fill);
  p.fillRect(QRect(0, 0, 3, height()), good_ ? t.outline : t.caution);
  p.fillRect(QRect(0, 0, width(), 1), t.hairline);
}

}  // namespace surefoot
