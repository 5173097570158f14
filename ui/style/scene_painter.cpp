// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/scene_painter.h"

#include <algorithm>
#include <cmath>

#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

QColor ScenePainter::colour(Ink ink) const {
  switch (ink) {
    case Ink::Solid:
      return t_.ink;
    case Ink::Body:
      return flash_ ? t_.fall : t_.ink;
    case Ink::Far:
      return t_.greedy;
    case Ink::Outline:
      return t_.outline;
    case Ink::Quiet:
      return t_.quiet;
    case Ink::Hairline:
      return t_.hairline;
    case Ink::Fall:
      break;
  }
  return t_.fall;
}

QBrush ScenePainter::brush(Fill fill) const {
  QColor wash = t_.fall;
  wash.setAlphaF(0.14f);
  switch (fill) {
    case Fill::None:
      return Qt::NoBrush;
    case Fill::Panel:
      return t_.panel;
    case Fill::Wash:
      return t_.fill;
    case Fill::Solid:
      return t_.ink;
    case Fill::Far:
      return t_.greedy;
    case Fill::Fall:
      break;
  }
  return wash;
}

QPen ScenePainter::outline(Ink ink, double width) const {
  return width > 0 ? QPen(colour(ink), width * strokes_, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin) : QPen(Qt::NoPen);
}

QPolygonF ScenePainter::pixels(const std::vector<Point>& points) const {
  QPolygonF polygon;
  for (const Point& point : points) polygon << toPixel_(point);
  return polygon;
}

void ScenePainter::operator()(const Polyline& line) const {
  QPen pen(colour(line.ink), line.width * strokes_, line.dashed ? Qt::CustomDashLine : Qt::SolidLine, Qt::RoundCap,
           Qt::RoundJoin);
  if (line.dashed) pen.setDashPattern({4, 4});
  p_.setPen(pen);
  p_.drawPolyline(pixels(line.points));
}

void ScenePainter::operator()(const Polygon& polygon) const {
  p_.setPen(outline(polygon.ink, polygon.width));
  p_.setBrush(brush(polygon.fill));
  p_.drawPolygon(pixels(polygon.points));
}

void ScenePainter::operator()(const Disc& disc) const {
  p_.setPen(outline(disc.ink, disc.width));
  p_.setBrush(brush(disc.fill));
  p_.drawEllipse(toPixel_(disc.centre), disc.radius * scale_, disc.radius * scale_);
}

QRectF ScenePainter::within(QRectF text) const {
  if (bounds_.isNull()) return text;
  if (text.right() > bounds_.right()) text.moveRight(bounds_.right());
  if (text.left() < bounds_.left()) text.moveLeft(bounds_.left());
  if (text.top() < bounds_.top()) text.moveTop(bounds_.top());
  return text;
}

QRectF ScenePainter::free(const QRectF& text) const {
  for (const double lines : {0.0, -1.0, 1.0}) {
    const QRectF where = within(text.translated(0, 0.85 * lines * text.height()));
    const QRectF letters = where.adjusted(0, 0.1 * where.height(), 0, -0.1 * where.height());
    const auto covers = [&](const QRectF& other) { return other.intersects(letters); };
    if (std::any_of(words_.begin(), words_.end(), covers)) continue;
    words_.push_back(letters);
    return where;
  }
  return {};
}

void ScenePainter::operator()(const Arrow& arrow) const {
  const QPointF from = toPixel_(arrow.from);
  const double side = arrow.length > 0 ? 1 : -1,
               head = std::clamp(Arrow::kHead * scale_, 8.0 * strokes_, 12.0 * strokes_);
  const QPointF to = from + QPointF(arrow.length * scale_ + head * side, 0);
  p_.setPen(QPen(t_.ink, 0.25 * head, Qt::SolidLine, Qt::FlatCap));
  p_.drawLine(from, to - QPointF(0.7 * head * side, 0));
  p_.setPen(Qt::NoPen);
  p_.setBrush(t_.ink);
  p_.drawPolygon(QPolygonF({to, to + QPointF(-head * side, -0.46 * head), to + QPointF(-head * side, 0.46 * head)}));
  p_.setFont(textFont(11));
  p_.setPen(t_.ink);
  const QString text = localNumbers(fromCore(arrow.text));
  const double width = symbolWidth(p_.font(), text), height = QFontMetricsF(p_.font()).height();
  // Above the arrow, but not over what the arrow begins at.
  const double middle = (from.x() + to.x() - width) / 2;
  const double left = side > 0 ? std::max(middle, from.x() + 2) : std::min(middle, from.x() - 2 - width);
  const QRectF where(left, from.y() - 0.6 * head - 4 - height, width, height);
  if (const QRectF place = free(where); !place.isNull()) drawSymbol(p_, place, Qt::AlignHCenter, text);
}

QFont ScenePainter::fontOf(const Label& label) {
  return textFont(label.ink == Ink::Solid ? 13 : 11);
}

void ScenePainter::operator()(const Label& label) const {
  constexpr int kSmallest = 7;  // [px]
  QFont font = fontOf(label);
  const QString text = localNumbers(fromCore(label.text));
  double width = symbolWidth(font, text);
  if (const double room = label.room * scale_; room > 0 && width > room) {
    font.setPixelSize(static_cast<int>(font.pixelSize() * room / width));
    if (font.pixelSize() < kSmallest) return;
    width = symbolWidth(font, text);
  }
  p_.setFont(font);
  const double k = textScale(), height = QFontMetricsF(font).height();
  const QPointF at = toPixel_(label.at) + k * QPointF(label.dx, label.dy);
  const double left = label.align == 0 ? at.x() - width / 2 : label.align > 0 ? at.x() : at.x() - width;
  const QRectF where = free({left, at.y() - height / 2, width, height});
  if (where.isNull()) return;
  if (label.halo) {
    p_.setPen(Qt::NoPen);
    p_.setBrush(t_.paper);
    p_.drawRoundedRect(where.adjusted(-3, 0, 3, 0), 4, 4);
  }
  p_.setPen(label.ink == Ink::Fall ? t_.fallText : colour(label.ink));
  drawSymbol(p_, where, Qt::AlignHCenter, text);
}

void paintScene(const Scene& scene, const ScenePainter& painter) {
  const auto over = [](const Shape& shape) {
    const auto* label = std::get_if<Label>(&shape);
    return label && label->halo;
  };
  for (const bool last : {false, true})
    for (const Shape& shape : scene.shapes)
      if (over(shape) == last) std::visit(painter, shape);
}

}  // namespace surefoot
