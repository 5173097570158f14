// SPDX-License-Identifier: GPL-3.0-or-later
// Colours and fonts, light and dark. Every measure of the window is a multiple of the 8 px grid or named where it is
// used.
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QString>

class QApplication;
class QWidget;

namespace surefoot {

struct Theme {
  bool dark;
  QColor paper, panel, fill, ink, quiet, hairline, outline, track, accent, caution, disabled;
  QColor epsilonGreedy, trl, trlStrong, softmax, greedy;  // trlStrong carries white text
  QColor otherPolicy, anotherPolicy;                      // of policies without a colour of their own
  QColor fall, fallText;
};

enum class Appearance { System, Light, Dark };

const Theme& lightTheme();
const Theme& darkTheme();

/// The theme that a widget is drawn in: its palette decides.
const Theme& themeOf(const QPalette& palette);
const Theme& themeOf(const QWidget& widget);

/// Style, palette and font of the whole program.
void applyAppearance(QApplication& application, Appearance appearance);

/// Text in a weight of 400 (normal) or 500 (medium); sizes in px: 13 text, 11 axes and notes, 24 the fall counter. For
/// a ScaledPainter; standard widgets take scaledFont() (ui/scale.h).
QFont textFont(int pixels, int weight = 400);

}  // namespace surefoot
