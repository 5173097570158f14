// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene_painter.h"

#include "ui/symbol_text.h"

namespace surefoot {

QColor ScenePainter::colour(Ink ink) const {
  switch (ink) {
    case Ink::Solid:
      return t_.ink;
    case Ink::Body:
      return flash_ ? t_.fall : t_.ink;
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
    case Fill::Fall:
      break;
  }
  return wash;
}

QPen ScenePainter::outline(Ink ink, double width) const {
  return width > 0 ? QPen(colour(ink), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin) : QPen(Qt::NoPen);
}

QPolygonF ScenePainter::pixels(const std::vector<Point>& points) const {
  QPolygonF polygon;
  for (const Point& point : points) polygon << toPixel_(point);
  return polygon;
}

void ScenePainter::operator()(const Polyline& line) const {
  QPen pen(colour(line.ink), line.width, line.dashed ? Qt::CustomDashLine : Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
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

void ScenePainter::operator()(const Arrow& arrow) const {
  const QPointF from = toPixel_(arrow.from);
  const double side = arrow.length > 0 ? 1 : -1;
  const QPointF to = from + QPointF(arrow.length + 12 * side, 0);
  p_.setPen(QPen(t_.ink, 3, Qt::SolidLine, Qt::FlatCap));
  p_.drawLine(from, to - QPointF(8 * side, 0));
  p_.setPen(Qt::NoPen);
  p_.setBrush(t_.ink);
  p_.drawPolygon(QPolygonF({to, to + QPointF(-12 * side, -5.5), to + QPointF(-12 * side, 5.5)}));
  p_.setFont(textFont(11));
  p_.setPen(t_.ink);
  drawSymbol(p_, QRectF((from.x() + to.x()) / 2 - 50, from.y() - 24, 100, 16), Qt::AlignHCenter,
             QString::fromStdString(arrow.text));
}

void ScenePainter::operator()(const Label& label) const {
  const QPointF at = toPixel_(label.at) + QPointF(label.dx, label.dy);
  p_.setFont(textFont(label.ink == Ink::Solid ? 13 : 11));
  const QRectF where = label.align == 0  ? QRectF(at.x() - 80, at.y() - 8, 160, 16)
                       : label.align > 0 ? QRectF(at.x(), at.y() - 8, 160, 16)
                                         : QRectF(at.x() - 160, at.y() - 8, 160, 16);
  const auto align = label.align == 0 ? Qt::AlignHCenter : label.align > 0 ? Qt::AlignLeft : Qt::AlignRight;
  const QString text = QString::fromStdString(label.text);
  if (label.halo) {
    p_.setPen(t_.paper);
    for (const QPointF& d : {QPointF(-2, 0), QPointF(2, 0), QPointF(0, -2), QPointF(0, 2), QPointF(-1.4, -1.4),
                             QPointF(1.4, -1.4), QPointF(-1.4, 1.4), QPointF(1.4, 1.4)})
      drawSymbol(p_, where.translated(d), align, text);
  }
  p_.setPen(label.ink == Ink::Fall ? t_.fallText : colour(label.ink));
  drawSymbol(p_, where, align, text);
}

}  // namespace surefoot
