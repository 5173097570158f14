// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/link_button.h"

#include <QPainter>
#include <cmath>

#include "ui/style/icons.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {
constexpr int kHeight = 20, kPadding = 4, kChevron = 14;
}

LinkButton::LinkButton(const QString& text, QWidget* parent) : Painted(parent) {
  setText(text);
  setAccessibleName(text);
  whenScaled(this, [this] { setFont(scaledFont(11)); });
  setCursor(Qt::PointingHandCursor);
  setFocusPolicy(Qt::TabFocus);
}

QSize LinkButton::sizeHint() const {
  const int words = static_cast<int>(std::ceil(symbolWidth(textFont(11), text())));
  return scaled({words + 2 * kPadding + (menu() ? kChevron : 0), kHeight});
}

void LinkButton::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  if (underMouse() && isEnabled()) {
    p.setPen(Qt::NoPen);
    p.setBrush(t.fill);
    p.drawRoundedRect(rect(), 3, 3);
  }
  if (hasFocus()) {
    p.setPen(QPen(t.accent, 2));
    p.setBrush(Qt::NoBrush);
    p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 3, 3);
  }
  p.setFont(textFont(11));
  p.setPen(underMouse() && isEnabled() ? t.ink : t.quiet);
  drawSymbol(p, QRectF(kPadding, 0, width() - kPadding, height()), Qt::AlignLeft, text());
  if (menu()) drawIcon(p, Icon::Chevron, QRectF(width() - kChevron - 1, 3, kChevron, height() - 6), t.quiet);
}

}  // namespace surefoot

#include "moc_link_button.cpp"
