// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robot/robot_picture.h"

#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/language/numbers.h"
#include "ui/style/scene_painter.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr double kReach = 74, kHandle = 6;  // [px]: of a handle from its joint, and its radius
constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

RobotPicture::RobotPicture(QWidget* parent) : Painted(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("The robot"));
}

void RobotPicture::setInspection(const EnvironmentInspection* inspection) {
  inspection_ = inspection;
  pointed_ = nullptr;
  if (!inspection_ || (chosen_ && *chosen_ >= inspection_->handles.size())) chosen_.reset();
  held_.reset();
  if (inspection_) setAccessibleDescription(toText(inspection_->title));
  update();
}

void RobotPicture::setMoving(std::optional<Scene> scene) {
  moving_ = std::move(scene);
  update();
}

void RobotPicture::setLine(int line) {
  line_ = line;
  update();
}

void RobotPicture::measure() {
  const Scene& s = scene();
  const double above = std::max(s.height, 0.05), across = std::max(s.width, 1.2 * above);
  scale_ = std::min(0.72 * height() / above, 0.8 * width() / across);
  floor_ = 0.5 * (height() - 24) + above * scale_ / 2;
}

QPointF RobotPicture::toPixel(Point at) const {
  return {0.5 * width() + (at.x - scene().focus.x) * scale_, floor_ - at.y * scale_};
}

QPointF RobotPicture::placeOf(const AngleHandle& handle) const {
  const double way = handle.zero + handle.angle;
  return toPixel(handle.centre) + kReach * QPointF(std::cos(way), -std::sin(way));
}

double RobotPicture::angleOf(const AngleHandle& handle, QPointF at) const {
  const QPointF arm = at - toPixel(handle.centre);
  double angle = std::atan2(-arm.y(), arm.x()) - handle.zero;
  angle -= 2 * std::numbers::pi * std::floor(angle / (2 * std::numbers::pi) + 0.5);
  return std::round(angle / kDegree) * kDegree;
}

std::optional<std::size_t> RobotPicture::handleAt(QPointF at) const {
  if (!inspection_ || moving_) return std::nullopt;
  for (std::size_t i = 0; i < inspection_->handles.size(); ++i)
    if (inspection_->handles[i].number && QLineF(at, placeOf(inspection_->handles[i])).length() < 2 * kHandle) return i;
  return std::nullopt;
}

const NamedPart* RobotPicture::partAt(QPointF at) const {
  constexpr double kNear = 16;
  if (!inspection_ || moving_) return nullptr;
  const NamedPart* nearest = nullptr;
  double distance = kNear;
  for (const NamedPart& part : inspection_->parts)
    if (const double d = QLineF(at, toPixel(part.at)).length(); d < distance) distance = d, nearest = &part;
  return nearest;
}

void RobotPicture::paintEvent(QPaintEvent*) {
  ScaledPainter painter(this);
  const Theme& t = themeOf(*this);
  painter.fillRect(rect(), t.paper);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!inspection_) return;
  measure();
  drawFloor(painter);
  const auto pixel = [this](Point at) { return toPixel(at); };
  ScenePainter scenePainter(painter, t, false, pixel, scale_);
  scenePainter.setBounds(rect());
  painter.setClipRect(rect());
  paintScene(scene(), scenePainter);
  if (moving_) return;
  drawHandles(painter);
  drawNames(painter);
}

void RobotPicture::drawFloor(QPainter& painter) const {
  const Theme& t = themeOf(*this);
  if (!scene().metres) return;
  painter.setPen(QPen(t.ink, 1.5));
  painter.drawLine(QPointF(0, floor_), QPointF(width(), floor_));
  double step = 1.0;  // [m] between numbers
  while (step * scale_ > 160)
    step /= step == 1.0 || std::abs(std::log10(step) - std::round(std::log10(step))) < 1e-9 ? 2 : 2.5;
  while (step * scale_ < 60) step *= 2;
  painter.setFont(textFont(11));
  painter.setPen(t.quiet);
  const double left = scene().focus.x - 0.5 * width() / scale_, right = scene().focus.x + 0.5 * width() / scale_;
  for (double x = std::ceil(left / step) * step; x < right; x += step) {
    const double at = toPixel({x, 0}).x();
    painter.drawLine(QPointF(at, floor_), QPointF(at, floor_ + 5));
    const QString text = fixedNumber(x, step < 0.1 ? 2 : step < 1 ? 1 : 0);
    painter.drawText(QRectF(at - 40, floor_ + 6, 80, 16), Qt::AlignHCenter, text);
  }
}

void RobotPicture::drawNames(QPainter& painter) const {
  const Theme& t = themeOf(*this);
  painter.setFont(textFont(11));
  double y = 20;
  std::vector<QRectF> used;
  for (const NamedPart& part : inspection_->parts) {
    const bool lit = part.line == line_ || &part == pointed_;
    if (!inside_ && !lit) continue;
    const QPointF at = toPixel(part.at);
    const QString name = toText(part.name);
    const double w = QFontMetricsF(painter.font()).horizontalAdvance(name);
    QRectF where(at.x() < 0.5 * width() ? std::max(8.0, at.x() - 90 - w) : std::min(width() - 8 - w, at.x() + 90),
                 at.y() - 8, w, 16);
    for (const QRectF& other : used)
      if (other.intersects(where)) where.moveTop(other.bottom() + 1);
    used.push_back(where);
    painter.setPen(QPen(lit ? t.ink : t.hairline, 1));
    painter.drawLine(at, QPointF(where.left() > at.x() ? where.left() - 4 : where.right() + 4, where.center().y()));
    painter.setPen(lit ? t.ink : t.quiet);
    painter.drawText(where, Qt::AlignCenter, name);
  }
  if (!pointed_) return;
  const QString about = toText(pointed_->about);
  const double w = std::min(width() - 24.0, QFontMetricsF(painter.font()).horizontalAdvance(about) + 16);
  const QRectF card(width() - w - 12, y, w, 40);
  painter.setPen(QPen(t.hairline, 1));
  painter.setBrush(t.panel);
  painter.drawRoundedRect(card, 4, 4);
  painter.setPen(t.ink);
  painter.setFont(textFont(13, 500));
  painter.drawText(card.adjusted(8, 2, -8, -20), Qt::AlignLeft | Qt::AlignVCenter, toText(pointed_->name));
  painter.setFont(textFont(11));
  painter.setPen(t.quiet);
  painter.drawText(card.adjusted(8, 18, -8, -2), Qt::AlignLeft | Qt::AlignVCenter,
                   QFontMetricsF(painter.font()).elidedText(about, Qt::ElideRight, w - 16));
}

void RobotPicture::drawHandles(QPainter& painter) const {
  const Theme& t = themeOf(*this);
  const auto& all = inspection_->handles;
  for (std::size_t i = 0; i + 1 < all.size(); i += 2) {  // a lower and an upper one each
    const QPointF centre = toPixel(all[i].centre);
    const bool lit = (chosen_ && *chosen_ / 2 == i / 2) || (pointed_ && pointed_->name == all[i].joint);
    if (!inside_ && !hasFocus() && !lit) continue;
    const QRectF circle(centre.x() - kReach, centre.y() - kReach, 2 * kReach, 2 * kReach);
    const double from = (all[i].zero + all[i].angle) / kDegree, span = (all[i + 1].angle - all[i].angle) / kDegree;
    painter.setPen(Qt::NoPen);
    QColor wash = t.fill;
    wash.setAlphaF(lit ? 0.8f : 0.4f);
    painter.setBrush(wash);
    painter.drawPie(circle, static_cast<int>(from * 16), static_cast<int>(span * 16));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(lit ? t.ink : t.quiet, 1));
    painter.drawArc(circle, static_cast<int>(from * 16), static_cast<int>(span * 16));
    for (const std::size_t one : {i, i + 1}) {
      if (!all[one].number) continue;
      const bool chosen = chosen_ == one;
      if (chosen && hasFocus()) {
        painter.setPen(QPen(t.accent, 2));
        painter.setBrush(t.panel);
        painter.drawEllipse(placeOf(all[one]), kHandle + 4, kHandle + 4);
      }
      painter.setPen(QPen(t.ink, 1.5));
      painter.setBrush(t.panel);
      painter.drawEllipse(placeOf(all[one]), kHandle, kHandle);
      if (!chosen) continue;
      painter.setPen(t.ink);
      painter.setFont(textFont(13, 500));
      const QPointF at = placeOf(all[one]) + QPointF(14, 4);
      painter.drawText(at, tr("%1°, limit, line %2")
                               .arg(fixedNumber(all[one].angle / kDegree, 0), QString::number(all[one].number->line)));
    }
  }
}

void RobotPicture::mouseMoveEvent(QMouseEvent* event) {
  inside_ = true;
  const QPointF at = mouseAt(*event);
  if (held_) {
    const AngleHandle handle = inspection_->handles[*held_];
    Q_EMIT limitMoved(handle, angleOf(handle, at));
    return;
  }
  pointed_ = partAt(at);
  setCursor(handleAt(at) || pointed_ ? Qt::PointingHandCursor : Qt::ArrowCursor);
  update();
}

void RobotPicture::mousePressEvent(QMouseEvent* event) {
  const QPointF at = mouseAt(*event);
  held_ = chosen_ = handleAt(at);
  if (!held_)
    if (const NamedPart* part = partAt(at)) Q_EMIT lineAsked(part->line);
  update();
}

void RobotPicture::mouseReleaseEvent(QMouseEvent*) {
  held_.reset();
}

void RobotPicture::leaveEvent(QEvent*) {
  inside_ = false;
  pointed_ = nullptr;
  update();
}

void RobotPicture::moveHandle(double by) {
  const AngleHandle handle = inspection_->handles[*chosen_];
  Q_EMIT limitMoved(handle, std::round((handle.angle + by) / kDegree) * kDegree);
}

// Tab goes through the handles before it leaves the picture.
bool RobotPicture::event(QEvent* event) {
  if (event->type() == QEvent::KeyPress && inspection_ && !moving_ && !inspection_->handles.empty()) {
    auto* key = static_cast<QKeyEvent*>(event);
    const int step = key->key() == Qt::Key_Tab ? 1 : key->key() == Qt::Key_Backtab ? -1 : 0;
    const int next = step == 0 ? -1 : chosen_ ? static_cast<int>(*chosen_) + step : step > 0 ? 0 : -1;
    if (next >= 0 && next < static_cast<int>(inspection_->handles.size())) {
      chosen_ = static_cast<std::size_t>(next);
      update();
      return true;
    }
    if (step != 0) chosen_.reset();
  }
  return Painted::event(event);
}

void RobotPicture::keyPressEvent(QKeyEvent* event) {
  const double size = event->modifiers() & Qt::ShiftModifier ? 10 * kDegree : kDegree;
  const int key = event->key();
  const bool up = key == Qt::Key_Up || key == Qt::Key_Right, down = key == Qt::Key_Down || key == Qt::Key_Left;
  if (!moving_ && chosen_ && inspection_ && inspection_->handles[*chosen_].number && (up || down))
    return moveHandle(up ? size : -size);
  if (moving_) return Q_EMIT keyPressed(key), event->accept();
  Painted::keyPressEvent(event);
}

}  // namespace surefoot

#include "moc_robot_picture.cpp"
