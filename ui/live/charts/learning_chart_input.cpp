// SPDX-License-Identifier: GPL-3.0-or-later
// A person's actions on a chart: reading it, magnifying its time axis, replaying a fall, removing earlier runs.
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/language/numbers.h"
#include "ui/live/charts/learning_charts.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/session/history.h"

namespace surefoot {

namespace {
constexpr double kLeastDrag = 6;  // [px]
constexpr double kStep = 0.01;    // share of the shown part by which a key moves
constexpr double kKeyZoom = 0.7;
}  // namespace

QString LearningChart::timeText(double time) const {
  const double span = span_.to() - span_.from();
  if (!span_.inMinutes()) return tr("episode %1").arg(countNumber(time));
  return tr("%1 min").arg(fixedNumber(time, span > 200 ? 0 : span > 20 ? 1 : 2));
}

std::optional<LearningChart::Read> LearningChart::read() const {
  if (!span_.cursor()) return std::nullopt;
  std::optional<Read> nearest;
  double least = kInfinity;
  const std::vector<Run> list = runs();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const CurvePoint* point = stateAt(*list[i].curve, *span_.cursor());
    if (!point) continue;
    // The next point may be nearer; after its end a curve has no value.
    const bool isLast = point == &list[i].curve->points.back();
    if (isLast && toPixel(*span_.cursor(), 0).x() > toPixel(xOf(*point), 0).x() + 12) continue;
    if (!isLast && xOf(point[1]) - *span_.cursor() < *span_.cursor() - xOf(*point)) ++point;
    const bool chosen = i == readRun_.value_or(list.size() - 1);  // at first the present life
    const double distance = mouseY_  ? std::abs(toPixel(0, yOf(*point)).y() - *mouseY_)
                            : chosen ? 0.0
                                     : 1.0 + static_cast<double>(list.size() - i);
    if (distance < least) least = distance, nearest = Read{list[i], *point, i};
  }
  return nearest;
}

QString LearningChart::reading() const {
  const auto at = read();
  if (!at) return {};
  const QString value = valueText(yOf(at->point));
  return tr("%1: %2, %3")
      .arg(timeText(xOf(at->point)),
           shows_ == Shows::Falls ? tr("%1 falls", nullptr, static_cast<int>(yOf(at->point))).arg(value) : value,
           nameOf(at->run));
}

void LearningChart::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  if (event->button() == Qt::LeftButton && movesPrediction(mouseAt(*event))) {
    predicting_ = true;
    return movePrediction(mouseAt(*event).y());
  }
  if (event->button() != Qt::LeftButton || !plot_.contains(mouseAt(*event))) return;
  pressed_ = mouseAt(*event).x();
  dragged_.reset();
}

void LearningChart::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = mouseAt(*event);
  if (predicting_) return movePrediction(at.y());
  viewport()->setCursor(movesPrediction(at) ? Qt::SizeVerCursor : Qt::ArrowCursor);
  if (pressed_ && std::abs(at.x() - *pressed_) >= kLeastDrag)
    dragged_ = std::clamp(at.x(), plot_.left(), plot_.right());
  const bool inside = plot_.adjusted(-1, -8, 1, 8).contains(at);
  mouseY_ = inside ? std::optional(at.y()) : std::nullopt;
  span_.setCursor(inside ? std::optional(timeAt(at.x())) : std::nullopt);
  setAccessibleDescription(reading());
  viewport()->update();
}

void LearningChart::mouseReleaseEvent(QMouseEvent* event) {
  predicting_ = false;
  if (event->button() != Qt::LeftButton || !pressed_) return;
  const double from = *pressed_;
  const auto to = dragged_;
  pressed_.reset(), dragged_.reset();
  viewport()->update();
  if (to) return span_.showPart(timeAt(std::min(from, *to)), timeAt(std::max(from, *to)));
  if (shows_ == Shows::Falls && std::abs(mouseAt(*event).y() - (plot_.bottom() - 4)) <= 8) replayNear(from);
}

void LearningChart::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) span_.showWholeLife();
}

void LearningChart::wheelEvent(QWheelEvent* event) {
  const QPoint turned = event->angleDelta();
  if (std::abs(turned.x()) > std::abs(turned.y()))
    span_.pan(-turned.x() / 1200.0);
  else
    span_.zoom(std::pow(1.0015, -turned.y()), timeAt(std::clamp(mouseAt(*event).x(), plot_.left(), plot_.right())));
  event->accept();
}

/// The nearest fall that is still kept.
void LearningChart::replayNear(double pixel) {
  constexpr double kNear = 5;  // [px]
  double least = kNear;
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < looking_.falls().size(); ++i) {
    const Fall& fall = looking_.falls()[i];
    const double distance = std::abs(toPixel(span_.timeOf(fall.episode, fall.lifeSteps), 0).x() - pixel);
    if (distance <= least) least = distance, nearest = i;
  }
  if (nearest) looking_.replayFall(*nearest);
}

/// Moves the cursor by keys; if it leaves the shown part, the part follows.
void LearningChart::moveCursor(int steps) {
  const double span = span_.to() - span_.from();
  const double edge = steps > 0 ? span_.from() : span_.to();
  const double now = std::clamp(span_.cursor().value_or(edge), span_.from(), span_.to());
  const double next = now + steps * kStep * span;
  if (next < span_.from() || next > span_.to()) span_.pan(steps * kStep);
  mouseY_.reset();
  span_.setCursor(std::clamp(next, span_.from(), span_.to()));
}

void LearningChart::readNext(int step) {
  const std::size_t n = runs().size();
  if (n == 0) return;
  const auto at = read();
  mouseY_.reset();
  readRun_ = ((at ? at->index : n - 1) + n + static_cast<std::size_t>(step + static_cast<int>(n))) % n;
  if (!span_.cursor()) span_.setCursor(span_.to());
  setAccessibleDescription(reading());
  viewport()->update();
}

bool LearningChart::usesKey(int key) const {
  const bool playing = looking_.playback();  // then Escape and the arrow keys belong to the playback
  switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Right:
      return !playing;
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
    case Qt::Key_Home:
    case Qt::Key_Delete:
      return true;
    case Qt::Key_Escape:
      return !playing && (span_.cursor() || span_.shows() == ChartSpan::Shows::Part);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return shows_ == Shows::Falls && span_.cursor();
    default:
      return false;
  }
}

bool LearningChart::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto& key = static_cast<QKeyEvent&>(*event);
    if (!(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) && usesKey(key.key())) {
      event->accept();
      return true;
    }
  }
  return QChartView::event(event);
}

void LearningChart::keyPressEvent(QKeyEvent* event) {
  const double anchor = span_.cursor().value_or((span_.from() + span_.to()) / 2);
  const int steps = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
  if (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier) || !usesKey(event->key())) return event->ignore();
  switch (event->key()) {
    case Qt::Key_Left:
      return moveCursor(-steps);
    case Qt::Key_Right:
      return moveCursor(steps);
    case Qt::Key_Up:
    case Qt::Key_Down:
      return readNext(event->key() == Qt::Key_Up ? 1 : -1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return span_.zoom(kKeyZoom, anchor);
    case Qt::Key_Minus:
      return span_.zoom(1 / kKeyZoom, anchor);
    case Qt::Key_Home:
      return span_.showWholeLife();
    case Qt::Key_Delete:
      if (const auto at = read(); at && at->run.kind == Run::Kind::Earlier)
        history_.removeEarlierRuns({at->run.curve->number});
      return;
    case Qt::Key_Escape:
      return span_.cursor() ? span_.setCursor(std::nullopt) : span_.showWholeLife();
    default:
      return replayNear(toPixel(*span_.cursor(), 0).x());
  }
}

void LearningChart::focusInEvent(QFocusEvent* event) {
  QChartView::focusInEvent(event);
  ring_ = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
  viewport()->update();
}

void LearningChart::focusOutEvent(QFocusEvent* event) {
  QChartView::focusOutEvent(event);
  ring_ = false;
  viewport()->update();
}

void LearningChart::fillMenu(QMenu& menu) {
  menu.addAction(tr("Whole life\tHome"), &span_, &ChartSpan::showWholeLife);
  menu.addAction(tr("While it learned"), &span_, &ChartSpan::showLearning);
  std::vector<int> all;
  for (const Run& run : runs()) {
    if (run.kind != Run::Kind::Earlier) continue;
    if (all.empty()) menu.addSeparator();
    all.push_back(run.curve->number);
    menu.addAction(tr("Remove %1").arg(nameOf(run)), &history_,
                   [this, number = run.curve->number] { history_.removeEarlierRuns({number}); });
  }
  if (all.size() > 1)
    menu.addAction(tr("Remove all earlier runs"), &history_, [this, all] { history_.removeEarlierRuns(all); });
  menu.addSeparator();
}

}  // namespace surefoot
