// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/text_button.h"

#include <QKeyEvent>
#include <cmath>

#include "ui/style/icons.h"
#include "ui/style/theme.h"
#include "ui/support/keyboard.h"

namespace surefoot {

namespace {
constexpr int kButtonHeight = 32, kLeastWidth = 80, kBeside = 16, kIconRoom = 20;  // [px]
}

TextButton::TextButton(const QString& text, Look look, QWidget* parent) : Painted(parent), look_(look) {
  setText(text);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
  whenScaled(this, [this] { updateGeometry(); });
}

void TextButton::setLook(Look look) {
  look_ = look;
  update();
}

void TextButton::setStarts(bool starts) {
  starts_ = starts;
  updateGeometry();
  update();
}

QSize TextButton::sizeHint() const {
  const int words = static_cast<int>(std::ceil(QFontMetricsF(textFont(13, 500)).horizontalAdvance(text())));
  return scaled(QSize(std::max(kLeastWidth, words + 2 * kBeside + (starts_ ? kIconRoom : 0)), kButtonHeight));
}

void TextButton::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return click();
  QAbstractButton::keyPressEvent(event);
}

void TextButton::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const bool filled = look_ == Look::Main && isEnabled();
  const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  QColor ground = filled ? t.ink : isDown() || underMouse() ? t.fill : t.panel;
  if (filled && (isDown() || underMouse())) ground.setAlphaF(0.86f);
  p.setBrush(ground);
  p.setPen(filled ? QPen(Qt::NoPen) : QPen(t.outline, 1));
  p.drawRoundedRect(box, 4, 4);
  const QColor words = !isEnabled() ? t.disabled : filled ? t.panel : t.ink;
  p.setFont(textFont(13, 500));
  p.setPen(words);
  const double width = QFontMetricsF(p.font()).horizontalAdvance(text());
  const double left = (box.width() - width - (starts_ ? kIconRoom : 0)) / 2;
  if (starts_) drawIcon(p, Icon::Run, QRectF(left, 0, 14, box.height()), words);
  p.drawText(QRectF(left + (starts_ ? kIconRoom : 0), 0, width + 1, box.height()), Qt::AlignVCenter, text());
  if (hasFocus()) drawFocusRing(p, *this);
}

}  // namespace surefoot

#include "moc_text_button.cpp"
