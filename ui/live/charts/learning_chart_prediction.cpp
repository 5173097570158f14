// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the charts about a number that was said before it was seen.
#include <algorithm>
#include <cmath>

#include "ui/live/charts/learning_charts.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/session/history.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {
constexpr double kHalf = 7;   // half a diagonal of the diamond [px]
constexpr double kNear = 14;  // the mouse takes hold of it from here [px]
}  // namespace

void LearningChart::setPrediction(std::optional<ChartPrediction> prediction) {
  prediction_ = std::move(prediction);
  predicting_ = predicting_ && prediction_ && !prediction_->locked;
  refresh();
}

void LearningChart::setRunWords(std::function<QString(const RunCurve&)> words) {
  runWords_ = std::move(words);
  refresh();
}

/// The axis has the range of what can be said, in quarters or in whole numbers; more if the curves go beyond it.
void LearningChart::fitPrediction(double most) {
  if (most > prediction_->high) return roundRange(std::min(prediction_->low, 0.0), most);
  yLeast_ = prediction_->low, yMost_ = prediction_->high;
  const double range = yMost_ - yLeast_;
  yStep_ = range / 4;
  for (const int parts : {2, 3, 5, 4})  // the last that gives whole numbers
    if (range >= 10 && std::fmod(range, parts) == 0) yStep_ = range / parts;
}

bool LearningChart::movesPrediction(const QPointF& at) const {
  if (!prediction_ || prediction_->locked) return false;
  const double y = toPixel(0, prediction_->value).y();
  return std::abs(at.y() - y) < kNear && at.x() > plot_.left() && at.x() < plot_.right() + kNear;
}

void LearningChart::movePrediction(double pixel) {
  const double share = (plot_.bottom() - pixel) / plot_.height();
  const double value = std::round(yLeast_ + share * (yMost_ - yLeast_));
  Q_EMIT predictionMoved(std::clamp(value, prediction_->low, prediction_->high));
}

/// Where ◇ stands.
double LearningChart::predictionX() const {
  if (!prediction_->at || *prediction_->at >= span_.to() || *prediction_->at <= span_.from()) return plot_.right();
  return toPixel(*prediction_->at, 0).x();
}

void LearningChart::drawPrediction(QPainter& p, const Theme& t) const {
  const double y = toPixel(0, prediction_->value).y(), right = predictionX();
  QPen dots(t.ink, 1.25, Qt::CustomDashLine);
  dots.setDashPattern({1.2, 2.8});
  p.setRenderHint(QPainter::Antialiasing);
  if (prediction_->outcome) {
    drawOutcome(p, t);
  } else {
    p.setPen(dots);
    p.drawLine(QPointF(plot_.left(), y), QPointF(right - kHalf, y));
    p.setPen(t.quiet);
    p.setFont(textFont(11));
    const double h = QFontMetricsF(p.font()).height();
    const double above = y - h - 3 < plot_.top() ? y + 3 : y - h - 3;
    drawSymbol(p, QRectF(plot_.left(), above, plot_.width(), h), Qt::AlignHCenter, prediction_->words);
  }
  const QPolygonF diamond(
      {QPointF(right - kHalf, y), QPointF(right, y - kHalf), QPointF(right + kHalf, y), QPointF(right, y + kHalf)});
  p.setBrush(prediction_->locked ? t.ink : t.panel);
  p.setPen(QPen(t.panel, 4.5));
  p.drawPolygon(diamond);
  p.setPen(QPen(t.ink, 1.75));
  p.drawPolygon(diamond);
  p.setBrush(Qt::NoBrush);
}

bool LearningChart::crossesCurve(const QRectF& box) const {
  const auto runs = this->runs();
  return std::any_of(runs.begin(), runs.end(), [&](const Run& run) {
    const auto& points = run.curve->points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const QPointF a = toPixel(xOf(points[i - 1]), yOf(points[i - 1])), b = toPixel(xOf(points[i]), yOf(points[i]));
      if (QRectF(a, b).normalized().adjusted(-1, -1, 1, 1).intersects(box)) return true;
    }
    return false;
  });
}

/// From where the live curve reached what was said to the end, and how many more or fewer came out.
void LearningChart::drawOutcome(QPainter& p, const Theme& t) const {
  const double said = prediction_->value, y = toPixel(0, said).y(), right = predictionX();
  const auto& points = life_.curves().live().points;
  const auto reached =
      std::find_if(points.begin(), points.end(), [&](const CurvePoint& point) { return yOf(point) >= said; });
  const bool there = reached != points.end() && said > 0 && xOf(*reached) < span_.to();
  const double from = there ? toPixel(xOf(*reached), 0).x() : plot_.left();
  QPen dots(t.ink, 1.25, Qt::CustomDashLine);
  dots.setDashPattern({1.2, 2.8});
  p.setPen(dots);
  p.drawLine(QPointF(from, y), QPointF(right - kHalf, y));
  p.setFont(textFont(11));
  const double h = QFontMetricsF(p.font()).height();
  if (there) {
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(from, y), QPointF(from, plot_.bottom()));
    const QString words = tr("%1 at %2").arg(valueText(said), timeText(xOf(*reached)));
    const double width = symbolWidth(p.font(), words) + 6;
    const bool before = from + 6 + width > right && from - 6 - width > plot_.left();
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(before ? from - 6 - width : from + 6, y + 3, width, h),
               before ? Qt::AlignRight : Qt::AlignLeft, words);
  }
  const double more = *prediction_->outcome - said, at = toPixel(0, *prediction_->outcome).y(), x = right - 16;
  if (std::abs(at - y) < h + 4) return;
  p.setPen(QPen(t.ink, 1.25));
  for (const double end : {at, y}) p.drawLine(QPointF(x - 4, end), QPointF(x + 4, end));
  p.drawLine(QPointF(x, at), QPointF(x, y));
  const QString words = more > 0 ? tr("%1 more").arg(valueText(more)) : tr("%1 fewer").arg(valueText(-more));
  const double width = symbolWidth(p.font(), words) + 8;
  const auto boxAt = [&](double top) { return QRectF(x - 8 - width, top, width, h); };
  const double high = std::min(at, y), low = std::max(at, y);
  QRectF box = boxAt((at + y - h) / 2);  // beside the bracket, or where no curve runs
  for (const QRectF& other : {boxAt(high - h - 4), boxAt(low + 4)})
    if (crossesCurve(box) && !crossesCurve(other) && other.top() >= plot_.top() && other.bottom() <= plot_.bottom())
      box = other;
  p.fillRect(box, t.panel);
  drawSymbol(p, box, Qt::AlignRight, words);
}

}  // namespace surefoot
