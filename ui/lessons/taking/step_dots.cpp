// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/step_dots.h"

#include <algorithm>
#include <cmath>

#include "ui/style/theme.h"

namespace surefoot {

void StepDots::show(std::size_t current, std::size_t steps) {
  current_ = current, steps_ = std::max<std::size_t>(steps, 1);
  update();
}

void StepDots::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const double pitch = std::min(24.0, (width() - 12.0) / static_cast<double>(steps_)), y = 8;
  for (std::size_t i = 0; i < steps_; ++i) {
    const double x = 6.5 + pitch * static_cast<double>(i);
    const bool done = i < current_;
    if (i + 1 < steps_) {
      p.setPen(QPen(done ? t.ink : t.track, 1.5));
      p.drawLine(QPointF(x + 6, y), QPointF(x + pitch - 6, y));
    }
    p.setPen(QPen(done || i == current_ ? t.ink : t.outline, 1.5));
    p.setBrush(done ? t.ink : t.panel);
    p.drawEllipse(QPointF(x, y), i == current_ ? 5.25 : done ? 3.5 : 3.25, i == current_ ? 5.25 : done ? 3.5 : 3.25);
    if (i != current_) continue;
    p.setBrush(t.ink);
    p.setPen(Qt::NoPen);
    p.drawEllipse(QPointF(x, y), 2.5, 2.5);
  }
}

void drawProgressRing(QPainter& p, const QPointF& centre, double done, bool onFill, const Theme& t) {
  constexpr double kRadius = 8;
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  if (done >= 1) {
    p.setPen(Qt::NoPen);
    p.setBrush(t.ink);
    p.drawEllipse(centre, kRadius, kRadius);
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(t.panel, 1.75, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    p.drawPolyline(QPolygonF({centre + QPointF(-3.5, 0.2), centre + QPointF(-1, 2.8), centre + QPointF(3.6, -2.6)}));
  } else {
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(onFill ? t.quiet : t.outline, 1.25));
    p.drawEllipse(centre, kRadius - 0.6, kRadius - 0.6);
    p.setPen(QPen(t.ink, 2.75, Qt::SolidLine, Qt::FlatCap));
    const QRectF box(centre.x() - kRadius + 1.2, centre.y() - kRadius + 1.2, 2 * kRadius - 2.4, 2 * kRadius - 2.4);
    if (done > 0) p.drawArc(box, 90 * 16, -static_cast<int>(std::lround(done * 360 * 16)));
  }
  p.restore();
}

}  // namespace surefoot

#include "moc_step_dots.cpp"
