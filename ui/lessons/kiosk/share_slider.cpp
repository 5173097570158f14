// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/kiosk/share_slider.h"

#include <QAccessible>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "ui/style/theme.h"
#include "ui/support/keyboard.h"

namespace surefoot {

namespace {
constexpr double kBeside = 24, kTrackAt = 24, kKnob = 15;  // [px]
constexpr int kStops = 24;
}  // namespace

ShareSlider::ShareSlider(QWidget* parent) : Painted(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("How much they explore, in 100 steps"));
  setCursor(Qt::PointingHandCursor);
}

void ShareSlider::setShare(double share) {
  share_ = std::clamp(std::round(share * 100) / 100, 0.0, kMost);
  setAccessibleDescription(tr("%1 of 100").arg(std::lround(100 * share_)));
  QAccessibleValueChangeEvent changed(this, static_cast<int>(std::lround(100 * share_)));
  QAccessible::updateAccessibility(&changed);
  update();
}

void ShareSlider::move(int steps) {
  const double before = share_, at = std::round(std::sqrt(share_ / kMost) * kStops) + steps;
  double share = kMost * std::pow(std::clamp(at / kStops, 0.0, 1.0), 2);
  if (std::abs(share - before) < 0.01) share = before + 0.01 * steps;
  setShare(share);
  if (share_ != before) Q_EMIT moved(share_);
}

double ShareSlider::xOf(double share) const {
  return kBeside + std::sqrt(share / kMost) * (width() - 2 * kBeside);
}

void ShareSlider::follow(const QMouseEvent& event) {
  const double part = std::clamp((mouseAt(event).x() - kBeside) / (width() - 2 * kBeside), 0.0, 1.0);
  setShare(kMost * part * part);
  Q_EMIT moved(share_);
}

void ShareSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) follow(*event);
}

void ShareSlider::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) follow(*event);
}

void ShareSlider::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Left && event->key() != Qt::Key_Right) return event->ignore();
  move(event->key() == Qt::Key_Left ? -1 : 1);
}

void ShareSlider::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const double knob = xOf(share_);
  p.setPen(QPen(t.track, 5, Qt::SolidLine, Qt::RoundCap));
  p.drawLine(QPointF(kBeside, kTrackAt), QPointF(width() - kBeside, kTrackAt));
  p.setPen(QPen(t.ink, 5, Qt::SolidLine, Qt::RoundCap));
  p.drawLine(QPointF(kBeside, kTrackAt), QPointF(knob, kTrackAt));
  const std::pair<double, QString> marks[] = {
      {0, tr("never")}, {0.02, "2"}, {0.1, "10"}, {0.25, "25"}, {kMost, tr("every second step")}};
  p.setFont(textFont(11));
  for (const auto& [share, words] : marks) {
    const double x = xOf(share), w = QFontMetricsF(p.font()).horizontalAdvance(words);
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(x, kTrackAt + 18), QPointF(x, kTrackAt + 24));
    p.setPen(t.quiet);
    const double left = std::clamp(x - w / 2, 0.0, width() - w - 1);
    p.drawText(QPointF(left, kTrackAt + 40), words);
  }
  p.setBrush(t.panel);
  p.setPen(QPen(hasFocus() ? t.accent : t.ink, 2));
  p.drawEllipse(QPointF(knob, kTrackAt), kKnob, kKnob);
  p.setPen(QPen(t.ink, 1.5, Qt::SolidLine, Qt::RoundCap));
  for (const double side : {-1.0, 1.0})
    p.drawPolyline(QPolygonF({QPointF(knob + side * 3.5, kTrackAt - 3.5), QPointF(knob + side * 7, kTrackAt),
                              QPointF(knob + side * 3.5, kTrackAt + 3.5)}));
}

}  // namespace surefoot

#include "moc_share_slider.cpp"
