// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/world/world_view.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "ui/controls/preferences.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/style/symbol_text.h"
#include "ui/support/keyboard.h"

namespace surefoot {

namespace {
constexpr double kJump = 0.05;  // [m]; after a larger move of the tip in one frame the trail starts anew
}  // namespace

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
  zoom_ = 1.0;
  pan_ = {};
  update();
}

void WorldView::nextFrame() {
  if (!isVisible() || looking_.shown().pose.empty()) return;
  life_.environment().draw(looking_.shown().pose, scene_);
  measure();
  const double scale = pixelsPerMetre();
  if (!reducedMotion() || std::abs(scene_.focus.x - camera_) * scale > width() / 4.0) camera_ = scene_.focus.x;
  if (!trail_.empty() && std::hypot(trail_.back().x - scene_.tip.x, trail_.back().y - scene_.tip.y) > kJump)
    trail_.clear();
  trail_.push_back(scene_.tip);
  if (trail_.size() > kTrail) trail_.pop_front();
  update();
}

void WorldView::setBeside(WorldView* other, const QString& which) {
  beside_ = other;
  which_ = which;
  updateGeometry();
  update();
}

double WorldView::pixelsPerMetre() const {
  const bool both = beside_ && beside_->isVisible() && beside_->fit_ > 0;
  return (both ? std::min(fit_, beside_->fit_) : fit_) * zoom_;
}

double WorldView::floorLevel() const {
  return height() - band_ + pan_.y();
}

/// The thickness of lines grows with the picture and with the texts.
double WorldView::strokes() const {
  constexpr double kUsual = 240;  // height of the drawn scene [px]
  return textScale() * std::clamp(pixelsPerMetre() / zoom_ * scene_.height / kUsual, 0.4, 1.0);
}

Point WorldView::toMetres(QPointF at) const {
  const double scale = pixelsPerMetre();
  return {camera_ + (at.x() - pan_.x() - width() / 2.0) / scale, (floorLevel() - at.y()) / scale};
}

QPointF WorldView::toPixel(Point p) const {
  const double scale = pixelsPerMetre();
  return {width() / 2.0 + pan_.x() + (p.x - camera_) * scale, floorLevel() - p.y * scale};
}

void WorldView::wheelEvent(QWheelEvent* event) {
  const double before = zoom_;
  zoom_ = std::clamp(zoom_ * std::pow(1.0015, event->angleDelta().y()), 0.3, 6.0);
  // The point under the cursor stays under it.
  const QPointF anchor(width() / 2.0, height() - band_), at = mouseAt(*event) - anchor;
  pan_ = at - (at - pan_) * (zoom_ / before);
  update();
  event->accept();
}

/// Near the pole's tip, or where it is thick enough to be taken hold of: within a hand's width of the tip.
bool WorldView::overBody(QPointF at) const {
  constexpr double kReach = 60;  // [px]
  const QPointF tip = toPixel(scene_.tip);
  return std::hypot(at.x() - tip.x(), at.y() - tip.y()) < kReach;
}

void WorldView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton || event->button() == Qt::MiddleButton) panning_ = mouseAt(*event) - pan_;
  if (event->button() != Qt::LeftButton || !overBody(mouseAt(*event))) return;
  hand_ = mouseAt(*event);
  looking_.hold(toMetres(*hand_).x);
}

void WorldView::mouseMoveEvent(QMouseEvent* event) {
  if (panning_) pan_ = mouseAt(*event) - *panning_;
  if (hand_) {
    hand_ = mouseAt(*event);
    looking_.hold(toMetres(*hand_).x);
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
