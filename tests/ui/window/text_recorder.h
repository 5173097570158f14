// SPDX-License-Identifier: GPL-3.0-or-later
// Which texts a widget draws, and where: its painting is played to a device that keeps nothing else.
#pragma once

#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

class QWidget;

namespace surefoot {

struct DrawnText {
  QString text;
  QRectF place;  ///< of its letters, in the widget's pixels on the screen
  std::optional<QRectF> clip;
};

/// The texts of a widget without its children, in the order in which they are drawn.
std::vector<DrawnText> drawnTexts(QWidget& widget);

/// What is wrong with them: one that leaves the widget, two that lie over each other, one below a child. A sentence
/// each. What scrolls may leave it.
std::vector<QString> cutOrOverlapping(QWidget& widget, bool scrolls);

}  // namespace surefoot
