// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/header_button.h"

#include <QPainter>

#include "ui/style/theme.h"
#include "ui/support/help.h"
#include "ui/support/plain_text.h"

namespace surefoot {

HeaderButton::HeaderButton(Icon icon, Icon checked, QWidget* parent) : Painted(parent), icon_(icon), checked_(checked) {
  setCheckable(icon != checked);
  setFocusPolicy(Qt::TabFocus);
  setCursor(Qt::PointingHandCursor);
}

void HeaderButton::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  if (underMouse()) {
    p.setPen(Qt::NoPen);
    p.setBrush(t.fill);
    p.drawRoundedRect(rect(), 4, 4);
  }
  if (hasFocus()) {
    p.setPen(QPen(t.accent, 2));
    p.setBrush(Qt::NoBrush);
    p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
  }
  drawIcon(p, isChecked() ? checked_ : icon_, rect(), underMouse() ? t.ink : t.quiet);
}

HelpButton::HelpButton(const QString& about, QWidget* parent) : HeaderButton(Icon::Help, Icon::Help, parent) {
  setToolTip(tipText(tr("%1, in the handbook").arg(about)));
  setAccessibleName(toolTip());
  connect(this, &QAbstractButton::clicked, this, [this] { askForHelp(*this); });
}

}  // namespace surefoot

#include "moc_header_button.cpp"
