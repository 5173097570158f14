// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn around the curves: grid, axes, marks of changes and falls, and the list at the right.
#include <QHelpEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "ui/learning_charts.h"
#include "ui/session.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

void LearningChart::drawBackground(QPainter* painter, const QRectF& rect) {
  QChartView::drawBackground(painter, rect);
  drawAxes(*painter, themeOf(*this));
}

void LearningChart::drawForeground(QPainter* painter, const QRectF&) {
  const Theme& t = themeOf(*this);
  if (session_.curves().live().points.empty() && session_.curves().earlier().empty()) {
    painter->setFont(textFont(11));
    painter->setPen(t.quiet);
    painter->drawText(plot_, Qt::AlignCenter,
                      shows_ == Shows::Falls ? tr("Falls appear here. None so far.")
                                             : tr("The average appears with the first episodes."));
    return;
  }
  if (shows_ == Shows::AverageReward) drawTests(*painter, t);
  shows_ == Shows::Falls ? drawFallMarks(*painter, t) : drawMarks(*painter, t);
  drawList(*painter, t);
}

void LearningChart::drawAxes(QPainter& p, const Theme& t) const {
  p.setFont(textFont(11));
  const double yStep = niceAbove((yMost_ - yLeast_) / 5.0001);
  for (double y = std::ceil(yLeast_ / yStep) * yStep; y <= yMost_ + 1e-9; y += yStep) {
    const double at = std::round(toPixel(0, y).y()) + 0.5;
    p.setPen(QPen(t.hairline, 1));
    p.drawLine(QPointF(plot_.left(), at), QPointF(plot_.right(), at));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(0, at - 8, kLeft - 8, 16), Qt::AlignRight,
               toText(yStep < 1 ? fixedText(y, yStep < 0.1 ? 2 : 1) : countText(y)));
  }
  const double base = std::round(plot_.bottom()) + 0.5;
  p.setPen(QPen(t.outline, 1));
  p.drawLine(QPointF(plot_.left(), base), QPointF(plot_.right(), base));
  const double xStep = niceAbove(xMost_ / (xMost_ >= 10'000 ? 4.0001 : 8.0001));  // long numbers need room
  for (double x = 0; x <= xMost_ + 1e-9; x += xStep) {
    const double at = toPixel(x, 0).x();
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(at, base), QPointF(at, base + 4));
    if (!hasTimeAxis()) continue;
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(at - 30, base + 5, 60, 16), Qt::AlignHCenter,
               xStep < 1 ? toText(fixedText(x, 1)) : toText(countText(x)));
  }
  if (exporting_) {
    p.setPen(t.ink);
    p.setFont(textFont(13, 500));
    p.drawText(QRectF(12, 6, width() - 24, 20), Qt::AlignLeft | Qt::AlignVCenter,
               shows_ == Shows::Falls ? tr("Falls, cumulative") : tr("Average reward of the last 80 episodes"));
    p.setFont(textFont(11));
    p.setPen(t.quiet);
  }
  if (hasTimeAxis())
    p.drawText(QRectF(plot_.left(), base + 20, plot_.width(), 16), Qt::AlignHCenter | Qt::AlignVCenter,
               session_.task().stepTime ? tr("simulated time [min]") : tr("episodes"));
}

QString LearningChart::textOf(const Change& change) const {
  const QString values = QStringLiteral("%1 → %2");
  if (change.key == "policy") {
    const auto title = [&](const std::string& name) {
      const auto entry = findEntry(session_.registry().policies, "policy", name);
      return toText(entry ? (*entry)->title : name);
    };
    return values.arg(title(change.before), title(change.after));
  }
  if (change.key == "push") return tr("pushed");
  if (change.key == "place") return tr("placed");
  const auto* entry = session_.configuration().parameters.find(change.key);
  const QString title = toText(entry ? entry->parameter.title : change.key).toLower();
  return title + ' ' + values.arg(toText(change.before), toText(change.after)).replace('-', QChar(0x2212));
}

std::vector<LearningChart::Mark> LearningChart::marks() const {
  const ValueSnapshot* v = session_.values();
  const double perStep = session_.task().stepTime.value_or(0.0) / 60.0;
  std::vector<Mark> list;
  if (!v || perStep <= 0) return list;
  // A slider that is drawn makes many changes; those of one parameter that follow closely are one mark.
  std::vector<Change> groups;
  const double near = 0.04 * xMost_ / perStep;
  for (const Change& change : v->changes) {
    if (!groups.empty() && groups.back().key == change.key &&
        static_cast<double>(change.step - groups.back().step) < near)
      groups.back().after = change.after;
    else
      groups.push_back(change);
  }
  constexpr std::size_t kMost = 12;
  for (std::size_t i = groups.size() > kMost ? groups.size() - kMost : 0; i < groups.size(); ++i)
    if (groups[i].before != groups[i].after)
      list.push_back({static_cast<double>(groups[i].step) * perStep, textOf(groups[i])});
  if (v->endOfLearning > 0)
    list.push_back({static_cast<double>(v->endOfLearningSteps) * perStep, tr("end of learning")});
  return list;
}

void LearningChart::drawMarks(QPainter& p, const Theme& t) const {
  const std::vector<Mark> list = marks();
  QPen pen(t.ink, 1, Qt::CustomDashLine);
  pen.setDashPattern({2, 3});
  p.setPen(pen);
  for (const Mark& mark : list) {
    const double at = std::round(toPixel(mark.x, 0).x()) + 0.5;
    if (at <= plot_.right()) p.drawLine(QPointF(at, plot_.top()), QPointF(at, plot_.bottom()));
  }
  // Two texts are enough, or they would cover the curves: the newest change, and the end of learning.
  p.setFont(textFont(11));
  double y = plot_.bottom() - 17;
  const std::size_t told = list.size() < 2 || list.back().text != tr("end of learning") ? 1 : 2;
  for (std::size_t i = list.size(); i-- > list.size() - std::min(told, list.size()); y -= 15) {
    const double at = toPixel(list[i].x, 0).x(), w = symbolWidth(p.font(), list[i].text) + 4;
    if (at > plot_.right()) continue;
    const double left = at + 5 + w < plot_.right() ? at + 4 : std::max(plot_.left(), at - 4 - w);
    QColor veil = t.panel;
    veil.setAlphaF(0.88f);
    p.fillRect(QRectF(left, y, w, 15), veil);
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(left, y, w, 15), Qt::AlignLeft, list[i].text);
  }
}

// The texts of the others, under the cursor.
bool LearningChart::viewportEvent(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QChartView::viewportEvent(event);
  constexpr double kNear = 6;  // [px]
  QStringList texts;
  for (const Mark& mark : marks())
    if (std::abs(toPixel(mark.x, 0).x() - static_cast<QHelpEvent*>(event)->pos().x()) < kNear) texts << mark.text;
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), texts.join('\n'), this);
  return true;
}

void LearningChart::drawTests(QPainter& p, const Theme& t) const {
  const ValueSnapshot* v = session_.values();
  const double perStep = session_.task().stepTime.value_or(0.0) / 60.0;
  if (!v || perStep <= 0) return;
  QColor colour = policyLook(session_.curves().live().policy(), t).colour;
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(QPen(colour, 1));
  p.setBrush(t.panel);
  for (const GreedyTest& test : v->tests) {
    const QPointF at = toPixel(static_cast<double>(test.lifeSteps) * perStep, std::clamp(test.reward, yLeast_, yMost_));
    if (at.x() <= plot_.right()) p.drawEllipse(at, 1.8, 1.8);
  }
  p.setBrush(Qt::NoBrush);
}

void LearningChart::drawFallMarks(QPainter& p, const Theme& t) const {
  const auto& points = session_.curves().live().points;
  p.setPen(QPen(t.fall, 1));
  double last = -10;
  std::int64_t falls = 0;
  for (const CurvePoint& point : points) {
    if (xOf(point) > xMost_) break;
    const double at = std::round(toPixel(xOf(point), 0).x()) + 0.5;
    if (point.falls > falls && at - last >= 2) {
      p.drawLine(QPointF(at, plot_.bottom() - 8), QPointF(at, plot_.bottom() - 1));
      last = at;
      falls = point.falls;
    }
  }
}

void LearningChart::drawList(QPainter& p, const Theme& t) const {
  struct Item {
    double value;
    std::string policy;
    bool live;
    int run;
    bool second = false;
  };
  std::vector<Item> items;
  const RunCurves& curves = session_.curves();
  for (const RunCurve& c : curves.earlier()) items.push_back({yOf(c.points.back()), c.policy(), false, c.number});
  if (!curves.live().points.empty())
    items.push_back({yOf(curves.live().points.back()), curves.live().policy(), true, curves.live().number});
  if (const RunCurve* second = secondCurve())
    items.push_back({yOf(second->points.back()), second->policy(), true, 0, true});
  std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.value > b.value; });
  double y = plot_.top() + 2;
  for (const Item& item : items) {
    drawMarker(p, {plot_.right() + 12, y}, policyLook(item.policy, t), item.live);
    const auto entry = findEntry(session_.registry().policies, "policy", item.policy);
    QString text = shows_ == Shows::Falls ? toText(countText(item.value)) : entry ? toText((*entry)->title) : QString();
    if (shows_ == Shows::AverageReward)
      text += item.second ? tr(", 2nd") : item.live ? tr(", live") : tr(", run %1").arg(item.run);
    p.setFont(textFont(11, item.live ? 500 : 400));
    p.setPen(item.live ? t.ink : t.quiet);
    drawSymbol(p, QRectF(plot_.right() + 20, y - 8, kRight - 22, 16), Qt::AlignLeft, text);
    y += 15;
  }
}

}  // namespace surefoot
