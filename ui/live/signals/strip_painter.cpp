// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/signals/strip_painter.h"

#include <algorithm>
#include <cmath>

#include "core/signals/strides.h"
#include "ui/style/round_numbers.h"
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

std::optional<StripPainter::Life> StripPainter::second() const {
  if (!picture_.second || picture_.second->rows() == 0) return std::nullopt;
  return Life{*picture_.second, picture_.secondLater, false};
}

const std::vector<double>* StripPainter::columnOf(const Life& life, std::size_t place) const {
  return columnLike(life.table, *picture_.table, place);
}

std::pair<std::size_t, std::size_t> StripPainter::rowsOf(const Life& life) const {
  if (life.table.rows() == 0) return {0, 0};
  const std::vector<double>& time = life.table.columns()[0];
  auto from = std::lower_bound(time.begin(), time.end(), picture_.from - life.later);
  auto to = std::upper_bound(from, time.end(), picture_.to - life.later);
  if (from != time.begin()) --from;
  if (to != time.end()) ++to;
  return {static_cast<std::size_t>(from - time.begin()), static_cast<std::size_t>(to - time.begin())};
}

StripPainter::Range StripPainter::rangeOf(const StripSignals& strip, double height) const {
  double low = kInfinity, high = -kInfinity;
  const auto include = [&](double value) {
    if (!std::isnan(value)) low = std::min(low, value), high = std::max(high, value);
  };
  for (const std::optional<Life>& life : {std::optional(first()), second()}) {
    if (!life) continue;
    std::vector<const std::vector<double>*> columns;
    for (const std::size_t at : strip.places)
      if (const auto* column = columnOf(*life, at)) columns.push_back(column);
    const auto [from, to] = rowsOf(*life);
    for (std::size_t row = from; row < to; ++row) {
      double above = 0.0, below = 0.0;
      for (const auto* column : columns) {
        const double value = (*column)[row];
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
    drawStrip(p, strip, where, range);
    drawNumbers(p, strip, where, range);
  }
  drawLegend(p);
  drawMoment(p);
}

void StripPainter::paintTimes(QPainter& p) const {
  p.setRenderHint(QPainter::Antialiasing);
  drawTimes(p);
  drawLegend(p);
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

}  // namespace surefoot
