// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/signals/strip_painter.h"

#include <algorithm>
#include <cmath>

#include "core/signals/strides.h"
#include "core/text/text.h"
#include "ui/style/round_numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr double kNames = 150, kNumbers = 76;           // columns at the left and the right [px]
constexpr double kTop = 14, kTimes = 28, kBetween = 6;  // above, the time axis below, between strips [px]
constexpr double kRowHeight = 16;                       // of an on/off signal [px]
constexpr int kText = 11, kName = 12;                   // sizes of texts [px]

/// How much of the room a strip wants, and what it needs at least [px].
struct Want {
  double share, least;
};
Want wantOf(const StripSignals& strip) {
  switch (strip.look) {
    case StripLook::OnOff: {
      const double rows = static_cast<double>(std::max<std::size_t>(1, strip.places.size()));
      return {0.0, kRowHeight * rows};
    }
    case StripLook::Steps:
      return {0.8, 18};
    case StripLook::Filled:
      return {1.0, 20};
    default:
      return {1.5, 27};
  }
}

QString numberText(double value, double step) {
  if (std::isnan(value)) return QStringLiteral("–");
  const int decimals = step >= 10 ? 0 : std::clamp(static_cast<int>(std::ceil(-std::log10(step))) + 1, 0, 6);
  return toText(decimals == 0 ? countText(std::round(value)) : fixedText(value, decimals));
}

QString axisText(double value, double step) {
  const int decimals = step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
  return toText(decimals == 0 || value == 0.0 ? countText(value) : fixedText(value, decimals));
}

}  // namespace

double StripPainter::leastHeight(const StripPicture& picture) {
  double height = kTop + kTimes;
  for (const Strip& strip : picture.strips)
    height += kBetween + wantOf(signalsIn(strip, picture.table->signals())).least;
  return height;
}

StripPainter::StripPainter(const Theme& theme, const StripPicture& picture, const QRectF& area)
    : theme_(theme),
      picture_(picture) {
  plot_ = area.adjusted(kNames + 40, kTop, -kNumbers, -kTimes);
  double shares = 0.0, least = 0.0;
  for (const Strip& strip : picture.strips) {
    signals_.push_back(signalsIn(strip, picture.table->signals()));
    shares += wantOf(signals_.back()).share;
    least += kBetween + wantOf(signals_.back()).least;
  }
  const double rest = std::max(0.0, plot_.height() - least);
  double y = plot_.top();
  for (const StripSignals& strip : signals_) {
    const Want want = wantOf(strip);
    const double height = want.least + (shares > 0 ? rest * want.share / shares : 0.0);
    places_.emplace_back(area.left(), y + kBetween / 2, area.width(), height);
    y += kBetween + height;
  }
}

std::pair<std::size_t, std::size_t> StripPainter::rowsOf(const SignalTable& table) const {
  if (table.rows() == 0) return {0, 0};
  const std::vector<double>& time = table.columns()[0];
  auto from = std::lower_bound(time.begin(), time.end(), picture_.from);
  auto to = std::upper_bound(from, time.end(), picture_.to);
  if (from != time.begin()) --from;
  if (to != time.end()) ++to;
  return {static_cast<std::size_t>(from - time.begin()), static_cast<std::size_t>(to - time.begin())};
}

StripPainter::Range StripPainter::rangeOf(const StripSignals& strip, double height) const {
  double low = kInfinity, high = -kInfinity;
  const auto include = [&](double value) {
    if (!std::isnan(value)) low = std::min(low, value), high = std::max(high, value);
  };
  for (const SignalTable* table : {picture_.table, picture_.second}) {
    if (!table || table->columns().empty()) continue;
    const auto [from, to] = rowsOf(*table);
    for (std::size_t row = from; row < to; ++row) {
      double above = 0.0, below = 0.0;
      for (const std::size_t at : strip.places) {
        const double value = table->columns()[at][row];
        include(value);
        (value > 0 ? above : below) += std::isnan(value) ? 0.0 : value;
      }
      if (strip.look == StripLook::Stacked) include(above), include(below);
    }
  }
  if (low > high) low = 0.0, high = 1.0;
  if (strip.look == StripLook::Bars || strip.look == StripLook::Stacked || strip.look == StripLook::Filled)
    include(0.0);
  if (high - low < 1e-9 * std::max(1.0, std::abs(high))) low -= 0.5, high += 0.5;
  const double room = 0.06 * (high - low);
  const double step = niceAbove((high - low) / std::max(1.0, height / 15.0));
  return {low - room, high + room, step};
}

void StripPainter::paint(QPainter& p) const {
  p.setRenderHint(QPainter::Antialiasing);
  if (picture_.band) {
    const double from = std::max(plot_.left(), xOf(picture_.band->first));
    const double to = std::min(plot_.right(), xOf(picture_.band->second));
    if (to > from) p.fillRect(QRectF(from, plot_.top() - 8, to - from, plot_.height() + 8), theme_.fill);
  }
  drawTimes(p);
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    const StripSignals& strip = signals_[i];
    const QRectF where(plot_.left(), places_[i].top(), plot_.width(), places_[i].height());
    drawName(p, strip, where);
    if (strip.places.empty()) continue;
    const Range range = rangeOf(strip, where.height());
    if (strip.look == StripLook::OnOff) {
      drawOnOff(p, strip, where);
    } else {
      drawAxis(p, where, range);
      p.save();
      p.setClipRect(where.adjusted(0, -2, 0, 2));
      if (picture_.second && picture_.second->rows() > 0 && strip.look != StripLook::Stacked &&
          strip.look != StripLook::Bars)
        for (std::size_t s = 0; s < strip.places.size(); ++s) {
          QPen pen(theme_.quiet, 1);
          pen.setDashPattern({4, 3});
          p.setPen(pen);
          drawCurve(p, *picture_.second, strip.places[s], where, range,
                    strip.look == StripLook::Filled ? StripLook::Lines : strip.look);
        }
      if (strip.look == StripLook::Bars || strip.look == StripLook::Stacked)
        drawBars(p, strip, where, range);
      else
        for (std::size_t s = strip.places.size(); s-- > 0;) {
          p.setPen(QPen(colourOf(strip, s), s == 0 ? 1.5 : 1.1));
          drawCurve(p, *picture_.table, strip.places[s], where, range, strip.look);
        }
      p.restore();
    }
    drawNumbers(p, strip, where, range);
  }
  drawMoment(p);
}

QColor StripPainter::colourOf(const StripSignals& strip, std::size_t index) const {
  const Signal& s = picture_.table->signals()[strip.places[index]];
  if (strip.look == StripLook::Stacked) {
    const QColor colours[] = {theme_.accent, theme_.outline, theme_.quiet, theme_.caution};
    return s.key.ends_with("_fall") ? theme_.fall : colours[(strip.places.size() - 1 - index) % 4];
  }
  if (s.key == "value") return picture_.learner;
  if (s.key == "risk") return theme_.fall;
  return index == 0 ? theme_.ink : index == 1 ? theme_.disabled : theme_.accent;
}

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

void StripPainter::drawCurve(QPainter& p, const SignalTable& table, std::size_t place, const QRectF& where,
                             const Range& range, StripLook look) const {
  if (place >= table.columns().size()) return;
  const std::vector<double>&time = table.columns()[0], &values = table.columns()[place], &episode = table.columns()[1];
  const auto [from, to] = rowsOf(table);
  const auto yOf = [&](double v) {
    return where.bottom() - (v - range.low) / (range.high - range.low) * where.height();
  };
  QPolygonF piece;
  const auto flush = [&] {
    if (look == StripLook::Filled && piece.size() > 1) {
      QPolygonF area = piece;
      area << QPointF(piece.back().x(), yOf(0)) << QPointF(piece.front().x(), yOf(0));
      const QPen pen = p.pen();
      p.setPen(Qt::NoPen);
      p.setBrush(theme_.fill);
      p.drawPolygon(area);
      p.setBrush(Qt::NoBrush);
      p.setPen(pen);
    }
    if (piece.size() > 1) p.drawPolyline(piece);
    piece.clear();
  };
  // More than two rows a pixel: of those, the least and the largest.
  const bool dense = static_cast<double>(to - from) > 2.5 * plot_.width();
  double pixel = -1, least = 0, most = 0;
  if (dense) {  // smooth lines would cost the learner speed, and look no better
    QPen thin = p.pen();
    thin.setWidthF(1);
    thin.setCosmetic(true);
    p.setPen(thin);
  }
  p.setRenderHint(QPainter::Antialiasing, !dense);
  for (std::size_t row = from; row < to; ++row) {
    if (row > from && (episode[row] != episode[row - 1] || comesAfterAGap(table, row))) flush(), pixel = -1;
    if (std::isnan(values[row])) {
      flush();
      continue;
    }
    const double x = xOf(time[row]), y = yOf(values[row]);
    if (dense) {
      if (std::floor(x) != pixel) {
        pixel = std::floor(x), least = most = y;
        piece << QPointF(x, y);
      } else if (y < least || y > most) {
        least = std::min(least, y), most = std::max(most, y);
        piece << QPointF(x, y);
      }
      continue;
    }
    if (look == StripLook::Steps && !piece.isEmpty()) piece << QPointF(x, piece.back().y());
    piece << QPointF(x, y);
  }
  flush();
  p.setRenderHint(QPainter::Antialiasing);
}

void StripPainter::drawBars(QPainter& p, const StripSignals& strip, const QRectF& where, const Range& range) const {
  const SignalTable& table = *picture_.table;
  const std::vector<double>& time = table.columns()[0];
  const auto [from, to] = rowsOf(table);
  if (to <= from + 1) return;
  const auto yOf = [&](double v) {
    return where.bottom() - (v - range.low) / (range.high - range.low) * where.height();
  };
  const double wide = plot_.width() * static_cast<double>(1) / std::max(1.0, static_cast<double>(to - from));
  const double bar = std::clamp(0.7 * wide, 1.0, 8.0);
  p.setRenderHint(QPainter::Antialiasing, false);
  for (std::size_t row = from; row < to; ++row) {
    double above = 0.0, below = 0.0;
    for (std::size_t s = 0; s < strip.places.size(); ++s) {
      const double value = table.columns()[strip.places[s]][row];
      if (std::isnan(value) || value == 0.0) continue;
      double& begin = value > 0 ? above : below;
      const QColor colour = strip.look == StripLook::Stacked ? colourOf(strip, s)
                            : value > 0                      ? theme_.accent
                                                             : theme_.fall;
      const double a = yOf(begin), b = yOf(begin + value);
      p.fillRect(QRectF(xOf(time[row]) - bar / 2, std::min(a, b), bar, std::abs(b - a)), colour);
      if (strip.look == StripLook::Stacked) begin += value;
    }
  }
  p.setRenderHint(QPainter::Antialiasing, true);
}

void StripPainter::drawOnOff(QPainter& p, const StripSignals& strip, const QRectF& where) const {
  const SignalTable& table = *picture_.table;
  const std::vector<double>& time = table.columns()[0];
  const auto [from, to] = rowsOf(table);
  p.save();
  p.setClipRect(where);
  for (std::size_t s = 0; s < strip.places.size(); ++s) {
    const std::vector<double>& values = table.columns()[strip.places[s]];
    const double y = where.top() + kRowHeight * static_cast<double>(s) + 2;
    const bool right = footOf(table.signals()[strip.places[s]]) == Foot::Right;
    for (std::size_t row = from; row < to;) {
      if (values[row] != 1.0) {
        ++row;
        continue;
      }
      std::size_t end = row;
      while (end < to && values[end] == 1.0 && (end == row || !comesAfterAGap(table, end))) ++end;
      const double until = time[end - 1] + table.stepTime();
      const QRectF bar(xOf(time[row]), y, std::max(1.5, xOf(until) - xOf(time[row])), kRowHeight - 4);
      p.setPen(Qt::NoPen);
      p.setBrush(right ? theme_.disabled : theme_.ink);
      p.drawRoundedRect(bar, 2, 2);
      row = end;
    }
  }
  p.setBrush(Qt::NoBrush);
  p.restore();
}

std::optional<std::size_t> StripPainter::secondRow() const {
  if (!picture_.second || !picture_.row || *picture_.row >= picture_.second->rows()) return std::nullopt;
  return picture_.row;
}

void StripPainter::drawNumbers(QPainter& p, const StripSignals& strip, const QRectF& where, const Range& range) const {
  if (!picture_.row || *picture_.row >= picture_.table->rows()) return;
  const QRectF column(plot_.right() + 4, 0, kNumbers - 12, 16);
  const auto write = [&](double y, const SignalTable& table, std::size_t row, std::size_t place, bool strong) {
    const double value = table.columns()[place][row];
    const bool onOff = table.signals()[place].kind == Signal::Kind::OnOff;
    p.setFont(textFont(kName, strong ? 500 : 400));
    p.setPen(strong ? theme_.ink : theme_.quiet);
    drawSymbol(p, column.translated(0, y), Qt::AlignRight,
               onOff ? value == 1.0 ? QObject::tr("on") : QObject::tr("off") : numberText(value, range.step));
  };
  if (strip.look == StripLook::OnOff) {
    for (std::size_t s = 0; s < strip.places.size(); ++s)
      write(where.top() + kRowHeight * static_cast<double>(s), *picture_.table, *picture_.row, strip.places[s], s == 0);
    return;
  }
  const auto second = secondRow();
  const std::size_t lines = second && strip.places.size() == 1 ? 2 : std::min<std::size_t>(strip.places.size(), 2);
  const bool both = lines > 1 && where.height() >= 26;
  const double y = where.center().y() - (both ? 15 : 8);
  write(y, *picture_.table, *picture_.row, strip.places[0], true);
  if (!both) return;
  if (strip.places.size() > 1) return write(y + 15, *picture_.table, *picture_.row, strip.places[1], false);
  write(y + 15, *picture_.second, *second, strip.places[0], false);
}

void StripPainter::drawMoment(QPainter& p) const {
  if (!picture_.row || *picture_.row >= picture_.table->rows()) return;
  const double time = picture_.table->columns()[0][*picture_.row], x = std::round(xOf(time)) + 0.5;
  if (x < plot_.left() - 1 || x > plot_.right() + 1) return;
  p.setPen(QPen(theme_.ink, 1));
  p.drawLine(QPointF(x, plot_.top() - 6), QPointF(x, plot_.bottom()));
  const QString text = picture_.clock ? QObject::tr("%1 s").arg(toText(fixedText(time, 2)))
                                      : QObject::tr("step %1").arg(toText(countText(time)));
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
