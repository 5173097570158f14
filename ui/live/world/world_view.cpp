// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/world/world_view.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "ui/controls/preferences.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/support/keyboard.h"

namespace surefoot {

WorldView::WorldView(RunningLife& life, Looking& looking, QWidget* parent)
    : Painted(parent),
      life_(life),
      looking_(looking) {
  setAccessibleName(tr("World"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  connect(&looking_, &Looking::frame, this, &WorldView::nextFrame);
}

void WorldView::fit() {
  picture_.zoom = 1.0;
  picture_.pan = {};
  update();
}

void WorldView::nextFrame() {
  if (!isVisible() || looking_.shown().pose.empty()) return;
  Scene& scene = picture_.scene;
  life_.environment().draw(looking_.shown().pose, scene);
  measure();
  if (!reducedMotion() || std::abs(scene.focus.x - picture_.camera) * pixelsPerMetre() > width() / 4.0)
    picture_.camera = scene.focus.x;
  picture_.follow(scene.tip);
  update();
}

void WorldView::setBeside(WorldView* other, const QString& which) {
  beside_ = other;
  which_ = which;
  updateGeometry();
  update();
}

void WorldView::wheelEvent(QWheelEvent* event) {
  double& zoom = picture_.zoom;
  const double before = zoom;
  zoom = std::clamp(zoom * std::pow(1.0015, event->angleDelta().y()), 0.3, 6.0);
  // The point under the cursor stays under it.
  const QPointF at = mouseAt(*event) - picture_.anchor();
  picture_.pan = at - (at - picture_.pan) * (zoom / before);
  update();
  event->accept();
}

/// Near the pole's tip, or where it is thick enough to be taken hold of: within a hand's width of the tip.
bool WorldView::overBody(QPointF at) const {
  constexpr double kReach = 60;  // [px]
  const QPointF tip = this->tip();
  return std::hypot(at.x() - tip.x(), at.y() - tip.y()) < kReach;
}

void WorldView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton || event->button() == Qt::MiddleButton)
    panning_ = mouseAt(*event) - picture_.pan;
  if (event->button() != Qt::LeftButton || !overBody(mouseAt(*event))) return;
  hand_ = mouseAt(*event);
  looking_.hold(picture_.toMetres(*hand_).x);
}

void WorldView::mouseMoveEvent(QMouseEvent* event) {
  if (panning_) picture_.pan = mouseAt(*event) - *panning_;
  if (hand_) {
    hand_ = mouseAt(*event);
    looking_.hold(picture_.toMetres(*hand_).x);
  }
  setCursor(hand_ ? Qt::ClosedHandCursor : overBody(mouseAt(*event)) ? Qt::OpenHandCursor : Qt::ArrowCursor);
  update();
}

void WorldView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return panning_.reset();
  if (hand_) looking_.hold(std::nullopt);
  hand_.reset();
}

// The ring is for people who use Tab; a click or the start of the program needs none.
void WorldView::focusInEvent(QFocusEvent* event) {
  ring_ = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
  QWidget::focusInEvent(event);
}

}  // namespace surefoot

#include "moc_world_view.cpp"
