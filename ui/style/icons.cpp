// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/icons.h"

#include <QPainterPath>

namespace surefoot {

namespace {
constexpr double kStroke = 1.5;

void lines(QPainter& p, std::initializer_list<QLineF> list) {
  for (const QLineF& line : list) p.drawLine(line);
}

void corner(QPainter& p, QPointF at, double dx, double dy) {
  lines(p, {{at, at + QPointF(dx, 0)}, {at, at + QPointF(0, dy)}});
}
}  // namespace

void drawIcon(QPainter& p, Icon icon, const QRectF& where, const QColor& colour) {
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.translate(where.center());
  p.setPen(QPen(colour, kStroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  p.setBrush(Qt::NoBrush);
  switch (icon) {
    case Icon::Run:
      p.setBrush(colour);
      p.drawPolygon(QPolygonF({{-4, -5.5}, {5, 0}, {-4, 5.5}}));
      break;
    case Icon::Pause:
      p.setPen(QPen(colour, 2.5, Qt::SolidLine, Qt::FlatCap));
      lines(p, {{-3, -6, -3, 6}, {3, -6, 3, 6}});
      break;
    case Icon::Step:
      p.drawPolygon(QPolygonF({{-5, -5.5}, {2.5, 0}, {-5, 5.5}}));
      lines(p, {{5.5, -5.5, 5.5, 5.5}});
      break;
    case Icon::Restart:
      p.drawArc(QRectF(-5.5, -4.5, 11, 11), 60 * 16, -310 * 16);
      lines(p, {{-2.2, -8, 1.4, -4.6}, {-2.4, -1.8, 1.4, -4.6}});
      break;
    case Icon::Turbo:
      p.setBrush(colour);
      p.drawPolygon(QPolygonF({{1.5, -7}, {-4.5, 1.2}, {-0.8, 1.2}, {-1.5, 7}, {4.5, -1.6}, {0.8, -1.6}}));
      break;
    case Icon::FullSize:
      corner(p, {5, -5}, -4, 4), corner(p, {-5, 5}, 4, -4);
      lines(p, {{5, -5, 0.8, -0.8}, {-5, 5, -0.8, 0.8}});
      break;
    case Icon::NormalSize:
      corner(p, {1, -1}, 4, -4), corner(p, {-1, 1}, -4, 4);
      lines(p, {{1, -1, 5, -5}, {-1, 1, -5, 5}});
      break;
    case Icon::Close:
      lines(p, {{-4, -4, 4, 4}, {-4, 4, 4, -4}});
      break;
    case Icon::Help: {
      QPainterPath hook(QPointF(-2.8, -2.6));
      hook.cubicTo(-2.8, -6.4, 3, -6.2, 2.8, -2.6);
      hook.cubicTo(2.7, -0.4, 0, -0.6, 0, 1.6);
      p.drawPath(hook);
      p.setPen(QPen(colour, 2, Qt::SolidLine, Qt::RoundCap));
      p.drawPoint(QPointF(0, 5));
      break;
    }
    case Icon::Chevron:
      lines(p, {{-3.5, -1.8, 0, 1.8}, {0, 1.8, 3.5, -1.8}});
      break;
  }
  p.restore();
}

}  // namespace surefoot
