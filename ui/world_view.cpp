// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/world_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "core/text.h"
#include "ui/keyboard.h"
#include "ui/preferences.h"
#include "ui/scene_painter.h"
#include "ui/session.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

namespace {
constexpr double kFloor = 88;        // above the bottom edge [px]
constexpr double kReadOuts = 20;     // their baseline above the bottom edge [px]
constexpr double kHeadroom = 44;     // above the highest thing drawn [px]
constexpr double kSide = 24;         // beside the widest [px]
constexpr double kMostScale = 1700;  // [px/m]
constexpr std::size_t kTrail = 14;   // frames
constexpr double kJump = 0.05;       // the tip does not move that far in a frame [m]: the trail starts afresh
}  // namespace

WorldView::WorldView(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setAccessibleName(tr("World"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  connect(&session_, &Session::frame, this, &WorldView::nextFrame);
}

void WorldView::fit() {
  zoom_ = 1.0;
  pan_ = {};
  update();
}

void WorldView::nextFrame() {
  if (!isVisible() || session_.shown().pose.empty()) return;
  session_.environment().draw(session_.shown().pose, scene_);
  const double scale = pixelsPerMetre();
  if (!reducedMotion() || std::abs(scene_.focus.x - camera_) * scale > width() / 4.0) camera_ = scene_.focus.x;
  if (!trail_.empty() && std::hypot(trail_.back().x - scene_.tip.x, trail_.back().y - scene_.tip.y) > kJump)
    trail_.clear();
  trail_.push_back(scene_.tip);
  if (trail_.size() > kTrail) trail_.pop_front();
  update();
}

double WorldView::pixelsPerMetre() const {
  double fit = std::min(kMostScale, (height() - kFloor - kHeadroom) / scene_.height);
  if (scene_.width > 0) fit = std::min(fit, (width() - 2 * kSide) / scene_.width);
  return fit * zoom_;
}

double WorldView::floorLevel() const {
  return height() - kFloor + pan_.y();
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
  // What lies under the cursor stays there.
  const QPointF anchor(width() / 2.0, height() - kFloor), at = event->position() - anchor;
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
  if (event->button() == Qt::RightButton || event->button() == Qt::MiddleButton) panning_ = event->position() - pan_;
  if (event->button() != Qt::LeftButton || !overBody(event->position())) return;
  hand_ = event->position();
  session_.hold(toMetres(*hand_).x);
}

void WorldView::mouseMoveEvent(QMouseEvent* event) {
  if (panning_) pan_ = event->position() - *panning_;
  if (hand_) {
    hand_ = event->position();
    session_.hold(toMetres(*hand_).x);
  }
  setCursor(hand_ ? Qt::ClosedHandCursor : overBody(event->position()) ? Qt::OpenHandCursor : Qt::ArrowCursor);
  update();
}

void WorldView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return panning_.reset();
  if (hand_) session_.hold(std::nullopt);
  hand_.reset();
}

void WorldView::drawSpring(QPainter& p, const Theme& t) const {
  if (!hand_) return;
  p.setPen(QPen(t.accent, 1.5, Qt::DashLine));
  p.drawLine(toPixel(scene_.tip), *hand_);
  p.setBrush(t.accent);
  p.setPen(Qt::NoPen);
  p.drawEllipse(*hand_, 4, 4);
}

// The body as it would stand in the state under the cursor on a map.
void WorldView::drawGhost(QPainter& p, const Theme& t) const {
  const std::vector<double>& state = session_.examined();
  if (state.size() != session_.task().state.size()) return;
  const auto pose = session_.environment().poseAt(state);
  if (pose.empty()) return;
  Scene ghost;
  session_.environment().draw(pose, ghost);
  p.setOpacity(0.28);
  const double dx = scene_.focus.x - ghost.focus.x;  // it stands where the body stands
  ScenePainter painter(
      p, t, false,
      [&](Point at) {
        return toPixel({at.x + dx, at.y});
      },
      pixelsPerMetre());
  for (const Shape& shape : ghost.shapes)
    if (!std::holds_alternative<Label>(shape)) std::visit(painter, shape);
  p.setOpacity(1.0);
}

void WorldView::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  QPainter p(this);
  p.fillRect(rect(), t.paper);
  if (scene_.shapes.empty()) return;
  p.setRenderHint(QPainter::Antialiasing);
  if (scene_.metres) drawFloor(p, t);
  if (!reducedMotion()) drawTrail(p, t);
  ScenePainter painter(
      p, t, session_.shown().flash && !reducedMotion(), [this](Point at) { return toPixel(at); }, pixelsPerMetre());
  drawGhost(p, t);
  for (const Shape& shape : scene_.shapes) std::visit(painter, shape);
  drawSpring(p, t);
  drawReadOuts(p, t);
  if (ring_) drawFocusRing(p, *this);
}

// The ring is for those who walk by keys; a click or the start of the program needs none.
void WorldView::focusInEvent(QFocusEvent* event) {
  ring_ = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
  QWidget::focusInEvent(event);
}

void WorldView::drawFloor(QPainter& p, const Theme& t) const {
  const double y = floorLevel(), scale = pixelsPerMetre();
  p.setPen(QPen(t.ink, 1.25));
  p.drawLine(QPointF(0, y), QPointF(width(), y));
  // Ticks a power of ten apart, at least 5 px; a number on every tenth.
  double step = 1e-3;
  while (step * scale < 5) step *= 10;
  const double left = camera_ - width() / 2.0 / scale, right = camera_ + width() / 2.0 / scale;
  p.setFont(textFont(11));
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step * 10) - 1e-9)));
  for (auto i = static_cast<std::int64_t>(std::ceil(left / step)); static_cast<double>(i) * step <= right; ++i) {
    const double x = toPixel({static_cast<double>(i) * step, 0}).x();
    const int length = i % 10 == 0 ? 9 : i % 5 == 0 ? 6 : 4;
    p.setPen(QPen(i % 10 == 0 ? t.ink : t.outline, 1));
    p.drawLine(QPointF(x, y), QPointF(x, y + length));
    if (i % 10 != 0 || x < 20 || x > width() - 20) continue;
    p.setPen(t.quiet);
    QString text = toText(fixedText(static_cast<double>(i) * step, decimals));
    if (i == 0) text += QStringLiteral(" m");
    drawSymbol(p, QRectF(x - 40, y + 10, 80, 16), Qt::AlignHCenter, text);
  }
}

void WorldView::drawTrail(QPainter& p, const Theme& t) const {
  for (std::size_t i = 1; i < trail_.size(); ++i) {
    QColor colour = t.quiet;
    colour.setAlphaF(static_cast<float>(0.5 * static_cast<double>(i) / kTrail));
    p.setPen(QPen(colour, 1.25));
    p.drawLine(toPixel(trail_[i - 1]), toPixel(trail_[i]));
  }
}

void WorldView::drawReadOuts(QPainter& p, const Theme& t) const {
  const auto list = session_.environment().readOuts(session_.shown().pose);
  const double column = (width() - 24.0) / static_cast<double>(list.size());
  const double y = height() - kReadOuts;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const double x = 12 + column * static_cast<double>(i);
    p.setFont(textFont(13));
    p.setPen(t.quiet);
    drawSymbol(p, x, y, toText(list[i].symbol));
    const bool narrow = column < 125;  // no room for the unit
    const double right = x + std::min(76.0, column - (narrow ? 14 : 50));
    p.setFont(textFont(13, 500));
    p.setPen(t.ink);
    drawSymbol(p, QRectF(x, y - 14, right - x, 19), Qt::AlignRight, toText(fixedText(list[i].value, list[i].decimals)));
    if (narrow) continue;
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    p.drawText(QPointF(right + 4, y), toText(list[i].unit));
  }
}

}  // namespace surefoot
