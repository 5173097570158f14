// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/message_bar.h"

#include <QApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QVBoxLayout>

#include "ui/controls/message_row.h"
#include "ui/style/theme.h"

namespace surefoot {

MessageBar::MessageBar(QWidget* parent) : QWidget(parent), rows_(new QVBoxLayout(this)), remark_(new MessageRow(this)) {
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(0);
  remark_->addButton(
      tr("Dismiss"), [this] { dismissRemark(); }, false);
  remark_->hide();
  rows_->addWidget(remark_);
  leaving_.setSingleShot(true);
  connect(&leaving_, &QTimer::timeout, this, &MessageBar::dismissRemark);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget* old, QWidget* now) {
    if (now && isAncestorOf(now) && old && !isAncestorOf(old)) before_ = old;
  });
  hide();
}

void MessageBar::say(const QString& sentence) {
  leaving_.stop();
  remark_->setGood(false);
  remark_->setSentence(sentence);
  remark_->show();
  refresh();
}

void MessageBar::tell(const QString& sentence) {
  constexpr int kStays = 8000, kSameMoment = 500;  // [ms]
  const bool goesOn = !remark_->isHidden() && remark_->age() < kSameMoment;
  const bool said = goesOn && !leaving_.isActive();
  say(goesOn && sentence != remark_->sentence() ? remark_->sentence() + ' ' + sentence : sentence);
  if (said) return;  // it would go away before it is read
  remark_->setGood(true);
  leaving_.start(kStays);
}

void MessageBar::ask(const QString& sentence, std::vector<Answer> answers, Question kind) {
  remove(kind);
  auto* row = new MessageRow(this);
  row->setSentence(sentence);
  for (Answer& answer : answers)
    row->addButton(answer.text, [this, kind, then = std::move(answer.then)] {
      const auto afterwards = then;  // it goes with its row
      remove(kind);
      refresh();
      if (afterwards) afterwards();
    });
  if (kind == Question::Passing || kind == Question::Quit)
    row->addButton(tr("Cancel"), [this, kind] {
      remove(kind);
      refresh();
    });
  questions_[kind] = row;
  rows_->addWidget(row);
  row->show();
  refresh();
}

void MessageBar::remove(Question kind) {
  const auto found = questions_.find(kind);
  if (found == questions_.end()) return;
  MessageRow* row = found->second;
  questions_.erase(found);
  if (row->isAncestorOf(QApplication::focusWidget()) && before_) before_->setFocus();
  rows_->removeWidget(row);
  row->hide();
  row->deleteLater();
}

void MessageBar::refresh() {
  QStringList sentences;
  if (!remark_->isHidden()) sentences << remark_->sentence();
  for (const auto& [kind, row] : questions_) sentences << row->sentence();
  setAccessibleName(sentences.join(' '));
  const bool hadFocus = isAncestorOf(QApplication::focusWidget());
  if (sentences.isEmpty() && hadFocus && before_) before_->setFocus();
  setVisible(!sentences.isEmpty());
  if (sentences.isEmpty()) return;
  rows_->invalidate();
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
  if (event->key() != Qt::Key_Escape) return QWidget::keyPressEvent(event);
  dismissRemark();
  cancel();
  if (isAncestorOf(QApplication::focusWidget()) && before_) before_->setFocus();
}

bool MessageBar::cancel() {
  for (const Question kind : {Question::Passing, Question::Quit}) {
    if (!asks(kind)) continue;
    remove(kind);
    refresh();
    return true;
  }
  return false;
}

void MessageBar::dismissRemark() {
  leaving_.stop();
  if (remark_->isAncestorOf(QApplication::focusWidget()) && before_) before_->setFocus();
  remark_->hide();
  refresh();
}

void MessageBar::dismiss() {
  remove(Question::Passing);
  dismissRemark();
}

void MessageBar::paintEvent(QPaintEvent*) {
  QPainter(this).fillRect(rect(), themeOf(*this).fill);
}

}  // namespace surefoot

#include "moc_message_bar.cpp"
