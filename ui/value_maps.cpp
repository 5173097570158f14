// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/value_maps.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.h"
#include "ui/learning_charts.h"
#include "ui/session.h"
#include "ui/symbol_text.h"

namespace surefoot {

namespace {
constexpr double kLeft = 47, kTop = 24, kUnder = 48;  // gutters [px]
constexpr int kCell = 3, kSmallCell = 2;              // [px]
constexpr double kFamiliar = 0.25;  // share of the active tiles below which a state counts as never visited
constexpr double kNever = std::numeric_limits<double>::quiet_NaN();

/// The symbol, or the title where there is none.
QString nameOf(const StateVariable& v) {
  return toText(v.symbol.empty() ? v.title : v.symbol);
}
}  // namespace

ValueMaps::ValueMaps(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  connect(&session_, &Session::valuesArrived, this, &ValueMaps::recompute);
  connect(&session_, &Session::lifeReplaced, this, [this] {
    any_ = false;
    update();
  });
}

bool ValueMaps::split() const {
  return session_.values() && session_.values()->values->split();
}

ValueMaps::Geometry ValueMaps::geometry() const {
  const bool oneBar = split();
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

void ValueMaps::recompute() {
  const ValueSnapshot* v = session_.values();
  if (!isVisible() || !v || session_.task().state.size() < 2 || session_.shown().state.empty()) return;
  const Task& task = session_.task();
  const bool dark = themeOf(*this).dark;
  const Geometry g = geometry();
  slice_.at = session_.shown().state;
  qScale_ = {MapScale::Kind::Diverging, std::min(task.lowestReturn, -1.0), std::max(task.highestReturn, 1.0)};

  const ActionValueFunction& values = *v->values;
  std::vector<double> q(static_cast<std::size_t>(values.actions()));
  const auto best = [&](std::span<const double> s) {
    if (values.familiarity(s) < kFamiliar) return kNever;
    values.evaluate(s, Layer::Sum, q);
    return *std::max_element(q.begin(), q.end());
  };
  q_.compute(task, slice_, static_cast<int>(g.big.width()) / kCell, qScale_, best, dark);
  const int cells = static_cast<int>(g.upper.width()) / kSmallCell;
  split() ? computeParts(cells, dark) : computeTraces(cells, dark);
  any_ = true;
  Q_EMIT noteChanged(note());
  update();
}

// Both parts of the action that is best by their sum, so that the large map is the sum of the small ones.
void ValueMaps::computeParts(int cells, bool dark) {
  const ActionValueFunction& values = *session_.values()->values;
  std::vector<double> q(static_cast<std::size_t>(values.actions())), part(q.size());
  const auto partOf = [&](Layer layer) {
    return [&, layer](std::span<const double> s) {
      if (values.familiarity(s) < kFamiliar) return kNever;
      values.evaluate(s, Layer::Sum, q);
      values.evaluate(s, layer, part);
      return part[static_cast<std::size_t>(std::max_element(q.begin(), q.end()) - q.begin())];
    };
  };
  upper_.compute(session_.task(), slice_, cells, qScale_, partOf(Layer::Positive), dark);
  lower_.compute(session_.task(), slice_, cells, qScale_, partOf(Layer::Negative), dark);
}

void ValueMaps::computeTraces(int cells, bool dark) {
  const ValueSnapshot& v = *session_.values();
  const ActionValueFunction& values = *v.values;
  std::vector<double> z(static_cast<std::size_t>(values.actions()));
  double most = 10;
  const auto visits = [&](std::span<const double> s) {
    most = std::max(most, values.visits(s));
    return values.familiarity(s) < kFamiliar ? kNever : values.visits(s);
  };
  const auto eligibility = [&](std::span<const double> s) {
    if (values.familiarity(s) < kFamiliar) return kNever;
    values.average(v.eligibility, s, z);
    return *std::max_element(z.begin(), z.end());
  };
  upper_.compute(session_.task(), slice_, cells, visitScale_, visits, dark);
  visitScale_ = {MapScale::Kind::Viridis, 1, std::pow(10.0, std::ceil(std::log10(most)))};  // settles with the next
  eligibilityScale_ = {MapScale::Kind::Positive, 0, 1};
  lower_.compute(session_.task(), slice_, cells, eligibilityScale_, eligibility, dark);
}

QString ValueMaps::note() const {
  const auto& variables = session_.task().state;
  QString text = tr("best action,  %1 × %2").arg(nameOf(variables[0]), nameOf(variables[1]));
  for (std::size_t d = 2; d < variables.size() && d < slice_.at.size(); ++d)
    text += tr(",  %1 live %2").arg(nameOf(variables[d]), toText(fixedText(slice_.at[d], 1)));
  return text;
}

void ValueMaps::drawAxes(QPainter& p, const QRectF& m, const Theme& t) const {
  const StateVariable &x = session_.task().state[0], &y = session_.task().state[1];
  p.setFont(textFont(11));
  const double xStep = niceAbove((x.viewHigh - x.viewLow) / 4), yStep = niceAbove((y.viewHigh - y.viewLow) / 6);
  const auto text = [](double v, double step) { return toText(fixedText(v, step < 1 ? 1 : 0)); };
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
  const auto title = [](const StateVariable& v) {
    const QString name = v.symbol.empty() ? toText(v.title) : toText(v.title) + ' ' + toText(v.symbol);
    return v.unit.empty() ? name : QStringLiteral("%1 [%2]").arg(name, toText(v.unit));
  };
  drawSymbol(p, QRectF(m.left(), m.bottom() + 22, m.width(), 16), Qt::AlignHCenter, title(x));
  p.save();
  p.translate(m.left() - 40, m.center().y());
  p.rotate(-90);
  drawSymbol(p, QRectF(-100, -8, 200, 16), Qt::AlignHCenter, title(y));
  p.restore();
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
  const std::vector<double>& live = session_.shown().state;
  p.setFont(textFont(13, 500));
  p.setPen(t.ink);
  p.drawText(QPointF(g.big.left(), kTop - 8), QStringLiteral("Q"));
  if (!any_) {
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    p.drawText(g.big, Qt::AlignCenter | Qt::TextWordWrap, tr("The map appears with the first steps."));
    return;
  }
  q_.draw(p, g.big, t, session_.task(), live, 6);
  const double qNumbers[] = {qScale_.low, qScale_.low / 2, 0, qScale_.high / 2, qScale_.high};
  ValueMap::drawBar(p, g.bigBar, qScale_, t, qNumbers);
  drawSmallMaps(p, g, t);
  drawAxes(p, g.big, t);
  drawKey(p, g, t);
}

void ValueMaps::drawSmallMaps(QPainter& p, const Geometry& g, const Theme& t) const {
  const bool parts = split();
  p.setFont(textFont(13, 500));
  p.setPen(t.ink);
  p.drawText(QPointF(g.upper.left(), kTop - 8), parts ? QStringLiteral("Q⁺") : tr("Visits"));
  p.drawText(QPointF(g.lower.left(), g.lower.top() - 8), parts ? QStringLiteral("Q⁻") : tr("Eligibility"));
  const std::vector<double>& live = session_.shown().state;
  upper_.draw(p, g.upper, t, session_.task(), live, 4);
  lower_.draw(p, g.lower, t, session_.task(), live, 4);
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

}  // namespace surefoot
