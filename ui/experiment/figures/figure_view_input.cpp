// SPDX-License-Identifier: GPL-3.0-or-later
// A person's actions on a figure: choosing a condition, reading a curve, magnifying its time axis.
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QScrollBar>
#include <QWheelEvent>
#include <cmath>

#include "ui/experiment/figures/figure_view.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {
constexpr double kLeastDrag = 6;             // [px]
constexpr double kKeyZoom = 0.7, kPan = .1;  // for a key
}  // namespace

bool FigureView::curves() const {
  return words_.isEmpty() && !figure().bars && !figure().scene && !figure().series.empty();
}

void FigureView::read(std::optional<QPointF> at) {
  reading_ = at;
  painter_.setReading(at);
  setAccessibleDescription(at ? painter_.textAt(*at, drawn()) : QString());
  update();
}

void FigureView::zoom(double factor, double anchor) {
  const auto [from, to] = painter_.time();
  const double at = from + anchor * (to - from), length = factor * (to - from);
  painter_.setTime(std::pair(at - anchor * length, at + (1 - anchor) * length));
  update();
}

void FigureView::pan(double share) {
  const auto [from, to] = painter_.time();
  const double by = share * (to - from);
  painter_.setTime(std::pair(from + by, to + by));
  update();
}

void FigureView::showAllOfIt() {
  painter_.setTime(std::nullopt);
  update();
}

void FigureView::wheelEvent(QWheelEvent* event) {
  const QPoint turn = event->angleDelta();
  if (curves()) {
    const QPointF at = mouseAt(*event);
    const auto time = painter_.timeAt(at, drawn());
    if (!time) return event->ignore();
    const auto [from, to] = painter_.time();
    if (std::abs(turn.x()) > std::abs(turn.y())) return pan(-turn.x() / 1200.0);
    return zoom(std::pow(1.0015, -turn.y()), (*time - from) / (to - from));
  }
  if (scroll_->maximum() == 0) return event->ignore();
  scroll_->setValue(scroll_->value() - (turn.x() != 0 ? turn.x() : turn.y()));
}

void FigureView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !words_.isEmpty()) return event->ignore();
  pressed_ = mouseAt(*event);
}

void FigureView::mouseMoveEvent(QMouseEvent* event) {
  if (!curves()) return event->ignore();
  const QPointF at = mouseAt(*event);
  read(painter_.timeAt(at, drawn()) ? std::optional(at) : std::nullopt);
}

/// A drag along a plot magnifies the range of the drag; without a drag it was a click.
void FigureView::mouseReleaseEvent(QMouseEvent* event) {
  const auto from = std::exchange(pressed_, std::nullopt);
  if (!from || event->button() != Qt::LeftButton) return event->ignore();
  const QPointF to = mouseAt(*event);
  const auto first = painter_.timeAt(*from, drawn()), last = painter_.timeAt(to, drawn());
  if (first && last && std::abs(from->x() - to.x()) >= kLeastDrag) {
    painter_.setTime(std::minmax(*first, *last));
    return update();
  }
  if (const auto hit = painter_.seriesAt(to, drawn(), scroll_->value()))
    Q_EMIT clicked(toText(figure().series[*hit].name));
}

void FigureView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && curves()) showAllOfIt();
}

void FigureView::leaveEvent(QEvent*) {
  read(std::nullopt);
}

bool FigureView::usesKey(const QKeyEvent& event) const {
  if (!curves() || event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) return false;
  switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
    case Qt::Key_Home:
      return true;
    case Qt::Key_Escape:
      return reading_ || painter_.isPart();
    default:
      return false;
  }
}

/// The keyboard moves the line along the chosen curve, or along the first that stands out.
void FigureView::moveReading(int pixels) {
  const QPointF middle(width() / 2.0, height() / 2.0);
  QPointF next = reading_.value_or(middle) + QPointF(pixels, 0);
  if (!painter_.timeAt(next, drawn())) {
    pan(pixels > 0 ? kPan : -kPan);
    next = reading_.value_or(middle);
  }
  if (painter_.timeAt(next, drawn())) read(next);
}

void FigureView::keyPressEvent(QKeyEvent* event) {
  if (!usesKey(*event)) return event->ignore();
  const int pixels = event->modifiers() & Qt::ShiftModifier ? 40 : 4;
  switch (event->key()) {
    case Qt::Key_Left:
      return moveReading(-pixels);
    case Qt::Key_Right:
      return moveReading(pixels);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(kKeyZoom, 0.5);
    case Qt::Key_Minus:
      return zoom(1 / kKeyZoom, 0.5);
    case Qt::Key_Home:
      return showAllOfIt();
    default:
      return reading_ ? read(std::nullopt) : showAllOfIt();
  }
}

void FigureView::fillMenu(QMenu& menu) {
  if (!curves()) return;
  menu.addAction(tr("All of the time axis\tHome"), this, &FigureView::showAllOfIt)->setEnabled(painter_.isPart());
  menu.addSeparator();
}

}  // namespace surefoot
