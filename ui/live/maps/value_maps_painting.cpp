// SPDX-License-Identifier: GPL-3.0-or-later
// How the panel of value maps is drawn.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/live/maps/value_maps.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/style/round_numbers.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

/// Numbers at an axis, as many as can be read: the first one, and the step between two.
struct Ticks {
  double first, step;
  int decimals;
};

Ticks ticksOf(const StateVariable& v, double length, double room) {
  const double range = v.viewHigh - v.viewLow;
  double step = niceAbove(range * std::min(1.0, room / std::max(length, 1.0)));
  if (v.whole) step = std::max(1.0, step);
  return {std::ceil(v.viewLow / step) * step, step, step < 0.1 ? 2 : step < 1 ? 1 : 0};
}

/// The same text, shorter by whole parts, so that it fits.
QString fitted(const QFont& font, const StateVariable& v, double room) {
  for (const QString& text : {axisTitleOf(v), fromCore(v.title), symbolOf(v)})
    if (symbolWidth(font, text) <= room) return text;
  return {};
}

}  // namespace

/// 1, 10², 10⁴: equal steps from 1 to the end, at most as many as `lines`.
std::vector<double> powersOfTen(double end, double lines) {
  const int decades = static_cast<int>(std::lround(std::log10(end)));
  int step = 1;
  while (step < decades && (decades % step != 0 || decades / step + 1 > lines)) ++step;
  std::vector<double> numbers;
  for (int d = 0; d <= decades; d += step) numbers.push_back(std::pow(10.0, d));
  return numbers;
}

constexpr double kRiskNumbers[] = {0.0, 0.01, 0.1, 1.0};
const QString kRiskNames[] = {"0", "1", "10", "100"};

QString ValueMaps::title() const {
  switch (choice_.quantity) {
    case MapQuantity::GreedyAction:
      return tr("Greedy action");
    case MapQuantity::Risk:
      return tr("Risk");
    case MapQuantity::Visits:
      return tr("Visits");
    case MapQuantity::Eligibility:
      return tr("Eligibility");
    default:
      return QStringLiteral("Q");
  }
}

MapMarks ValueMaps::marks(double ring) const {
  return {.live = looking_.shown().state, .cursor = looking_.examined(), .ring = ring};
}

void ValueMaps::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.fillRect(rect(), t.panel);
  if (life_.task().state.empty()) return;
  const Geometry g = geometry();
  const double k = textScale();
  if (hasFocus()) {
    p.setPen(QPen(t.accent, 2));
    p.drawRect(g.big.adjusted(-2, -2, 2, 2));
  }
  if (!any_) {
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    p.drawText(g.square, Qt::AlignCenter | Qt::TextWordWrap, tr("The map appears with the first steps."));
    return;
  }
  const double cell = life_.task().state[static_cast<std::size_t>(choice_.x)].whole
                          ? 0.36 * g.big.width() / std::max(1, big_.columns())
                          : 100.0;
  const bool contour = valued() && life_.configuration().names.policy == "trl";
  drawTitles(p, g, t);
  const auto ways = directions();
  big_.draw(p, g.big, t, contour ? std::optional(life_.threshold()) : std::nullopt);
  if (const auto limit = riskLimit()) {
    if (valued()) big_.drawOutline(p, g.big, t, risk_, *limit);
    if (choice_.quantity == MapQuantity::Risk) big_.drawOutline(p, g.big, t, big_, *limit);
  }
  if (!ways.empty() && (valued() || choice_.quantity == MapQuantity::GreedyAction))
    big_.drawArrows(p, g.big, t, best_, ways);
  big_.drawMarks(p, g.big, t, life_.task(), marks(std::clamp(cell, 3.0, 6 * k)));
  drawBigBar(p, g, t);
  drawSmallMaps(p, g, t);
  drawFootprints(p, g, t);
  drawAxes(p, g, t);
  drawKey(p, g, t);
  drawReading(p, g, t);
}

/// A value never visited counts as below.
bool ValueMaps::thresholdCuts() const {
  const auto range = big_.range();
  return range && life_.threshold() < range->second && (life_.threshold() >= range->first || big_.anyNeverVisited());
}

/// Explains the contour, or says that there is none; the text is as long as the room allows.
void ValueMaps::drawThresholdNote(QPainter& p, const Geometry& g, const Theme& t) const {
  if (!valued() || life_.configuration().names.policy != "trl" || !big_.range()) return;
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  const double from = g.square.left() + symbolWidth(textFont(13, 500), title()) + 8;
  const bool below = life_.threshold() >= big_.range()->second;
  const QStringList texts = thresholdCuts() ? QStringList{tr("contour: threshold %1"), tr("threshold %1"), "%1"}
                            : below ? QStringList{tr("all values below threshold %1"), tr("all below %1"), "< %1"}
                                    : QStringList{tr("all values above threshold %1"), tr("all above %1"), "> %1"};
  for (const QString& text : texts) {
    const QString words = text.arg(countNumber(life_.threshold()));
    const double x = g.square.right() - symbolWidth(p.font(), words);
    if (x < from) continue;
    return drawSymbol(p, x, g.square.top() - 8 * textScale(), words);
  }
}

/// Says what the line around the risky states is.
void ValueMaps::drawLimitNote(QPainter& p, const Geometry& g, const Theme& t) const {
  const auto limit = riskLimit();
  if (!limit || (!valued() && choice_.quantity != MapQuantity::Risk)) return;
  if (valued() && life_.configuration().names.policy == "trl") return;  // the threshold's note stands there
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  const QString percent = localNumbers(QString::number(100 * *limit, 'g', 3)) + QStringLiteral(" %");
  const double from = g.square.left() + symbolWidth(textFont(13, 500), title()) + 8;
  for (const QString& text : {tr("contour: risk %1"), tr("risk %1"), QStringLiteral("%1")}) {
    const double x = g.square.right() - symbolWidth(p.font(), text.arg(percent));
    if (x >= from) return drawSymbol(p, x, g.square.top() - 8 * textScale(), text.arg(percent));
  }
}

/// The title of each map.
void ValueMaps::drawTitles(QPainter& p, const Geometry& g, const Theme& t) const {
  const bool parts = split() && valued();
  const auto write = [&](double x, double y, const QString& name, const QString& note, double right) {
    p.setFont(textFont(13, 500));
    p.setPen(t.ink);
    drawSymbol(p, x, y, name);
    const double end = x + symbolWidth(p.font(), name) + 6;
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    if (end + symbolWidth(p.font(), note) <= right) drawSymbol(p, end, y, note);
  };
  const double up = 8 * textScale();
  write(g.square.left(), g.square.top() - up, title(), {}, 0);
  drawThresholdNote(p, g, t);
  drawLimitNote(p, g, t);
  if (risky()) {
    write(g.upper.left(), g.upper.top() - up, tr("Risk"), QStringLiteral("%"), g.upperTitleEnd);
    return write(g.lower.left(), g.lower.top() - up, tr("Visits"), {}, g.lowerTitleEnd);
  }
  const bool goal = life_.task().goalReward.has_value();
  const auto& terms = life_.task().rewardTerms;
  const bool falls = std::find(terms.begin(), terms.end(), "fall") != terms.end();
  const bool fall = goal && falls && life_.task().timeReward == 0.0;
  write(g.upper.left(), g.upper.top() - up, parts ? QStringLiteral("Q⁺") : tr("Visits"),
        parts ? goal ? tr("goal") : tr("gains") : QString(), g.upperTitleEnd);
  write(g.lower.left(), g.lower.top() - up, parts ? QStringLiteral("Q⁻") : tr("Eligibility"),
        parts ? fall ? tr("fall") : tr("losses") : QString(), g.lowerTitleEnd);
}

void ValueMaps::drawBigBar(QPainter& p, const Geometry& g, const Theme& t) const {
  const Task& task = life_.task();
  std::vector<double> numbers;
  std::vector<QString> names;
  if (bigScale_.kind == MapScale::Kind::Steps) {
    for (std::size_t a = 0; a < greedyValues(choice_, task); ++a) {
      numbers.push_back(static_cast<double>(a));
      names.push_back(greedyNameOf(choice_, task, a));
    }
  } else if (bigScale_.kind == MapScale::Kind::Viridis) {
    numbers = {1, std::pow(10.0, std::floor(std::log10(bigScale_.high) / 2)), bigScale_.high};
  } else if (bigScale_.kind == MapScale::Kind::Positive) {
    numbers = {0, 0.5, 1};
  } else if (bigScale_.kind == MapScale::Kind::Risk) {
    numbers.assign(std::begin(kRiskNumbers), std::end(kRiskNumbers));
    names.assign(std::begin(kRiskNames), std::end(kRiskNames));
    names.back() += QStringLiteral(" %");
  } else {
    const double low = bigScale_.low, high = bigScale_.high, step = niceAbove((high - low) / 4.0001);
    numbers = {low, 0};
    for (double v = step * std::ceil(low / step); v < high; v += step)
      if (v > low && std::abs(v) > step / 2) numbers.push_back(v);
    numbers.push_back(high);
  }
  ValueMap::drawBar(p, g.bigBar, bigScale_, t, numbers, names, g.bigBarRoom);
  if (!valued() || life_.configuration().names.policy != "trl") return;
  const double share = bigScale_.position(life_.threshold());
  if (share < 0 || share > 1) return;  // the note at the title says where the threshold is
  const double y = g.bigBar.bottom() - share * g.bigBar.height();
  p.setPen(QPen(t.ink, 2));
  p.drawLine(QPointF(g.bigBar.left() - 1, y), QPointF(g.bigBar.right() + 1, y));
}

void ValueMaps::drawSmallMaps(QPainter& p, const Geometry& g, const Theme& t) const {
  const double ring = std::clamp(0.5 * g.upper.width() / std::max(1, upper_.columns()), 2.5, 4 * textScale());
  const double radius = life_.task().state[static_cast<std::size_t>(choice_.x)].whole ? ring : 4 * textScale();
  for (const auto& [map, square] : {std::pair(&upper_, &g.upper), std::pair(&lower_, &g.lower)}) {
    map->draw(p, *square, t);
    map->drawMarks(p, *square, t, life_.task(), marks(radius));
  }
  if (split() && valued()) return;
  const double lineHeight = QFontMetricsF(textFont(11)).height();
  const auto drawVisits = [&](const QRectF& bar) {
    ValueMap::drawBar(p, bar, visitScale_, t, powersOfTen(visitScale_.high, bar.height() / lineHeight));
  };
  if (risky()) {
    ValueMap::drawBar(p, g.upperBar, riskScale_, t, kRiskNumbers, kRiskNames);
    if (const auto limit = riskLimit()) {
      upper_.drawOutline(p, g.upper, t, upper_, *limit);
      const double y = g.upperBar.bottom() - riskScale_.position(*limit) * g.upperBar.height();
      p.setPen(QPen(t.ink, 2));
      p.drawLine(QPointF(g.upperBar.left() - 1, y), QPointF(g.upperBar.right() + 1, y));
    }
    return drawVisits(g.lowerBar);
  }
  drawVisits(g.upperBar);
  const double eligibilityNumbers[] = {0, 0.5, 1};
  ValueMap::drawBar(p, g.lowerBar, eligibilityScale_, t, eligibilityNumbers);
}

void ValueMaps::drawKey(QPainter& p, const Geometry& g, const Theme& t) const {
  const double k = textScale();
  const QRectF key(g.key, QSizeF(16 * k, 10 * k));
  ValueMap::drawHatching(p, key, t);
  p.setPen(QPen(t.outline, 1));
  p.drawRect(key);
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  drawSymbol(p, QRectF(key.right() + 6 * k, key.top() - 5 * k, 200, 20 * k), Qt::AlignLeft, tr("no step yet"));
}

void ValueMaps::drawNumbers(QPainter& p, const QRectF& m, const Theme& t, bool horizontal) const {
  const StateVariable& v = life_.task().state[static_cast<std::size_t>(horizontal ? choice_.x : choice_.y)];
  p.setFont(textFont(11));
  const double k = textScale(), height = QFontMetricsF(p.font()).height();
  const double length = horizontal ? m.width() : m.height();
  const double least = horizontal ? symbolWidth(p.font(), QStringLiteral("−0.0")) + 10 * k : 1.5 * height;
  const Ticks ticks = ticksOf(v, length, v.whole && horizontal ? 1.6 * height : least);
  for (double value = ticks.first; value <= v.viewHigh + 1e-9; value += ticks.step) {
    const double share = (value - v.viewLow) / (v.viewHigh - v.viewLow);
    const QString text = fixedNumber(value, ticks.decimals);
    p.setPen(QPen(t.outline, 1));
    if (horizontal) {
      const double at = m.left() + share * m.width();
      p.drawLine(QPointF(at, m.bottom()), QPointF(at, m.bottom() + 4));
      p.setPen(t.quiet);
      drawSymbol(p, QRectF(at - 30, m.bottom() + 4, 60, 16 * k), Qt::AlignHCenter, text);
    } else {
      const double at = m.bottom() - share * m.height();
      p.drawLine(QPointF(m.left() - 4, at), QPointF(m.left(), at));
      p.setPen(t.quiet);
      drawSymbol(p, QRectF(m.left() - 7 - 60, at - height / 2, 60, height), Qt::AlignRight, text);
    }
  }
}

void ValueMaps::drawAxes(QPainter& p, const Geometry& g, const Theme& t) const {
  const Task& task = life_.task();
  const double k = textScale();
  const auto& state = task.state;
  const StateVariable &x = state[static_cast<std::size_t>(choice_.x)], &y = state[static_cast<std::size_t>(choice_.y)];
  drawNumbers(p, g.big, t, true);
  p.setPen(t.quiet);
  drawSymbol(p, QRectF(g.big.left(), g.big.bottom() + 22 * k, g.big.width(), 16 * k), Qt::AlignHCenter,
             fitted(p.font(), x, g.xTitle.second - g.xTitle.first));
  if (slice_.strip()) return;
  drawNumbers(p, g.big, t, false);
  p.save();
  p.translate(g.big.left() - 40 * k, g.big.center().y());
  p.rotate(-90);
  p.setPen(t.quiet);
  drawSymbol(p, QRectF(-150, -8, 300, 16), Qt::AlignHCenter, fitted(p.font(), y, g.square.height() + 20));
  p.restore();
}

}  // namespace surefoot
