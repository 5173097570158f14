// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/combo.h"

#include <QPainter>
#include <QWheelEvent>

#include "ui/icons.h"
#include "ui/theme.h"

namespace surefoot {

Combo::Combo(const QString& name, QWidget* parent) : QComboBox(parent) {
  setAccessibleName(name);
  setToolTip(name);
}

void Combo::paintEvent(QPaintEvent* event) {
  QComboBox::paintEvent(event);
  QPainter p(this);  // the style sheet that flattens the frame takes the arrow away
  drawIcon(p, Icon::Chevron, QRectF(width() - 26, 0, 20, height()), themeOf(*this).ink);
}

// A wheel that scrolls the form must not change a choice on its way.
void Combo::wheelEvent(QWheelEvent* event) {
  event->ignore();
}

}  // namespace surefoot
