// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme.h"

#include <QApplication>
#include <QFontMetrics>
#include <QStyle>
#include <QStyleFactory>
#include <QWidget>

namespace surefoot {

const Theme& lightTheme() {
  static const Theme theme{.dark = false,
                           .paper = 0xFAFAF8,
                           .panel = 0xFFFFFF,
                           .fill = 0xF1F3F5,
                           .ink = 0x1F2328,
                           .quiet = 0x5F6671,
                           .hairline = 0xE3E5E8,
                           .outline = 0xC4C8CE,
                           .track = 0xDDE0E4,
                           .accent = 0x0072B2,
                           .caution = 0x8A6100,
                           .epsilonGreedy = 0x4A515B,
                           .trl = 0x009E73,
                           .trlStrong = 0x007A5A,
                           .softmax = 0x8A4FD0,
                           .greedy = 0x8C939D,
                           .fall = 0xD55E00,
                           .fallText = 0xC04F00};
  return theme;
}

const Theme& darkTheme() {
  static const Theme theme{.dark = true,
                           .paper = 0x16181C,
                           .panel = 0x1E2126,
                           .fill = 0x2A2E35,
                           .ink = 0xE6E8EB,
                           .quiet = 0x9AA1AB,
                           .hairline = 0x33383F,
                           .outline = 0x4A515B,
                           .track = 0x3A4048,
                           .accent = 0x56B4E9,
                           .caution = 0xD9A93A,
                           .epsilonGreedy = 0xC3C9D1,
                           .trl = 0x2DB88C,
                           .trlStrong = 0x2DB88C,
                           .softmax = 0x9C7CF0,
                           .greedy = 0x8C939D,
                           .fall = 0xF0783A,
                           .fallText = 0xF0783A};
  return theme;
}

const Theme& themeOf(const QWidget& widget) {
  return widget.palette().color(QPalette::Active, QPalette::Window).lightness() < 128 ? darkTheme() : lightTheme();
}

namespace {

QPalette paletteOf(const Theme& t) {
  QPalette p;
  p.setColor(QPalette::Window, t.panel);
  p.setColor(QPalette::Base, t.panel);
  p.setColor(QPalette::AlternateBase, t.fill);
  p.setColor(QPalette::Button, t.panel);
  p.setColor(QPalette::ToolTipBase, t.panel);
  for (const auto role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText, QPalette::BrightText})
    p.setColor(role, t.ink);
  p.setColor(QPalette::PlaceholderText, t.quiet);
  p.setColor(QPalette::Highlight, t.accent);
  p.setColor(QPalette::HighlightedText, t.dark ? t.paper : QColor(Qt::white));
  p.setColor(QPalette::Link, t.ink);
  for (const auto role : {QPalette::Light, QPalette::Midlight, QPalette::Mid, QPalette::Dark})
    p.setColor(role, t.hairline);
  p.setColor(QPalette::Shadow, t.outline);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, t.outline);
  return p;
}

/// The first family whose digits are all of one width, so that columns of numbers stand still.
QString tabularFamily() {
  for (const char* family : {"Roboto", "Noto Sans", "DejaVu Sans", "Liberation Sans"}) {
    const QFont font(family);
    const QFontMetrics metrics(font);
    if (QFontInfo(font).family() == QLatin1String(family) &&
        metrics.horizontalAdvance('1') == metrics.horizontalAdvance('0'))
      return family;
  }
  return QApplication::font().family();
}

/// Menus, tool tips, combo boxes and scroll bars: what Fusion draws with frames and gradients of its own.
QString styleSheetOf(const Theme& t) {
  return QString(R"(
QMenuBar { background: %1; spacing: 4px; padding: 0 4px; }
QMenuBar::item { background: transparent; color: %2; padding: 4px 8px; border-radius: 4px; }
QMenuBar::item:selected { background: %3; }
QMenu { background: %1; color: %2; border: 1px solid %4; padding: 4px; }
QMenu::item { padding: 5px 24px 5px 24px; border-radius: 4px; }
QMenu::item:selected { background: %3; }
QMenu::item:disabled { color: %5; }
QMenu::separator { height: 1px; background: %4; margin: 4px 8px; }
QToolTip { background: %1; color: %2; border: 1px solid %4; padding: 4px; }
QComboBox { border: 1px solid %6; border-radius: 4px; padding: 0 8px; background: %1; color: %2; }
QComboBox:focus { border: 2px solid %7; padding: 0 7px; }
QComboBox::drop-down { border: none; width: 18px; }
QComboBox::down-arrow { image: none; }
QComboBox QAbstractItemView { background: %1; color: %2; selection-background-color: %4; selection-color: %2;
  border: 1px solid %6; outline: none; padding: 2px; }
QScrollArea { border: none; background: transparent; }
QScrollBar:vertical { background: transparent; width: 8px; margin: 0; }
QScrollBar::handle:vertical { background: %6; border-radius: 3px; min-height: 24px; margin: 1px; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0; }
QToolButton#flat { border: none; background: transparent; padding: 0; }
QSplitter::handle { background: %4; }
QCheckBox::indicator, QRadioButton::indicator { width: 14px; height: 14px; border: 1px solid %5; background: %1; }
QCheckBox::indicator { border-radius: 3px; }
QRadioButton::indicator { border-radius: 8px; }
QCheckBox::indicator:checked { background: %2; border-color: %2; }
QRadioButton::indicator:checked { width: 6px; height: 6px; border: 5px solid %2; }
QCheckBox::indicator:focus, QRadioButton::indicator:focus { border-color: %7; }
QTabBar::tab { background: %1; color: %5; padding: 3px 10px; border: none; border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: %2; border-bottom-color: %2; }
QTabBar::tab:focus { border-bottom-color: %7; }
QDialog { border: 1px solid %6; }
QPushButton { border: 1px solid %6; border-radius: 4px; background: %1; color: %2; padding: 5px 12px; }
QPushButton:hover { background: %3; }
QPushButton:disabled { color: %6; border-color: %4; }
QPushButton:focus { border: 2px solid %7; padding: 4px 11px; }
QDialog QLineEdit, surefoot--ConditionForm QLineEdit { border: 1px solid %6; border-radius: 4px; background: %1; color: %2;
  padding: 3px 8px; }
QDialog QLineEdit:focus, surefoot--ConditionForm QLineEdit:focus { border: 2px solid %7; padding: 2px 7px; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QHeaderView::section { border: none; border-bottom: 1px solid %4; background: %1; padding: 0 10px; }
QTableView { outline: 0; }
QTableView::item { border-bottom: 1px solid %4; padding: 0 10px; }
QTableView::item:selected { background: %3; color: %2; }
)")
      .arg(t.panel.name(), t.ink.name(), t.fill.name(), t.hairline.name(), t.quiet.name(), t.outline.name(),
           t.accent.name());
}

}  // namespace

void applyAppearance(QApplication& application, Appearance appearance) {
  static const bool systemIsDark = QApplication::palette().color(QPalette::Window).lightness() < 128;
  const bool dark = appearance == Appearance::Dark || (appearance == Appearance::System && systemIsDark);
  const Theme& theme = dark ? darkTheme() : lightTheme();
  if (application.style()->name() != QLatin1String("fusion")) QApplication::setStyle(QStyleFactory::create("Fusion"));
  if (QApplication::font() != textFont(13)) QApplication::setFont(textFont(13));
  static const Theme* now = nullptr;
  if (now == &theme) return;
  now = &theme;
  application.setStyleSheet({});  // or every widget would be styled twice
  QApplication::setPalette(paletteOf(theme));
  application.setStyleSheet(styleSheetOf(theme));
}

QFont textFont(int pixels, int weight) {
  static const QString family = tabularFamily();
  QFont font(family);
  font.setPixelSize(pixels);
  font.setWeight(static_cast<QFont::Weight>(weight));
  return font;
}

PolicyLook policyLook(std::string_view policy, const Theme& t) {
  if (policy == "epsilon-greedy") return {t.epsilonGreedy, Marker::Circle};
  if (policy == "trl") return {t.trl, Marker::Triangle};
  if (policy == "softmax") return {t.softmax, Marker::Square};
  return {t.greedy, Marker::Diamond};
}

}  // namespace surefoot
