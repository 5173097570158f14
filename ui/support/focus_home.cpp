// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/support/focus_home.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QShortcut>

namespace surefoot {

namespace {

/// Whether a widget would keep the window's keys, but does not use Escape itself.
bool keepsKeys(const QWidget& widget) {
  return qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QAbstractSpinBox*>(&widget) ||
         qobject_cast<const QPlainTextEdit*>(&widget) || qobject_cast<const QComboBox*>(&widget) ||
         qobject_cast<const QAbstractSlider*>(&widget) || qobject_cast<const QAbstractButton*>(&widget);
}

/// Whether a widget does something of its own with Escape.
bool usesEscape(const QWidget& widget) {
  for (const QShortcut* shortcut : widget.findChildren<QShortcut*>(QString(), Qt::FindDirectChildrenOnly))
    if (shortcut->key() == QKeySequence(Qt::Key_Escape)) return true;
  return false;
}

/// A question has its own Escape: it is Cancel.
bool isInQuestion(const QWidget& widget) {
  for (const QWidget* w = &widget; w; w = w->parentWidget())
    if (w->inherits("surefoot::MessageBar")) return true;
  return false;
}

/// Restores the text from before the typing.
void takeBack(QLineEdit& field) {
  if (!field.isModified()) return;
  while (field.isUndoAvailable()) field.undo();
  field.setModified(false);
}

}  // namespace

FocusHome::FocusHome(QWidget* window, std::function<void()> home, std::function<bool()> cancel,
                     std::function<bool(const QWidget&)> returns)
    : QObject(window),
      window_(window),
      home_(std::move(home)),
      cancel_(std::move(cancel)),
      returns_(std::move(returns)) {
  qApp->installEventFilter(this);
}

bool FocusHome::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
  auto* widget = qobject_cast<QWidget*>(watched);
  if (!widget || widget != QApplication::focusWidget() || widget->window() != window_) return false;
  if (QApplication::activePopupWidget() || !keepsKeys(*widget) || isInQuestion(*widget)) return false;
  const auto& key = static_cast<const QKeyEvent&>(*event);
  auto* field = qobject_cast<QLineEdit*>(widget);
  if (auto* box = qobject_cast<QAbstractSpinBox*>(widget)) field = box->findChild<QLineEdit*>();
  if (key.key() == Qt::Key_Escape) {
    if (usesEscape(*widget)) return false;
    if (event->type() == QEvent::ShortcutOverride) {
      event->accept();  // not yet "back to live"
      return true;
    }
    if (cancel_()) return true;
    if (field) takeBack(*field);
    home_();
    return true;
  }
  const bool entered = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
  if (event->type() == QEvent::KeyPress && entered && field && returns_(*widget))
    QMetaObject::invokeMethod(
        this, [this] { home_(); }, Qt::QueuedConnection);  // when the field has taken it
  return false;
}

}  // namespace surefoot

#include "moc_focus_home.cpp"
