// SPDX-License-Identifier: GPL-3.0-or-later
// Backgrounds, and the lines between them: menus, tool tips, dialogs, framed areas, cells, docks.
#include <QDialog>
#include <QDockWidget>
#include <QPainter>
#include <QStyleOption>
#include <QTableView>

#include "ui/style/flat_style.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

void drawFramed(QPainter& p, const QRect& r, const QColor& fill, const QColor& frame) {
  p.fillRect(r, frame);
  p.fillRect(r.adjusted(1, 1, -1, -1), fill);
}

void drawCell(QPainter& p, const QStyleOption& option) {
  const Theme& t = themeOf(option.palette);
  if (option.state & QStyle::State_Selected) p.fillRect(option.rect, t.fill);
  const bool focus = option.state & QStyle::State_HasFocus;
  const int line = scaled(focus ? 2 : 1);
  p.fillRect(QRect(option.rect.left(), option.rect.bottom() - line + 1, option.rect.width(), line),
             focus ? t.accent : t.hairline);
}

void drawOutline(QPainter& p, const QStyleOption& option) {
  p.save();
  p.setPen(themeOf(option.palette).outline);
  p.setBrush(Qt::NoBrush);
  p.drawRect(option.rect.adjusted(0, 0, -1, -1));
  p.restore();
}

void drawDockSeparator(QPainter& p, const QStyleOption& option) {
  const Theme& t = themeOf(option.palette);
  const QRect r = option.rect;
  const bool upright = r.height() > r.width();
  p.fillRect(r, t.panel);
  p.fillRect(upright ? QRect(r.center().x(), r.top(), 1, r.height()) : QRect(r.left(), r.center().y(), r.width(), 1),
             t.hairline);
}

}  // namespace

bool FlatStyle::drawSurface(PrimitiveElement element, QPainter& p, const QStyleOption& option, const QWidget* widget) {
  const Theme& t = themeOf(option.palette);
  switch (element) {
    case PE_PanelTipLabel:
    case PE_PanelMenu:
      drawFramed(p, option.rect, t.panel, t.hairline);
      return true;
    case PE_Widget:
      if (const auto* dock = qobject_cast<const QDockWidget*>(widget); dock && dock->isFloating())
        drawFramed(p, option.rect, t.panel, t.quiet);
      if (qobject_cast<const QDialog*>(widget)) drawFramed(p, option.rect, t.panel, t.outline);
      return true;
    case PE_Frame:
      if (widget && widget->inherits("QComboBoxPrivateContainer")) return false;  // a menu, for Fusion
      drawOutline(p, option);
      return true;
    case PE_PanelItemViewItem:
      if (!qobject_cast<const QTableView*>(widget)) return false;
      drawCell(p, option);
      return true;
    case PE_IndicatorDockWidgetResizeHandle:
      drawDockSeparator(p, option);
      return true;
    case PE_PanelScrollAreaCorner:
      p.fillRect(option.rect, t.panel);
      return true;
    case PE_FrameMenu:  // PE_PanelMenu has drawn it
    case PE_FrameTabBarBase:
      return true;
    default:
      return false;
  }
}

}  // namespace surefoot
