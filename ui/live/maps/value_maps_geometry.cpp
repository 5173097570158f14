// SPDX-License-Identifier: GPL-3.0-or-later
// Where the maps and their bars lie: the small ones beside the large one, or below it where they are wide and low.
#include <algorithm>
#include <cmath>

#include "ui/live/maps/value_maps.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

// [px], with texts of the usual size
constexpr double kLeft = 47, kTop = 24, kUnder = 48;  // around the large map
constexpr double kBarNumbers = 37;                    // width of a bar's numbers
constexpr double kBar = 10, kToBar = 8, kBetween = 8;
constexpr double kSmallTop = 28;  // from a map to the one below it, whose title stands between

}  // namespace

/// The room of a map whose cells fill as much of a square of this size as they can.
QRectF ValueMaps::areaOf(const QRectF& square) const {
  return ValueMap::area(life_.task(), {choice_.x, choice_.y, {}}, square);
}

ValueMaps::Geometry ValueMaps::geometry() const {
  const Geometry beside = besideEachOther(), stacked = belowEachOther();
  return stacked.big.width() > 1.2 * beside.big.width() ? stacked : beside;
}

ValueMaps::Geometry ValueMaps::besideEachOther() const {
  const bool oneBar = split() && valued();
  const double k = textScale(), left = k * kLeft, top = k * kTop, bar = kToBar + kBar + k * kBarNumbers;
  const double room = std::min((width() - left - (oneBar ? 2 * kToBar : bar) - bar + k * kSmallTop / 2) / 1.5,
                               height() - k * (kTop + kUnder));
  const double m = std::floor(std::max(room, 48.0) / kCell) * kCell;
  const double s = std::max(std::floor((m - k * kSmallTop) / 2 / kSmallCell) * kSmallCell, 16.0);
  Geometry g;
  g.square = QRectF(left, top, m, m);
  g.big = areaOf(g.square);
  const double x = g.square.right() + (oneBar ? 2 * kToBar : bar);
  g.upper = areaOf({x, top, s, s});
  g.lower = areaOf({x, g.upper.height() < s ? g.upper.bottom() + k * kSmallTop : top + m - s, s, s});
  g.bigBar = QRectF(oneBar ? x + s + kToBar : g.square.right() + kToBar, top, kBar, g.big.height());
  g.upperBar = QRectF(x + s + kToBar, top, kBar, g.upper.height());
  g.lowerBar = QRectF(x + s + kToBar, g.lower.top(), kBar, g.lower.height());
  g.bigBarRoom = x - g.bigBar.right() - 12;
  g.upperTitleEnd = g.lowerTitleEnd = width();
  g.key = {x, g.square.bottom() + k * 25};
  g.xTitle = {g.big.left(), x};
  return g;
}

ValueMaps::Geometry ValueMaps::belowEachOther() const {
  const double k = textScale(), left = k * kLeft, top = k * kTop, bar = kToBar + kBar + k * kBarNumbers;
  const QRectF unit = areaOf({0, 0, 1000, 1000});
  const double aspect = unit.width() / std::max(unit.height(), 1.0);
  const double high = (height() - k * (kTop + kUnder + kTop + kBetween)) * aspect / 1.5;
  const double m = std::floor(std::max(std::min(width() - left - bar, high), 48.0));
  Geometry g;
  g.big = areaOf({left, top, m, m});
  g.square = g.big;
  const double y = g.big.bottom() + k * (kUnder + kTop), s = std::max((m - bar) / 2, 16.0);
  g.upper = areaOf({left, y, s, s});
  g.lower = areaOf({left + s + bar, y, s, s});
  const auto beside = [](const QRectF& map) { return QRectF(map.right() + kToBar, map.top(), kBar, map.height()); };
  g.bigBar = beside(g.big), g.upperBar = beside(g.upper), g.lowerBar = beside(g.lower);
  g.bigBarRoom = width() - g.bigBar.right() - 6;
  g.upperTitleEnd = g.lower.left() - kBetween;
  g.lowerTitleEnd = width();
  const double key = symbolWidth(textFont(11), tr("no step yet")) + k * 22;
  g.key = {g.big.right() - key, g.square.bottom() + k * 25};
  g.xTitle = {g.big.left() + key, g.big.right() - key};
  return g;
}

}  // namespace surefoot
