// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/message_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSet>

#include "ui/style/scale.h"
#include "ui/style/theme.h"
#include "ui/support/plain_text.h"

namespace surefoot {

MessageRow::MessageRow(QWidget* parent) : QWidget(parent), row_(new QHBoxLayout(this)), text_(new QLabel) {
  whenScaled(this, [this] {
    row_->setContentsMargins(scaled({15, 4, 12, 5}));
    row_->setSpacing(scaled(8));
  });
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  row_->addWidget(text_, 1);
}

QString MessageRow::sentence() const {
  return text_->text();
}

void MessageRow::setSentence(const QString& sentence) {
  text_->setText(sentence);
  setAccessibleName(sentence);
  shown_.start();
}

/// Alt and the first letter of the text that neither the menu bar nor an answer in the message bar uses.
QKeySequence MessageRow::freeKey(const QString& text) const {
  QSet<QKeySequence> taken;
  for (const char menu : {'F', 'E', 'V', 'R', 'X', 'H'}) taken << QKeySequence(Qt::ALT | static_cast<Qt::Key>(menu));
  for (const QPushButton* other : parentWidget()->findChildren<QPushButton*>())
    if (other->isVisibleTo(parentWidget())) taken << other->shortcut();
  for (const QChar c : text.toUpper()) {
    const QKeySequence key(Qt::ALT | static_cast<Qt::Key>(c.unicode()));
    if (c >= 'A' && c <= 'Z' && !taken.contains(key)) return key;
  }
  return {};
}

void MessageRow::addButton(const QString& text, std::function<void()> then, bool withKey) {
  auto* button = new QPushButton(text);
  button->setAccessibleName(text);
  button->setAutoDefault(false);
  if (withKey) button->setShortcut(freeKey(text));
  button->setToolTip(tipText(button->shortcut().toString(QKeySequence::NativeText)));
  button->setFocusPolicy(Qt::TabFocus);  // a click leaves the focus where the person was
  row_->addWidget(button);
  connect(button, &QPushButton::clicked, this, [then = std::move(then)] { then(); });
}

void MessageRow::setGood(bool good) {
  good_ = good;
  update();
}

void MessageRow::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  QPainter p(this);
  p.fillRect(rect(), t.fill);
  p.fillRect(QRect(0, 0, scaled(3), height()), good_ ? t.outline : t.caution);
  p.fillRect(QRect(0, 0, width(), 1), t.hairline);
}

}  // namespace surefoot

#include "moc_message_row.cpp"
