// SPDX-License-Identifier: GPL-3.0-or-later
// All that is drawn around the curves: grid, axes, marks of falls, the list at the right, and the cursor's reading.
#include <algorithm>
#include <cmath>

#include "core/text/text.h"
#include "ui/language/numbers.h"
#include "ui/live/charts/learning_charts.h"
#include "ui/running/looking.h"
#include "ui/running/run_names.h"
#include "ui/running/running_life.h"
#include "ui/session/history.h"
#include "ui/style/policy_look.h"
#include "ui/style/round_numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/keyboard.h"

namespace surefoot {

namespace {

constexpr int kText = 11;           // size of text [px]
constexpr double kBesideName = 20;  // from the plot to a name, with its marker [px]

double lineHeight(const QFont& font) {
  return std::ceil(QFontMetricsF(font).height());
}

/// A number with as many decimals as the step between two numbers needs.
QString axisText(double value, double step) {
  const int decimals = step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
  return localNumbers(decimals == 0 ? countText(value) : fixedText(value, decimals));
}

/// A small diamond, the marker of the greedy policy.
void drawTest(QPainter& p, const Theme& t, const QPointF& at) {
  constexpr double kRadius = 3;  // [px]
  p.setPen(QPen(policyLook("greedy", t).colour, 1.25));
  p.setBrush(t.panel);
  p.drawPolygon(QPolygonF(
      {at - QPointF(kRadius, 0), at - QPointF(0, kRadius), at + QPointF(kRadius, 0), at + QPointF(0, kRadius)}));
  p.setBrush(Qt::NoBrush);
}

}  // namespace

void LearningChart::drawBackground(QPainter* painter, const QRectF& rect) {
  QChartView::drawBackground(painter, rect);
  drawAxes(*painter, themeOf(*this));
}

void LearningChart::drawForeground(QPainter* painter, const QRectF&) {
  const Theme& t = themeOf(*this);
  if (ring_ && !exporting_) drawFocusRing(*painter, *this);
  if (runs().empty() && !prediction_) {
    painter->setFont(textFont(kText));
    painter->setPen(t.quiet);
    painter->drawText(plot_, Qt::AlignCenter | Qt::TextWordWrap,
                      shows_ == Shows::Falls ? tr("Falls appear here. None so far.")
                                             : tr("The average appears with the first episodes."));
    return;
  }
  if (shows_ == Shows::AverageReward) drawTests(*painter, t);
  shows_ == Shows::Falls ? drawFallMarks(*painter, t) : drawMarks(*painter, t);
  if (prediction_) drawPrediction(*painter, t);
  drawList(*painter, t);
  if (!exporting_) drawCursor(*painter, t);
}

void LearningChart::drawAxes(QPainter& p, const Theme& t) const {
  p.setFont(textFont(kText));
  const double h = lineHeight(p.font());
  for (double y = std::ceil(yLeast_ / yStep_) * yStep_; y <= yMost_ + 1e-9; y += yStep_) {
    const double at = std::round(toPixel(span_.from(), y).y()) + 0.5;
    p.setPen(QPen(t.hairline, 1));
    p.drawLine(QPointF(plot_.left(), at), QPointF(plot_.right(), at));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(0, at - h / 2, kLeft - 8, h), Qt::AlignRight, axisText(y, yStep_));
  }
  drawTimeAxis(p, t);
  if (!exporting_) return;
  p.setPen(t.ink);
  p.setFont(textFont(13, 500));
  p.drawText(QPointF(12, 21), accessibleName());
}

void LearningChart::drawTimeAxis(QPainter& p, const Theme& t) const {
  const double base = std::round(plot_.bottom()) + 0.5, h = lineHeight(p.font()), span = span_.to() - span_.from();
  p.setPen(QPen(t.outline, 1));
  p.drawLine(QPointF(plot_.left(), base), QPointF(plot_.right(), base));
  // As many numbers as have room, eight at most.
  double step = niceAbove(span / 8.0001);
  const auto widest = [&] { return symbolWidth(p.font(), axisText(span_.to(), step)) + 12; };
  while (widest() > plot_.width() * step / span && step < span) step = niceAbove(1.001 * step);
  for (double x = std::ceil(span_.from() / step - 1e-9) * step; x <= span_.to() * (1 + 1e-12) + 1e-12; x += step) {
    const double at = toPixel(x, 0).x();
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(at, base), QPointF(at, base + 4));
    if (!hasTimeAxis()) continue;
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(at - 50, base + 5, 100, h), Qt::AlignHCenter, axisText(x, step));
  }
  if (!hasTimeAxis()) return;
  p.setPen(t.quiet);
  p.drawText(QRectF(plot_.left(), base + 5 + h, plot_.width(), h), Qt::AlignHCenter | Qt::AlignTop,
             span_.inMinutes() ? tr("simulated time [min]") : tr("episodes"));
}

void LearningChart::drawTests(QPainter& p, const Theme& t) const {
  const ValueSnapshot* v = life_.values();
  if (!v) return;
  p.setRenderHint(QPainter::Antialiasing);
  for (const GreedyTest& test : v->tests) {
    const double x = span_.timeOf(test.episode, test.lifeSteps);
    if (x >= span_.from() && x <= span_.to()) drawTest(p, t, toPixel(x, std::clamp(test.reward, yLeast_, yMost_)));
  }
}

/// A click replays the nearest kept fall, so a mark answers only if a kept fall is within kApart.
std::vector<LearningChart::FallMark> LearningChart::fallMarks() const {
  constexpr double kApart = 2;  // [px]
  const RunCurve& live = life_.curves().live();
  std::vector<FallMark> marks;
  std::int64_t falls = live.fallsBefore;
  for (const CurvePoint& point : live.points) {
    const bool fell = point.falls > falls;
    falls = point.falls;
    const double x = xOf(point);
    if (!fell || x < span_.from()) continue;
    if (x > span_.to()) break;
    const double at = std::round(toPixel(x, 0).x()) + 0.5;
    if (marks.empty() || at - marks.back().x >= kApart) marks.push_back({at, false, true});
  }
  auto mark = marks.begin();
  for (const Fall& fall : looking_.falls()) {
    const double at = toPixel(span_.timeOf(fall.episode, fall.lifeSteps), 0).x();
    while (mark != marks.end() && mark->x < at - kApart) ++mark;
    for (auto near = mark; near != marks.end() && near->x <= at + kApart; ++near)
      near->answers = true, near->byHand &= fall.byHand();
  }
  for (FallMark& m : marks) m.byHand &= m.answers;
  return marks;
}

void LearningChart::drawFallMarks(QPainter& p, const Theme& t) const {
  for (const FallMark& mark : fallMarks()) {
    QColor colour = t.fall;
    if (!mark.answers) colour.setAlphaF(0.4f);
    QPen pen(colour, 1);
    if (mark.byHand) pen.setDashPattern({1, 2});
    p.setPen(pen);
    p.drawLine(QPointF(mark.x, plot_.bottom() - 8), QPointF(mark.x, plot_.bottom() - 1));
  }
}

QString LearningChart::nameOf(const Run& run) const {
  const QString name = toText(surefoot::nameOf(*run.curve, life_.registry()));
  return run.kind == Run::Kind::Second ? tr("2nd: %1").arg(name)
         : run.kind == Run::Kind::Live ? tr("live: %1").arg(name)
                                       : tr("run %1: %2").arg(run.curve->number).arg(name);
}

/// The width of the list at the right. Both charts have the same, or their time axes would not line up.
double LearningChart::listWidth() const {
  constexpr double kLeast = 56, kMostShare = 0.38;
  const QFont font = textFont(kText, 500);
  double widest = hasTests() ? std::max(kLeast, kBesideName + symbolWidth(textFont(kText), testsName()) + 12) : kLeast;
  for (const Run& run : runs()) {
    const QString name = runWords_ ? QStringLiteral("00,000 ") + runWords_(*run.curve) : nameOf(run);
    widest = std::max(widest, kBesideName + symbolWidth(font, name) + 12);
  }
  if (prediction_) widest = std::max(widest, kBesideName + symbolWidth(font, tr("00,000 you said")) + 12);
  return std::min(widest, std::max(kLeast, kMostShare * width()));
}

QString LearningChart::valueText(double value) const {
  return localNumbers(shows_ == Shows::Falls ? countText(value) : fixedText(value, 1));
}

bool LearningChart::hasTests() const {
  return life_.values() && !life_.values()->tests.empty();
}

QString LearningChart::testsName() const {
  return tr("greedy tests");
}

/// Ordered by the values of the runs at the end of the shown part, the highest first.
std::vector<LearningChart::Item> LearningChart::items() const {
  std::vector<Item> list;
  for (const Run& run : runs()) {
    const CurvePoint* end = stateAt(*run.curve, span_.to());
    if (!end) continue;
    const bool named = shows_ == Shows::AverageReward && !runWords_;
    list.push_back({run, yOf(*end), named ? nameOf(run) : valueText(yOf(*end))});
    if (runWords_) list.back().words = runWords_(*run.curve);
  }
  if (prediction_)
    list.push_back({{nullptr, Run::Kind::Live},
                    prediction_->value,
                    valueText(prediction_->value),
                    prediction_->locked ? tr("you said") : tr("you say"),
                    true});
  std::stable_sort(list.begin(), list.end(), [](const Item& a, const Item& b) { return a.value > b.value; });
  return list;
}

/// Numbers of falls stand at the ends of their curves, if there is room. Names stand at the top: their curves meet.
void LearningChart::drawList(QPainter& p, const Theme& t) const {
  const std::vector<Item> list = items();
  const double h = lineHeight(textFont(kText, 500)), last = plot_.bottom() - h / 2;
  double y = plot_.top() + 2;
  for (std::size_t i = 0; i < list.size(); ++i, y += h) {
    const auto& [run, value, text, words, predicted] = list[i];
    const bool earlier = run.kind == Run::Kind::Earlier;
    if (shows_ == Shows::Falls)
      y = std::min(std::max(y, toPixel(0, value).y()), last - h * static_cast<double>(list.size() - 1 - i));
    if (!predicted) drawMarker(p, {plot_.right() + kBesideName - 8, y}, policyLook(run.curve->policy(), t), !earlier);
    p.setFont(textFont(kText, earlier ? 400 : 500));
    p.setPen(earlier ? t.quiet : t.ink);
    const QRectF where(plot_.right() + kBesideName, y - h / 2, width() - plot_.right() - kBesideName - 2, h);
    drawSymbol(p, where, Qt::AlignLeft, QFontMetricsF(p.font()).elidedText(text, Qt::ElideRight, where.width()));
    if (words.isEmpty()) continue;
    const QRectF behind = where.adjusted(symbolWidth(p.font(), text) + 6, 0, 0, 0);
    p.setFont(textFont(kText));
    p.setPen(t.quiet);
    drawSymbol(p, behind, Qt::AlignLeft, QFontMetricsF(p.font()).elidedText(words, Qt::ElideRight, behind.width()));
  }
  if (shows_ == Shows::Falls || !hasTests() || y > last) return;
  p.setFont(textFont(kText));
  drawTest(p, t, {plot_.right() + kBesideName - 8, y});
  p.setPen(t.quiet);
  const QRectF where(plot_.right() + kBesideName, y - h / 2, width() - plot_.right() - kBesideName - 2, h);
  drawSymbol(p, where, Qt::AlignLeft, QFontMetricsF(p.font()).elidedText(testsName(), Qt::ElideRight, where.width()));
}

void LearningChart::drawCursor(QPainter& p, const Theme& t) const {
  if (pressed_ && dragged_) {
    QColor veil = t.ink;
    veil.setAlphaF(0.1f);
    p.fillRect(QRectF(QPointF(*pressed_, plot_.top()), QPointF(*dragged_, plot_.bottom())).normalized(), veil);
  }
  if (!span_.cursor() || *span_.cursor() < span_.from() || *span_.cursor() > span_.to()) return;
  const double x = std::round(toPixel(*span_.cursor(), 0).x()) + 0.5;
  p.setPen(QPen(t.outline, 1));
  p.drawLine(QPointF(x, plot_.top()), QPointF(x, plot_.bottom()));
  const auto at = read();
  if (!at) return;
  const QPointF dot = toPixel(xOf(at->point), yOf(at->point));
  p.drawLine(QPointF(plot_.left(), dot.y()), QPointF(plot_.right(), dot.y()));
  p.setBrush(policyLook(at->run.curve->policy(), t).colour);
  p.setPen(QPen(t.panel, 1.5));
  p.drawEllipse(dot, 4, 4);
  p.setBrush(Qt::NoBrush);
  p.setFont(textFont(kText, 500));
  const QString text = reading();
  const double w = symbolWidth(p.font(), text) + 12, h = lineHeight(p.font()) + 4;
  const bool high = dot.y() < plot_.top() + h + 12;
  const double right = x + 8, before = x - 8 - w;
  const double left = right + w <= plot_.right() ? right
                      : before >= plot_.left()   ? before
                                                 : std::max(2.0, std::min(right, width() - w - 2));
  const QRectF box(left, high ? dot.y() + 8 : dot.y() - h - 8, w, h);
  p.fillRect(box, t.panel);
  p.setPen(QPen(t.outline, 1));
  p.drawRect(box);
  p.setPen(t.ink);
  drawSymbol(p, box, Qt::AlignHCenter, text);
}

}  // namespace surefoot
