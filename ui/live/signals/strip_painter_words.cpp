// SPDX-License-Identifier: GPL-3.0-or-later
// What stands around the curves: names, axes, the numbers of the moment.
#include <QObject>
#include <algorithm>
#include <cmath>

#include "core/signals/strides.h"
#include "core/text/text.h"
#include "ui/language/numbers.h"
#include "ui/live/signals/strip_painter.h"
#include "ui/style/round_numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr int kText = 11, kName = 12;  // sizes of texts [px]

QString numberText(double value, double step) {
  if (std::isnan(value)) return QStringLiteral("–");
  const int decimals = step >= 10 ? 0 : std::clamp(static_cast<int>(std::ceil(-std::log10(step))) + 1, 0, 6);
  return localNumbers(decimals == 0 ? countText(std::round(value)) : fixedText(value, decimals));
}

QString axisText(double value, double step) {
  const int decimals = step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
  return localNumbers(decimals == 0 || value == 0.0 ? countText(value) : fixedText(value, decimals));
}

}  // namespace

void StripPainter::drawTimes(QPainter& p) const {
  p.setFont(textFont(kText));
  const double base = std::round(plot_.bottom()) + 0.5;
  const double step = niceAbove(span() / std::max(2.0, plot_.width() / 90.0));
  for (double t = std::ceil(picture_.from / step - 1e-9) * step; t <= picture_.to + 1e-9; t += step) {
    const double x = std::round(xOf(t)) + 0.5;
    p.setPen(QPen(theme_.hairline, 1));
    p.drawLine(QPointF(x, plot_.top()), QPointF(x, base));
    p.setPen(QPen(theme_.outline, 1));
    p.drawLine(QPointF(x, base), QPointF(x, base + 4));
    p.setPen(theme_.quiet);
    QString text = axisText(t, step);
    const bool first = t - step < picture_.from;
    if (first) text += picture_.clock ? QObject::tr(" s") : QObject::tr(" steps");
    drawSymbol(p, QRectF(x - 50, base + 5, 100, 16), Qt::AlignHCenter, text);
  }
  p.setPen(QPen(theme_.outline, 1));
  p.drawLine(QPointF(plot_.left(), base), QPointF(plot_.right(), base));
}

void StripPainter::drawName(QPainter& p, const StripSignals& strip, const QRectF& where) const {
  const auto& signals = picture_.table->signals();
  const double left = 12, width = kNames - left;
  const bool tall = where.height() >= 26;
  const QString title = titleOf(strip, signals), unit = unitOf(strip, signals);
  const auto line = [&](double y, int size, const QColor& ink, const QString& text, double x = 0.0) {
    p.setFont(textFont(size));
    p.setPen(ink);
    drawSymbol(p, QRectF(left + x, y, width - x, 16), Qt::AlignLeft,
               QFontMetricsF(p.font()).elidedText(text, Qt::ElideRight, width - x));
  };
  if (strip.places.empty()) return line(where.center().y() - 8, kName, theme_.quiet, QObject::tr("not known here"));
  if (strip.look == StripLook::OnOff) {
    p.setFont(textFont(kName));
    if (strip.places.size() > 1) line(where.top(), kName, theme_.ink, title);
    for (std::size_t i = 0; i < strip.places.size(); ++i) {
      p.setFont(textFont(kText));
      p.setPen(theme_.quiet);
      const QRectF at(left, where.top() + kRowHeight * static_cast<double>(i), kNames + 32 - left, kRowHeight);
      const QString name = QFontMetricsF(p.font()).elidedText(nameIn(strip, signals[strip.places[i]]), Qt::ElideRight,
                                                              strip.places.size() > 1 ? kNames - 50 : kNames + 20);
      drawSymbol(p, at, strip.places.size() > 1 ? Qt::AlignRight : Qt::AlignLeft, name);
    }
    return;
  }
  const double y = where.center().y() - (tall ? 15 : 8);
  const bool legend = strip.places.size() > 1;
  line(y, kName, theme_.ink, tall || unit.isEmpty() ? title : title + QStringLiteral("  ") + unit);
  if (!tall) return;
  if (!legend) return line(y + 15, kText, theme_.quiet, unit);
  double x = 0.0;
  p.setFont(textFont(kText));
  for (std::size_t i = 0; i < strip.places.size(); ++i) {
    const QString name = nameIn(strip, signals[strip.places[i]]);
    const double wide = symbolWidth(p.font(), name);
    if (x > 0 && x + 12 + wide > width + 30) break;
    p.fillRect(QRectF(left + x, y + 20, 8, strip.look == StripLook::Stacked ? 7 : 2.5), colourOf(strip, i));
    p.setPen(theme_.quiet);
    drawSymbol(p, QRectF(left + x + 11, y + 15, width + 34 - x, 16), Qt::AlignLeft,
               QFontMetricsF(p.font()).elidedText(name, Qt::ElideRight, width + 20 - x));
    x += wide + 20;
  }
}

void StripPainter::drawAxis(QPainter& p, const QRectF& where, const Range& range) const {
  p.setFont(textFont(kText));
  const double h = 14;
  double last = kInfinity;
  for (double v = std::ceil(range.low / range.step - 1e-9) * range.step; v <= range.high + 1e-12; v += range.step) {
    const double y = std::round(where.bottom() - (v - range.low) / (range.high - range.low) * where.height()) + 0.5;
    p.setPen(QPen(std::abs(v) < range.step / 2 ? theme_.outline : theme_.hairline, 1));
    p.drawLine(QPointF(plot_.left(), y), QPointF(plot_.right(), y));
    if (last - y < h - 1) continue;
    last = y;
    p.setPen(theme_.quiet);
    const double value = std::abs(v) < range.step / 2 ? 0.0 : v;
    drawSymbol(p, QRectF(plot_.left() - 62, y - h / 2, 54, h), Qt::AlignRight, axisText(value, range.step));
  }
}

/// Which line is whose, in the corner below the names.
void StripPainter::drawLegend(QPainter& p) const {
  if (!second()) return;
  constexpr double kLine = 20, kHeight = 13;
  const QPen pens[] = {QPen(theme_.ink, 1.5), secondPen(theme_.ink)};
  const double left = 12, room = kNames + 14 - left - kLine;
  p.setFont(textFont(kText));
  for (int i = 0; i < 2; ++i) {
    const double y = plot_.bottom() + 1 + kHeight * i;
    p.setPen(pens[i]);
    p.drawLine(QPointF(left, y + 7), QPointF(left + kLine - 6, y + 7));
    p.setPen(theme_.quiet);
    drawSymbol(p, QRectF(left + kLine, y, room, kHeight), Qt::AlignLeft,
               QFontMetricsF(p.font()).elidedText(picture_.names[i], Qt::ElideRight, room));
  }
}

/// The second's row of the moment; none: it did not live then.
std::optional<std::size_t> StripPainter::secondRow() const {
  const auto life = second();
  if (!life || !picture_.row || *picture_.row >= picture_.table->rows()) return std::nullopt;
  return rowAt(life->table, picture_.table->columns()[0][*picture_.row] - life->later);
}

void StripPainter::drawNumbers(QPainter& p, const StripSignals& strip, const QRectF& where, const Range& range) const {
  if (!picture_.row || *picture_.row >= picture_.table->rows()) return;
  const QRectF column(plot_.right() + 4, 0, kNumbers - 12, 16);
  const auto write = [&](double y, const Life& life, std::size_t row, std::size_t place, bool strong) {
    const auto* values = columnOf(life, place);
    if (!values) return;
    const double value = (*values)[row];
    const bool onOff = picture_.table->signals()[place].kind == Signal::Kind::OnOff;
    p.setFont(textFont(kName, strong ? 500 : 400));
    p.setPen(strong ? theme_.ink : theme_.quiet);
    drawSymbol(p, column.translated(0, y), Qt::AlignRight,
               onOff ? value == 1.0 ? QObject::tr("on") : QObject::tr("off") : numberText(value, range.step));
  };
  if (strip.look == StripLook::OnOff) {
    for (std::size_t s = 0; s < strip.places.size(); ++s)
      write(where.top() + kRowHeight * static_cast<double>(s), first(), *picture_.row, strip.places[s], s == 0);
    return;
  }
  const auto at = secondRow();
  const std::size_t lines = at && strip.places.size() == 1 ? 2 : std::min<std::size_t>(strip.places.size(), 2);
  const bool both = lines > 1 && where.height() >= 26;
  const double y = where.center().y() - (both ? 15 : 8);
  write(y, first(), *picture_.row, strip.places[0], true);
  if (!both) return;
  if (strip.places.size() > 1) return write(y + 15, first(), *picture_.row, strip.places[1], false);
  write(y + 15, *second(), *at, strip.places[0], false);
}

void StripPainter::drawMoment(QPainter& p) const {
  if (!picture_.row || *picture_.row >= picture_.table->rows()) return;
  const double time = picture_.table->columns()[0][*picture_.row], x = std::round(xOf(time)) + 0.5;
  if (x < plot_.left() - 1 || x > plot_.right() + 1) return;
  p.setPen(QPen(theme_.ink, 1));
  p.drawLine(QPointF(x, plot_.top() - 6), QPointF(x, plot_.bottom()));
  const QString text =
      picture_.clock ? QObject::tr("%1 s").arg(fixedNumber(time, 2)) : QObject::tr("step %1").arg(countNumber(time));
  p.setFont(textFont(kText, 500));
  const double w = symbolWidth(p.font(), text) + 12;
  const QRectF box(std::clamp(x - w / 2, plot_.left() - 20, plot_.right() + 20 - w), plot_.bottom() + 3, w, 19);
  p.setPen(Qt::NoPen);
  p.setBrush(theme_.ink);
  p.drawRoundedRect(box, 3, 3);
  p.setBrush(Qt::NoBrush);
  p.setPen(theme_.panel);
  drawSymbol(p, box, Qt::AlignHCenter, text);
}

}  // namespace surefoot
