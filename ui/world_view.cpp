// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/world_view.h"

#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "core/text.h"
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
  connect(&session_, &Session::frame, this, &WorldView::nextFrame);
}

void WorldView::fit() {
  zoom_ = 1.0;
  update();
}

void WorldView::nextFrame() {
  if (!isVisible() || session_.shown().pose.empty()) return;
  session_.environment().draw(session_.shown().pose, scene_);
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
  return height() - kFloor;
}

QPointF WorldView::toPixel(Point p) const {
  const double scale = pixelsPerMetre();
  return {width() / 2.0 + (p.x - scene_.focus.x) * scale, floorLevel() - p.y * scale};
}

void WorldView::wheelEvent(QWheelEvent* event) {
  zoom_ = std::clamp(zoom_ * std::pow(1.0015, event->angleDelta().y()), 0.3, 6.0);
  update();
  event->accept();
}

void WorldView::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  QPainter p(this);
  p.fillRect(rect(), t.paper);
  if (scene_.shapes.empty()) return;
  p.setRenderHint(QPainter::Antialiasing);
  if (scene_.metres) drawFloor(p, t);
  drawTrail(p, t);
  ScenePainter painter(
      p, t, session_.shown().flash, [this](Point at) { return toPixel(at); }, pixelsPerMetre());
  for (const Shape& shape : scene_.shapes) std::visit(painter, shape);
  drawReadOuts(p, t);
}

void WorldView::drawFloor(QPainter& p, const Theme& t) const {
  const double y = floorLevel(), scale = pixelsPerMetre();
  p.setPen(QPen(t.ink, 1.25));
  p.drawLine(QPointF(0, y), QPointF(width(), y));
  // Ticks a power of ten apart, at least 5 px; a number on every tenth.
  double step = 1e-3;
  while (step * scale < 5) step *= 10;
  const double left = scene_.focus.x - width() / 2.0 / scale, right = scene_.focus.x + width() / 2.0 / scale;
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
    const double right = x + std::min(76.0, column - 50);
    p.setFont(textFont(13, 500));
    p.setPen(t.ink);
    drawSymbol(p, QRectF(x, y - 14, right - x, 19), Qt::AlignRight, toText(fixedText(list[i].value, list[i].decimals)));
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    p.drawText(QPointF(right + 4, y), toText(list[i].unit));
  }
}

}  // namespace surefoot
