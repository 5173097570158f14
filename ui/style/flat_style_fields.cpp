// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons, fields, indicators and scroll bars: the controls of the window.
#include <QAbstractButton>
#include <QComboBox>
#include <QMenu>
#include <QPainter>
#include <QStyleOption>
#include <QTabBar>
#include <QTableView>

#include "ui/style/flat_style.h"
#include "ui/style/icons.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

/// The plate of every field and button: a rounded frame; with the keyboard focus it is heavier and in the accent.
void drawPlate(QPainter& p, const QStyleOption& option, const QColor& fill, const QColor& frame) {
  const bool focus = option.state & QStyle::State_HasFocus;
  const double pen = focus ? scaled(2.0) : scaled(1), inset = pen / 2, round = scaled(4.0);
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(QPen(focus ? themeOf(option.palette).accent : frame, pen));
  p.setBrush(fill);
  p.drawRoundedRect(QRectF(option.rect).adjusted(inset, inset, -inset, -inset), round, round);
  p.restore();
}

void drawButton(QPainter& p, const QStyleOption& option) {
  const Theme& t = themeOf(option.palette);
  const bool enabled = option.state & QStyle::State_Enabled;
  const bool down = option.state & (QStyle::State_Sunken | QStyle::State_On);
  const bool hover = enabled && (option.state & QStyle::State_MouseOver);
  drawPlate(p, option, down ? t.track : hover ? t.fill : t.panel, enabled ? t.outline : t.hairline);
}

/// A button without a frame of its own: a plate only under the pointer or the keyboard.
void drawQuietButton(QPainter& p, const QStyleOption& option) {
  const Theme& t = themeOf(option.palette);
  const bool hover = (option.state & QStyle::State_MouseOver) && (option.state & QStyle::State_Enabled);
  const bool focus = option.state & QStyle::State_HasFocus;
  const bool down = option.state & (QStyle::State_Sunken | QStyle::State_On);
  if (hover || focus || down) drawPlate(p, option, down ? t.track : hover ? t.fill : t.panel, Qt::transparent);
}

/// From here on the painter draws in pixels at text size 1, around a point.
void enlargeAround(QPainter& p, QPointF centre) {
  p.translate(centre);
  p.scale(textSize(), textSize());
}

void drawScaledIcon(QPainter& p, Icon icon, const QRectF& where, const QColor& colour) {
  p.save();
  enlargeAround(p, where.center());
  drawIcon(p, icon, QRectF(-8, -8, 16, 16), colour);
  p.restore();
}

void drawTick(QPainter& p, QPointF centre, const QColor& colour) {
  p.setPen(QPen(colour, 1.75, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  p.setBrush(Qt::NoBrush);
  p.drawPolyline(QPolygonF({centre + QPointF(-3.2, 0.2), centre + QPointF(-1, 2.5), centre + QPointF(3.2, -2.4)}));
}

void drawIndicator(QPainter& p, const QStyleOption& option, bool round) {
  const Theme& t = themeOf(option.palette);
  const bool on = option.state & QStyle::State_On, enabled = option.state & QStyle::State_Enabled;
  const bool focus = option.state & QStyle::State_HasFocus;
  const QColor ink = enabled ? t.ink : t.outline;
  const double side = focus ? 12 : 13;  // the heavier frame needs the room
  QRectF box(-side / 2, -side / 2, side, side);
  p.save();
  enlargeAround(p, QRectF(option.rect).center());
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(QPen(focus ? t.accent : on ? ink : t.quiet, focus ? 2 : 1));
  p.setBrush(on && !round ? ink : t.panel);
  p.drawRoundedRect(box, round ? side / 2 : 3, round ? side / 2 : 3);
  if (on && round) {
    p.setPen(Qt::NoPen);
    p.setBrush(ink);
    p.drawEllipse(box.center(), 3.5, 3.5);
  } else if (on) {
    drawTick(p, box.center(), t.panel);
  }
  p.restore();
}

/// A menu has no boxes: an entry that is on has a tick, or Fusion's dot if it is one of several choices.
void drawMenuTick(QPainter& p, const QStyleOption& option) {
  if (!(option.state & QStyle::State_On)) return;
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  enlargeAround(p, QRectF(option.rect).center());
  drawTick(p, {}, themeOf(option.palette).ink);
  p.restore();
}

void drawScrollBar(QPainter& p, const QStyleOption& option, const QRect& handle) {
  const Theme& t = themeOf(option.palette);
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(Qt::NoPen);
  p.setBrush(option.state & QStyle::State_Sunken ? t.quiet : t.outline);
  p.drawRoundedRect(QRectF(handle).adjusted(1, 1, -1, -1), scaled(3.0), scaled(3.0));
  p.restore();
}

/// Whether a widget itself shows that it has the keyboard focus.
bool showsItsFocus(const QWidget* widget) {
  return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
         qobject_cast<const QTabBar*>(widget) || qobject_cast<const QTableView*>(widget);
}

}  // namespace

void FlatStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const {
  const Theme& t = themeOf(option->palette);
  switch (element) {
    case PE_PanelButtonCommand:
      return drawButton(*painter, *option);
    case PE_PanelButtonTool:
      return drawQuietButton(*painter, *option);
    case PE_FrameLineEdit:
      return drawPlate(*painter, *option, t.panel, option->state & State_Enabled ? t.outline : t.hairline);
    case PE_IndicatorCheckBox:
      return qobject_cast<const QMenu*>(widget) ? drawMenuTick(*painter, *option)
                                                : drawIndicator(*painter, *option, false);
    case PE_IndicatorRadioButton:
      return drawIndicator(*painter, *option, true);
    case PE_FrameFocusRect:
      if (!showsItsFocus(widget)) break;
      return;
    default:
      if (drawSurface(element, *painter, *option, widget)) return;
  }
  QProxyStyle::drawPrimitive(element, option, painter, widget);
}

void FlatStyle::drawSpinBox(const QStyleOptionSpinBox& option, QPainter& painter, const QWidget* widget) const {
  const Theme& t = themeOf(option.palette);
  const bool enabled = option.state & State_Enabled;
  drawPlate(painter, option, t.panel, enabled ? t.outline : t.hairline);
  if (option.buttonSymbols == QAbstractSpinBox::NoButtons) return;
  for (const bool up : {true, false}) {
    const QRectF place = subControlRect(CC_SpinBox, &option, up ? SC_SpinBoxUp : SC_SpinBoxDown, widget);
    const bool possible =
        enabled && (option.stepEnabled & (up ? QAbstractSpinBox::StepUpEnabled : QAbstractSpinBox::StepDownEnabled));
    painter.save();
    enlargeAround(painter, QPointF(place.center().x(), up ? place.bottom() - scaled(6.0) : place.top() + scaled(6.0)));
    if (up) painter.rotate(180);
    drawIcon(painter, Icon::Chevron, QRectF(-5, -4, 10, 8), possible ? t.ink : t.outline);
    painter.restore();
  }
}

void FlatStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                   const QWidget* widget) const {
  const Theme& t = themeOf(option->palette);
  const bool enabled = option->state & State_Enabled;
  if (control == CC_ComboBox) {
    drawPlate(*painter, *option, t.panel, enabled ? t.outline : t.hairline);
    const QRect arrow = subControlRect(control, option, SC_ComboBoxArrow, widget);
    return drawScaledIcon(*painter, Icon::Chevron, arrow, enabled ? t.ink : t.outline);
  }
  if (control == CC_ScrollBar)
    return drawScrollBar(*painter, *option, subControlRect(control, option, SC_ScrollBarSlider, widget));
  if (const auto* box = qstyleoption_cast<const QStyleOptionSpinBox*>(option); box && control == CC_SpinBox)
    return drawSpinBox(*box, *painter, widget);
  if (const auto* tool = qstyleoption_cast<const QStyleOptionToolButton*>(option); tool && control == CC_ToolButton) {
    QStyleOptionToolButton plain(*tool);
    plain.state &=
        ~State_AutoRaise;  // or its plate is left out where the keyboard is; drawQuietButton needs no such help
    return QProxyStyle::drawComplexControl(control, &plain, painter, widget);
  }
  QProxyStyle::drawComplexControl(control, option, painter, widget);
}

}  // namespace surefoot
