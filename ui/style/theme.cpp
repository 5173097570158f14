// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/theme.h"

#include <QApplication>
#include <QFontMetrics>
#include <QWidget>

#include "ui/style/flat_style.h"
#include "ui/style/scale.h"

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
                           .disabled = 0x8C939D,
                           .epsilonGreedy = 0x4A515B,
                           .trl = 0x009E73,
                           .trlStrong = 0x007A5A,
                           .softmax = 0x8A4FD0,
                           .greedy = 0x8C939D,
                           .otherPolicy = 0xB0447E,
                           .anotherPolicy = 0x7A5230,
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
                           .disabled = 0x767E89,
                           .epsilonGreedy = 0xC3C9D1,
                           .trl = 0x2DB88C,
                           .trlStrong = 0x2DB88C,
                           .softmax = 0x9C7CF0,
                           .greedy = 0x8C939D,
                           .otherPolicy = 0xE08FBE,
                           .anotherPolicy = 0xC79A6B,
                           .fall = 0xF0783A,
                           .fallText = 0xF0783A};
  return theme;
}

const Theme& themeOf(const QPalette& palette) {
  return palette.color(QPalette::Active, QPalette::Window).lightness() < 128 ? darkTheme() : lightTheme();
}

const Theme& themeOf(const QWidget& widget) {
  return themeOf(widget.palette());
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
    p.setColor(QPalette::Disabled, role, t.disabled);
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

}  // namespace

void applyAppearance(QApplication& application, Appearance appearance) {
  static const bool systemIsDark = themeOf(QApplication::palette()).dark;
  const bool dark = appearance == Appearance::Dark || (appearance == Appearance::System && systemIsDark);
  if (!qobject_cast<FlatStyle*>(application.style())) QApplication::setStyle(new FlatStyle);
  if (QApplication::font() != scaledFont(13)) QApplication::setFont(scaledFont(13));
  const Theme& theme = dark ? darkTheme() : lightTheme();
  static const Theme* now = nullptr;
  if (now == &theme) return;
  now = &theme;
  QApplication::setPalette(paletteOf(theme));
}

QFont textFont(int pixels, int weight) {
  static const QString family = tabularFamily();
  QFont font(family);
  font.setPixelSize(pixels);
  font.setWeight(static_cast<QFont::Weight>(weight));
  return font;
}

}  // namespace surefoot
