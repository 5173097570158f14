// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/support/keyboard.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QPainter>
#include <QToolButton>

#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

bool isOneOf(int key, std::initializer_list<int> keys) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

bool isPress(const QKeyEvent& event) {
  return isOneOf(event.key(), {Qt::Key_Space, Qt::Key_Return, Qt::Key_Enter});
}

bool isArrow(const QKeyEvent& event) {
  return isOneOf(event.key(), {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down});
}

/// A button, a choice or a menu's button does what a click does.
bool press(QWidget& widget) {
  if (auto* choice = qobject_cast<QComboBox*>(&widget); choice && !choice->isEditable())
    choice->showPopup();
  else if (auto* tool = qobject_cast<QToolButton*>(&widget); tool && tool->menu())
    tool->showMenu();
  else if (auto* button = qobject_cast<QAbstractButton*>(&widget))
    button->click();
  else
    return false;
  return true;
}

}  // namespace

Keyboard::Keyboard(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool usesKey(const QWidget& widget, const QKeyEvent& event) {
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) return false;
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  if (button) return isPress(event) || (button->autoExclusive() && isArrow(event));
  if (qobject_cast<const QComboBox*>(&widget))
    return isPress(event) || isOneOf(event.key(), {Qt::Key_Up, Qt::Key_Down});
  const bool ends = isOneOf(event.key(), {Qt::Key_Home, Qt::Key_End});
  if (qobject_cast<const QAbstractSlider*>(&widget)) return isArrow(event) || ends;
  if (qobject_cast<const QAbstractItemView*>(&widget)) {
    if (widget.property(kRowsOnly).toBool() && isOneOf(event.key(), {Qt::Key_Left, Qt::Key_Right})) return false;
    return isArrow(event) || isPress(event) || ends;
  }
  return false;
}

bool Keyboard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
  auto* widget = qobject_cast<QWidget*>(watched);
  if (!widget || widget != QApplication::focusWidget() || QApplication::activePopupWidget()) return false;
  auto& key = static_cast<QKeyEvent&>(*event);
  if (!usesKey(*widget, key)) return false;
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  const auto* choice = qobject_cast<QComboBox*>(widget);
  const bool opens = choice && isOneOf(key.key(), {Qt::Key_Up, Qt::Key_Down});
  return !key.isAutoRepeat() && (isPress(key) || opens) && press(*widget);
}

void drawFocusRing(QPainter& painter, const QWidget& widget) {
  if (!widget.hasFocus()) return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(themeOf(widget).accent, 2));
  painter.setBrush(Qt::NoBrush);
  const QRectF edge(QPointF(), QSizeF(widget.size()) / textSize());  // by a ScaledPainter
  painter.drawRect(edge.adjusted(1, 1, -1, -1));
}

}  // namespace surefoot

#include "moc_keyboard.cpp"
