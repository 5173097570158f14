// SPDX-License-Identifier: GPL-3.0-or-later
// Icons in one stroke width, drawn as paths in the colour that is asked for: sharp at any scale, right in any theme.
#pragma once

#include <QColor>
#include <QPainter>

namespace surefoot {

enum class Icon { Run, Pause, Step, Restart, Turbo, FullSize, NormalSize, Chevron, Close, Help };

/// Draws the icon around the centre of `where`.
void drawIcon(QPainter& painter, Icon icon, const QRectF& where, const QColor& colour);

}  // namespace surefoot
