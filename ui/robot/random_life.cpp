// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robot/random_life.h"

#include <algorithm>
#include <cmath>

#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/style/round_numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

RandomLife::RandomLife(QWidget* parent) : Painted(parent) {
  setAccessibleName(tr("What a random life looks like"));
}

void RandomLife::setInspection(const EnvironmentInspection* inspection) {
  inspection_ = inspection;
  if (inspection_)
    setAccessibleDescription(
        tr("%n falls; %1", nullptr, static_cast<int>(inspection_->falls.size())).arg(fromCore(inspection_->verdict)));
  update();
}

void RandomLife::paintEvent(QPaintEvent*) {
  ScaledPainter p(this);
  const Theme& t = themeOf(*this);
  p.fillRect(rect(), t.panel);
  if (!inspection_ || inspection_->trace.empty()) return;
  p.setRenderHint(QPainter::Antialiasing);
  drawTrace(p);
  drawFacts(p);
}

void RandomLife::drawTrace(QPainter& p) const {
  const Theme& t = themeOf(*this);
  const QRectF r = plot();
  const auto shown = std::min<std::size_t>(kShown, inspection_->trace.size());
  const auto end = inspection_->trace.begin() + static_cast<std::ptrdiff_t>(shown);
  auto [lowest, highest] = std::minmax_element(inspection_->trace.begin(), end);
  const double low = *lowest, high = std::max(*highest, low + 1e-6), band = 0.08 * (high - low);
  const auto yAt = [&](double v) { return r.bottom() - (v - low + band) / (high - low + 2 * band) * r.height(); };
  p.setFont(textFont(11));
  const double middle = low < -0.2 * (high - low) && high > 0.2 * (high - low) ? 0.0 : 0.5 * (low + high);
  for (const double v : {low, middle, high}) {
    p.setPen(QPen(t.hairline, 1));
    p.drawLine(QPointF(r.left(), yAt(v)), QPointF(r.right(), yAt(v)));
    p.setPen(t.quiet);
    p.drawText(QRectF(0, yAt(v) - 8, r.left() - 6, 16), Qt::AlignRight | Qt::AlignVCenter, fixedNumber(v, 2));
  }
  p.setPen(QPen(t.quiet, 1));
  p.drawLine(r.bottomLeft(), r.bottomRight());
  for (int step = 0; step <= kShown; step += 250)  // the last one ends where the plot ends
    p.drawText(QRectF(xAt(step) - (step == kShown ? 80 : 40), r.bottom() + 4, 80, 16),
               step == kShown ? Qt::AlignRight : Qt::AlignHCenter, countNumber(step));
  p.drawText(QRectF(r.left(), r.bottom() + 20, r.width(), 16), Qt::AlignHCenter,
             tr("steps; %1 s in all").arg(fixedNumber(kShown * inspection_->stepTime, 0)));
  p.save();
  p.translate(10, r.center().y());
  p.rotate(-90);
  p.drawText(QRectF(-100, -8, 200, 16), Qt::AlignCenter, toText(inspection_->traceTitle));
  p.restore();
  p.setPen(QPen(t.ink, 1.25));
  std::size_t begin = 0;
  for (std::size_t e = 1; e <= inspection_->begins.size() && begin < shown; ++e) {
    const std::size_t next = e < inspection_->begins.size() ? static_cast<std::size_t>(inspection_->begins[e]) : shown;
    QPolygonF line;
    for (std::size_t i = begin; i < std::min(next, shown); ++i)
      line << QPointF(xAt(static_cast<double>(i + 1)), yAt(inspection_->trace[i]));
    p.drawPolyline(line);
    begin = next;
  }
  p.setPen(QPen(t.fall, 1.5));
  for (const int fall : inspection_->falls)
    if (fall <= kShown) p.drawLine(QPointF(xAt(fall), r.bottom()), QPointF(xAt(fall), r.bottom() - 8));
}

void RandomLife::drawFacts(QPainter& p) const {
  const Theme& t = themeOf(*this);
  const double left = width() - 214, right = width() - 12;
  double y = 8;
  const auto fact = [&](const QString& name, const QString& number, const QString& unit, const QColor& colour) {
    const double room = right - left - 8 - QFontMetricsF(textFont(13, 500)).horizontalAdvance(number + unit);
    p.setFont(textFont(13));
    p.setPen(t.quiet);
    p.drawText(QRectF(left, y, right - left, 26), Qt::AlignLeft | Qt::AlignVCenter,
               QFontMetricsF(p.font()).elidedText(name, Qt::ElideRight, room));
    p.setPen(colour);
    p.setFont(textFont(13, 500));
    p.drawText(QRectF(left, y, right - left, 26), Qt::AlignRight | Qt::AlignVCenter, number + unit);
    y += 26;
  };
  const auto falls = static_cast<int>(inspection_->falls.size());
  fact(tr("Falls in %1 steps").arg(countNumber(inspection_->steps)), QString::number(falls), {},
       falls > 0 ? t.fallText : t.ink);
  if (falls > 0) fact(tr("To a fall, median"), fixedNumber(inspection_->medianToFall, 1), tr(" s"), t.ink);
  if (inspection_->longest > 0) fact(tr("Longest"), fixedNumber(inspection_->longest, 1), tr(" s"), t.ink);
  for (const auto& [joint, share] : inspection_->atLimits)
    if (y < height() - 60)
      fact(tr("At a limit of %1").arg(toText(joint)), fixedNumber(100 * share, 0), tr(" % of steps"), t.ink);
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  p.drawText(QRectF(left, height() - 36.0, right - left, 30), Qt::AlignLeft | Qt::TextWordWrap,
             fromCore(inspection_->verdict));
}

void RandomLife::mousePressEvent(QMouseEvent* event) {
  if (!inspection_) return;
  const double x = mouseAt(*event).x();
  int nearest = -1;
  double distance = 8;
  for (std::size_t i = 0; i < inspection_->falls.size(); ++i) {
    const int step = inspection_->falls[i];
    if (step <= kShown && std::abs(xAt(step) - x) < distance)
      distance = std::abs(xAt(step) - x), nearest = static_cast<int>(i);
  }
  if (nearest >= 0) Q_EMIT fallAsked(nearest);
}

}  // namespace surefoot

#include "moc_random_life.cpp"
