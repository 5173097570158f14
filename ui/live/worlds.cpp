// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/worlds.h"

#include <algorithm>

namespace surefoot {

namespace {
constexpr double kShape = 576.0 / 400.0;  // width to height of a world that looks best
}

Worlds::Worlds(QWidget* parent) : QSplitter(Qt::Horizontal, parent) {
  setHandleWidth(1);
  setChildrenCollapsible(false);
}

QSize Worlds::minimumSizeHint() const {
  QSize least(0, 0);
  for (int i = 0; i < count(); ++i)
    if (!widget(i)->isHidden()) {
      const QSize one = widget(i)->minimumSizeHint();
      const int between = least.width() > 0 ? handleWidth() : 0;
      least = {least.width() + between + one.width(), std::max(least.height(), one.height())};
    }
  return least;
}

void Worlds::resizeEvent(QResizeEvent* event) {
  int shown = 0, high = 0;
  for (int i = 0; i < count(); ++i)
    if (!widget(i)->isHidden()) ++shown, high += widget(i)->minimumSizeHint().height();
  const double w = width(), h = height();
  const bool larger = std::min(w, h / shown * kShape) > std::min(w / shown, h * kShape);
  const auto wanted = shown > 1 && larger && height() >= high ? Qt::Vertical : Qt::Horizontal;
  if (orientation() != wanted) {
    setOrientation(wanted);
    setSizes(QList<int>(count(), 1));
  }
  QSplitter::resizeEvent(event);
}

}  // namespace surefoot
