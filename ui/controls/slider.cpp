// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/slider.h"

#include <QMouseEvent>
#include <QPainter>
#include <cmath>

#include "ui/style/theme.h"

namespace surefoot {

namespace {
constexpr double kMargin = 7;  // room for the focus ring [px]
}

Slider::Slider(QWidget* parent) : Painted(Qt::Horizontal, parent) {
  setRange(0, kSteps);
  setSingleStep(kSteps / 100);
  setPageStep(kSteps / 10);
  setFocusPolicy(Qt::StrongFocus);
}

double Slider::knob() const {
  return kMargin + (width() - 2 * kMargin) * (value() - minimum()) / (maximum() - minimum());
}

void Slider::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const double y = height() / 2.0, x = knob();
  p.setPen(QPen(t.track, 3, Qt::SolidLine, Qt::RoundCap));
  p.drawLine(QPointF(kMargin, y), QPointF(width() - kMargin, y));
  p.setPen(QPen(isEnabled() ? t.ink : t.outline, 3, Qt::SolidLine, Qt::RoundCap));
  p.drawLine(QPointF(kMargin, y), QPointF(x, y));
  if (hasFocus()) {
    p.setPen(QPen(t.accent, 2));
    p.setBrush(Qt::NoBrush);
    p.drawEllipse(QPointF(x, y), 6, 6);
  }
  p.setPen(QPen(isEnabled() ? t.ink : t.outline, 1.5));
  p.setBrush(t.panel);
  p.drawEllipse(QPointF(x, y), hasFocus() ? 4.5 : 5.25, hasFocus() ? 4.5 : 5.25);
}

void Slider::follow(const QMouseEvent& event) {
  const double share = (mouseAt(event).x() - kMargin) / (width() - 2 * kMargin);
  setValue(minimum() + static_cast<int>(std::lround(share * (maximum() - minimum()))));
}

void Slider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  setSliderDown(true);
  follow(*event);
}

void Slider::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown()) follow(*event);
}

void Slider::mouseReleaseEvent(QMouseEvent*) {
  setSliderDown(false);
}

// A wheel that scrolls the form must not turn a parameter on its way.
void Slider::wheelEvent(QWheelEvent* event) {
  event->ignore();
}

}  // namespace surefoot

#include "moc_slider.cpp"
