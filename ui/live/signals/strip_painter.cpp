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

StripPainter::Want StripPainter::wantOf(const StripSignals& strip) {
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

}  // namespace surefoot
