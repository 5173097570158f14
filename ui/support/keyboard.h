// SPDX-License-Identifier: GPL-3.0-or-later
// Decides which widget gets a key. The window's shortcuts are single keys (Space, R, the arrows …), so the widget with
// the focus is asked first, or no button could be pressed and no slider moved without a mouse.
#pragma once

#include <QObject>

class QKeyEvent;
class QPainter;
class QWidget;

namespace surefoot {

/// Watches the whole program. Buttons take Space and Return, sliders and tabs their arrows, choices open a list.
class Keyboard final : public QObject {
  Q_OBJECT

 public:
  explicit Keyboard(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

/// Whether a widget that has the focus uses this key itself.
bool usesKey(const QWidget& widget, const QKeyEvent& event);

/// A property of a list whose cells are not walked through: ← and → are not its own.
inline constexpr char kRowsOnly[] = "rowsOnly";

/// The ring around the widget with the focus, inside its edge.
void drawFocusRing(QPainter& painter, const QWidget& widget);

}  // namespace surefoot
