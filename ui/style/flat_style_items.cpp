// SPDX-License-Identifier: GPL-3.0-or-later
// Items in rows: menus, tabs, heads and cells of tables; and the lines between panels.
#include <QPainter>
#include <QStyleOption>
#include <QTableView>

#include "ui/style/flat_style.h"
#include "ui/style/icons.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

void drawChosen(QPainter& p, const QRect& where, const QColor& fill) {
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(Qt::NoPen);
  p.setBrush(fill);
  p.drawRoundedRect(where, scaled(4.0), scaled(4.0));
  p.restore();
}

bool isChosen(const QStyleOption& option) {
  return (option.state & QStyle::State_Selected) && (option.state & QStyle::State_Enabled);
}

/// A hairline between items, or the head of a section.
void drawSeparator(QPainter& p, const QStyleOptionMenuItem& item) {
  const Theme& t = themeOf(item.palette);
  const QRect inside = item.rect.adjusted(scaled(8), 0, -scaled(8), 0);
  if (item.text.isEmpty()) return p.fillRect(inside.adjusted(0, scaled(4), 0, -scaled(4)), t.hairline);
  p.setFont(scaledFont(11));
  p.setPen(t.quiet);
  p.drawText(inside, Qt::AlignVCenter | Qt::AlignLeft, item.text);
}

void drawBottomLine(QPainter& p, const QRect& r, int width, const QColor& colour) {
  p.fillRect(QRect(r.left(), r.bottom() - width + 1, r.width(), width), colour);
}

/// Where a panel that is being moved will land.
void drawLanding(QPainter& p, const QRect& where, const Theme& t) {
  QColor wash = t.accent;
  wash.setAlphaF(0.18f);
  p.fillRect(where, wash);
  p.setPen(QPen(t.accent, 2));
  p.setBrush(Qt::NoBrush);
  p.drawRect(where.adjusted(1, 1, -1, -1));
}

}  // namespace

void FlatStyle::drawMenuEntry(ControlElement element, const QStyleOptionMenuItem& item, QPainter& painter,
                              const QWidget* widget) const {
  const Theme& t = themeOf(item.palette);
  if (element == CE_MenuItem && item.menuItemType == QStyleOptionMenuItem::Separator)
    return drawSeparator(painter, item);
  if (element == CE_MenuBarItem) painter.fillRect(item.rect, t.panel);
  if (isChosen(item)) drawChosen(painter, item.rect, t.fill);
  if (element == CE_MenuBarItem) {
    const bool underlined = styleHint(SH_UnderlineShortcut, &item, widget, nullptr);
    const int flags = Qt::AlignCenter | (underlined ? Qt::TextShowMnemonic : Qt::TextHideMnemonic);
    return drawItemText(&painter, item.rect, flags, item.palette, item.state & State_Enabled, item.text,
                        QPalette::ButtonText);
  }
  QStyleOptionMenuItem flat(item);  // the words are Fusion's
  flat.state &= ~(State_Selected | State_HasFocus);
  for (const auto role : {QPalette::Text, QPalette::ButtonText, QPalette::WindowText})
    flat.palette.setColor(QPalette::Disabled, role, t.quiet);
  QProxyStyle::drawControl(element, &flat, &painter, widget);
}

void FlatStyle::drawTab(ControlElement element, const QStyleOptionTab& tab, QPainter& painter,
                        const QWidget* widget) const {
  const Theme& t = themeOf(tab.palette);
  const bool chosen = tab.state & State_Selected;
  if (element == CE_TabBarTabShape) {
    painter.fillRect(tab.rect, t.panel);
    if (chosen) drawBottomLine(painter, tab.rect, scaled(2), tab.state & State_HasFocus ? t.accent : t.ink);
    return;
  }
  QStyleOptionTab words(tab);
  words.palette.setColor(QPalette::WindowText, chosen ? t.ink : t.quiet);
  QProxyStyle::drawControl(element, &words, &painter, widget);
}

void FlatStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                            const QWidget* widget) const {
  const Theme& t = themeOf(option->palette);
  if (element == CE_RubberBand) return drawLanding(*painter, option->rect, t);
  if (const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option); box && element == CE_ComboBoxLabel) {
    QStyleOptionComboBox words(*box);
    const int icon = words.currentIcon.isNull() ? 0 : words.iconSize.width() + 4;
    const int room = subControlRect(CC_ComboBox, &words, SC_ComboBoxEditField, widget).width() - icon;
    words.currentText = words.fontMetrics.elidedText(words.currentText, Qt::ElideRight, room);
    return QProxyStyle::drawControl(element, &words, painter, widget);
  }
  if (element == CE_ToolButtonLabel && widget && widget->objectName() == "qt_menubar_ext_button")
    return drawIcon(*painter, Icon::Chevron, option->rect, t.ink);  // the menus that have no room
  if (element == CE_Splitter) return painter->fillRect(option->rect, t.hairline);
  if (element == CE_MenuBarEmptyArea || element == CE_HeaderEmptyArea || element == CE_HeaderSection)
    painter->fillRect(option->rect, t.panel);
  if (element == CE_MenuBarEmptyArea || element == CE_HeaderEmptyArea) return;
  if (element == CE_HeaderSection) return drawBottomLine(*painter, option->rect, 1, t.hairline);
  if (element == CE_HeaderLabel)
    if (const auto* head = qstyleoption_cast<const QStyleOptionHeader*>(option)) {
      QStyleOptionHeader words(*head);
      words.rect.adjust(headMargin(), 0, -headMargin(), 0);
      return QProxyStyle::drawControl(element, &words, painter, widget);
    }
  if (element == CE_MenuBarItem || element == CE_MenuItem)
    if (const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option))
      return drawMenuEntry(element, *item, *painter, widget);
  if (element == CE_TabBarTabShape || element == CE_TabBarTabLabel)
    if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option))
      return drawTab(element, *tab, *painter, widget);
  if (element == CE_ItemViewItem && qobject_cast<const QTableView*>(widget))
    if (const auto* item = qstyleoption_cast<const QStyleOptionViewItem*>(option)) {
      QStyleOptionViewItem cell(*item);
      cell.palette.setColor(QPalette::HighlightedText, t.ink);  // a chosen row keeps its ink
      return QProxyStyle::drawControl(element, &cell, painter, widget);
    }
  QProxyStyle::drawControl(element, option, painter, widget);
}

}  // namespace surefoot
