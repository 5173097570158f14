// SPDX-License-Identifier: GPL-3.0-or-later
// The text size that a person chose (View › Text size, Ctrl + and −), and how the window follows it. How to use it:
//
// - A widget that is drawn by hand keeps its plain numbers. It derives from Painted<> and draws with a ScaledPainter
//   (ui/painted.h): all its lengths, pens and textFont() are pixels at size 1, and the painter makes them larger.
// - A standard widget (label, button, field, table) is given scaledFont() and scaled() lengths, inside whenScaled().
// - sizeHint() and minimumSizeHint() return scaled({width, height}).
#pragma once

#include <QFont>
#include <QMargins>
#include <QSize>
#include <functional>

class QObject;

namespace surefoot {

constexpr double kSmallestText = 0.8, kLargestText = 2.0, kTextStep = 0.1, kProjectorText = 1.6;

/// How many times as large as drawn everything is: 0.8 … 2.0.
double textSize();

/// Applies a size to every widget at once. It is rounded to a tenth and kept within 0.8 … 2.0.
void applyTextSize(double scale);

/// A length at size 1 as a length on the screen [px]; hairlines of 1 px stay at least that.
int scaled(int pixels);
double scaled(double pixels);
QSize scaled(QSize pixels);
QMargins scaled(QMargins pixels);

/// textFont() for standard widgets, in the size that was chosen.
QFont scaledFont(int pixels, int weight = 400);

/// Runs `apply` now, and again whenever the text size changes, while `owner` lives.
void whenScaled(QObject* owner, const std::function<void()>& apply);

}  // namespace surefoot
