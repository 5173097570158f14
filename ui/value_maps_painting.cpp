// SPDX-License-Identifier: GPL-3.0-or-later
// How the panel of value maps is drawn.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/features/tile_layout.h"
#include "core/text.h"
#include "ui/learning_charts.h"
#include "ui/session.h"
#include "ui/symbol_text.h"
#include "ui/value_maps.h"

namespace surefoot {

namespace {
constexpr double kLeft = 47, kTop = 24, kUnder = 48;  // gutters [px]
}  // namespace

ValueMaps::Geometry ValueMaps::geometry() const {
  const bool oneBar = split() && valued();
  const double room = std::min((width() - (oneBar ? 103.0 : 145.0)) / 1.5, height() - kTop - kUnder);
  const double m = std::floor(std::max(room, 60.0) / kCell) * kCell;
  const double s = std::floor((m - 28) / 2 / kSmallCell) * kSmallCell;
  Geometry g;
  g.big = QRectF(kLeft, kTop, m, m);
  const double x = g.big.right() + (oneBar ? 16 : 60);
  g.upper = QRectF(x, kTop, s, s);
  g.lower = QRectF(x, kTop + m - s, s, s);
  g.bigBar = QRectF(oneBar ? x + s + 8 : g.big.right() + 8, kTop, 10, m);
  g.upperBar = QRectF(x + s + 8, kTop, 10, s);
  g.lowerBar = QRectF(x + s + 8, kTop + m - s, 10, s);
  return g;
}

QString ValueMaps::title() const {
  switch (choice_.quantity) {
    case MapQuantity::GreedyAction:
      return tr("Greedy action");
    case MapQuantity::Visits:
      return tr("Visits");
    case MapQuantity::Eligibility:
      return tr("Eligibility");
    default:
      return QStringLiteral("Q");
  }
}

MapMarks ValueMaps::marks(double ring) const {
  return {.live = session_.shown().state, .cursor = session_.examined(), .ring = ring};
}

void ValueMaps::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  QPainter p(this);
  p.fillRect(rect(), t.panel);
  if (session_.task().state.size() < 2) {
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    p.drawText(rect(), Qt::AlignCenter, tr("A map needs two state variables; this environment has one."));
    return;
  }
  const Geometry g = geometry();
  p.setFont(textFont(13, 500));
  p.setPen(t.ink);
  p.drawText(QPointF(g.big.left(), kTop - 8), title());
  if (hasFocus()) {
    p.setPen(QPen(t.accent, 2));
    p.drawRect(g.big.adjusted(-2, -2, 2, 2));
  }
  if (!any_) {
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    p.drawText(g.big, Qt::AlignCenter | Qt::TextWordWrap, tr("The map appears with the first steps."));
    return;
  }
  MapMarks m = marks(6);
  if (valued() && session_.configuration().names.policy == "trl") {
    m.contour = session_.threshold();
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    const QString text = tr("contour: threshold %1").arg(toText(countText(*m.contour)));
    drawSymbol(p, QRectF(g.big.left(), kTop - 20, g.big.width(), 16), Qt::AlignRight, text);
  }
  big_.draw(p, g.big, t, session_.task(), m);
  drawBigBar(p, g, t);
  drawSmallMaps(p, g, t);
  drawFootprints(p, g, t);
  drawAxes(p, g.big, t);
  spoken().isEmpty() ? drawKey(p, g, t) : drawReading(p, g, t);
}

void ValueMaps::drawBigBar(QPainter& p, const Geometry& g, const Theme& t) const {
  const Task& task = session_.task();
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
  } else {
    numbers = {bigScale_.low, bigScale_.low / 2, 0, bigScale_.high / 2, bigScale_.high};
  }
  ValueMap::drawBar(p, g.bigBar, bigScale_, t, numbers, names);
  if (!valued() || session_.configuration().names.policy != "trl") return;
  const double y =
      g.bigBar.bottom() - std::clamp(bigScale_.position(session_.threshold()), 0.0, 1.0) * g.bigBar.height();
  p.setPen(QPen(t.ink, 2));
  p.drawLine(QPointF(g.bigBar.left() - 1, y), QPointF(g.bigBar.right() + 1, y));
}

void ValueMaps::drawSmallMaps(QPainter& p, const Geometry& g, const Theme& t) const {
  const bool parts = split() && valued();
  p.setFont(textFont(13, 500));
  p.setPen(t.ink);
  p.drawText(QPointF(g.upper.left(), kTop - 8), parts ? QStringLiteral("Q⁺") : tr("Visits"));
  p.drawText(QPointF(g.lower.left(), g.lower.top() - 8), parts ? QStringLiteral("Q⁻") : tr("Eligibility"));
  upper_.draw(p, g.upper, t, session_.task(), marks(4));
  lower_.draw(p, g.lower, t, session_.task(), marks(4));
  if (parts) return;
  const double middle = std::pow(10.0, std::floor(std::log10(visitScale_.high) / 2));
  const double visitNumbers[] = {1, middle, visitScale_.high};
  ValueMap::drawBar(p, g.upperBar, visitScale_, t, visitNumbers);
  const double eligibilityNumbers[] = {0, 0.5, 1};
  ValueMap::drawBar(p, g.lowerBar, eligibilityScale_, t, eligibilityNumbers);
}

void ValueMaps::drawKey(QPainter& p, const Geometry& g, const Theme& t) const {
  const QRectF key(g.lower.left(), g.lower.bottom() + 25, 16, 10);
  ValueMap::drawHatching(p, key, t);
  p.setPen(QPen(t.outline, 1));
  p.drawRect(key);
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  p.drawText(QPointF(key.right() + 6, key.bottom() - 0.5), tr("never visited"));
}

// The tiles that an update in the state under the cursor would reach: all of Q⁺'s (or Q's) and all of Q⁻'s.
void ValueMaps::drawFootprints(QPainter& p, const Geometry& g, const Theme& t) const {
  const std::vector<double>& state = session_.examined();
  const ValueSnapshot* v = session_.values();
  if (state.size() != session_.task().state.size() || !v || !v->layouts.is_object()) return;
  p.save();
  p.setRenderHint(QPainter::Antialiasing, false);
  p.setBrush(Qt::NoBrush);
  const bool parts = v->layouts.size() > 1;
  for (const auto& [name, layout] : v->layouts.items()) {
    const auto tiles = TileLayout::fromJson(layout);
    if (!tiles) continue;
    std::vector<QRectF> squares = {g.big};
    if (parts && split() && valued()) squares = {name == "positive" ? g.upper : g.lower};
    QColor colour = t.ink;
    colour.setAlphaF(std::clamp(3.0f / static_cast<float>(tiles->tilings()), 0.12f, 0.8f));
    p.setPen(QPen(colour, 1));
    for (const QRectF& square : squares) {
      p.setClipRect(square);
      for (int i = 0; i < tiles->tilings(); ++i) {
        std::vector<double> low = state, high = state;
        for (const int axis : {choice_.x, choice_.y}) {
          const auto d = static_cast<std::size_t>(axis);
          std::tie(low[d], high[d]) = tiles->tileAt(d, i, state[d]);
        }
        p.drawRect(QRectF(big_.toPixel(session_.task(), low, square), big_.toPixel(session_.task(), high, square)));
      }
    }
  }
  p.restore();
}

void ValueMaps::drawReading(QPainter& p, const Geometry& g, const Theme& t) const {
  const QString text = spoken();
  if (text.isEmpty()) return;
  p.setFont(textFont(11));
  const double w = std::min(symbolWidth(p.font(), text) + 12, width() - 8.0);
  const QRectF where(std::clamp(g.big.left(), 4.0, width() - w - 4), height() - 19, w, 17);
  p.fillRect(where, t.fill);
  p.setPen(t.ink);
  drawSymbol(p, where.adjusted(6, 0, -6, 0), Qt::AlignLeft, text);
}

void ValueMaps::drawAxes(QPainter& p, const QRectF& m, const Theme& t) const {
  const Task& task = session_.task();
  const StateVariable &x = task.state[static_cast<std::size_t>(choice_.x)],
                      &y = task.state[static_cast<std::size_t>(choice_.y)];
  p.setFont(textFont(11));
  const double xStep = niceAbove((x.viewHigh - x.viewLow) / 4), yStep = niceAbove((y.viewHigh - y.viewLow) / 6);
  const auto text = [](double v, double step) { return toText(fixedText(v, step < 0.1 ? 2 : step < 1 ? 1 : 0)); };
  for (double v = std::ceil(x.viewLow / xStep) * xStep; v <= x.viewHigh; v += xStep) {
    const double at = m.left() + (v - x.viewLow) / (x.viewHigh - x.viewLow) * m.width();
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(at, m.bottom()), QPointF(at, m.bottom() + 4));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(at - 30, m.bottom() + 4, 60, 16), Qt::AlignHCenter, text(v, xStep));
  }
  for (double v = std::ceil(y.viewLow / yStep) * yStep; v <= y.viewHigh; v += yStep) {
    const double at = m.bottom() - (v - y.viewLow) / (y.viewHigh - y.viewLow) * m.height();
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(m.left() - 4, at), QPointF(m.left(), at));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(m.left() - 47, at - 8, 40, 16), Qt::AlignRight, text(v, yStep));
  }
  if (spoken().isEmpty())
    drawSymbol(p, QRectF(m.left(), m.bottom() + 22, m.width(), 16), Qt::AlignHCenter, axisTitleOf(x));
  p.save();
  p.translate(m.left() - 40, m.center().y());
  p.rotate(-90);
  drawSymbol(p, QRectF(-100, -8, 200, 16), Qt::AlignHCenter, axisTitleOf(y));
  p.restore();
}

}  // namespace surefoot
