// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/questions/option_button.h"

#include <cmath>

#include "ui/style/theme.h"
#include "ui/support/keyboard.h"

namespace surefoot {

namespace {
constexpr int kLeft = 28, kRight = 8, kRow = 32;  // [px]
}

OptionButton::OptionButton(const QString& text, QWidget* parent) : Painted(parent) {
  setText(text);
  setAccessibleName(text);
  setCheckable(true);
  setAutoExclusive(true);
  setFocusPolicy(Qt::StrongFocus);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  whenScaled(this, [this] { updateGeometry(); });
}

/// Enter gives the answer; it does not press this.
void OptionButton::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return event->ignore();
  Painted::keyPressEvent(event);
}

int OptionButton::heightForWidth(int width) const {
  const double room = std::max(40.0, width / textSize() - kLeft - kRight);
  const QRectF text =
      QFontMetricsF(textFont(13)).boundingRect(QRectF(0, 0, room, 1000), Qt::TextWordWrap, this->text());
  return scaled(std::max(kRow, static_cast<int>(std::ceil(text.height())) + 12));
}

QSize OptionButton::sizeHint() const {
  return {scaled(296), heightForWidth(scaled(296))};
}

void OptionButton::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  if (isChecked() || underMouse()) {
    p.setPen(Qt::NoPen);
    QColor ground = t.fill;
    if (!isChecked()) ground.setAlphaF(0.4f);
    p.setBrush(ground);
    p.drawRoundedRect(rect(), 4, 4);
  }
  const QPointF centre(14, height() / 2.0);
  p.setBrush(t.panel);
  p.setPen(QPen(isChecked() ? t.ink : t.outline, isChecked() ? 1.75 : 1.25));
  p.drawEllipse(centre, 6.25, 6.25);
  if (isChecked()) {
    p.setPen(Qt::NoPen);
    p.setBrush(t.ink);
    p.drawEllipse(centre, 3.25, 3.25);
  }
  p.setFont(textFont(13));
  p.setPen(isEnabled() ? t.ink : t.disabled);
  p.drawText(QRectF(kLeft, 0, width() - kLeft - kRight, height()), Qt::AlignVCenter | Qt::TextWordWrap, text());
  if (hasFocus()) drawFocusRing(p, *this);
}

}  // namespace surefoot

#include "moc_option_button.cpp"
