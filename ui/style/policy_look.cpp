// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/policy_look.h"

#include <QPainter>
#include <cmath>
#include <iterator>
#include <numbers>

#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

struct Line {
  std::string_view policy;
  QColor Theme::*colour;
  Marker marker;
};

constexpr Line kLooks[] = {{"greedy", &Theme::greedy, Marker::Diamond},
                           {"epsilon-greedy", &Theme::epsilonGreedy, Marker::Circle},
                           {"trl", &Theme::trl, Marker::Triangle},
                           {"softmax", &Theme::softmax, Marker::Square}};

constexpr Line kOthers[] = {{"", &Theme::otherPolicy, Marker::Pentagon}, {"", &Theme::anotherPolicy, Marker::Cross}};

const Line& lineOf(std::string_view policy) {
  if (policy.empty()) return kLooks[0];
  for (const Line& line : kLooks)
    if (line.policy == policy) return line;
  return kOthers[policy.size() % std::size(kOthers)];
}

QPolygonF pentagon() {
  constexpr double kRadius = 4;
  QPolygonF corners;
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * std::numbers::pi * i / 5;
    corners << QPointF(kRadius * std::sin(angle), -kRadius * std::cos(angle));
  }
  return corners;
}

}  // namespace

PolicyLook policyLook(std::string_view policy, const Theme& theme) {
  const Line& line = lineOf(policy);
  return {theme.*line.colour, line.marker};
}

void drawMarker(QPainter& painter, QPointF c, const PolicyLook& look, bool filled) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(c);
  painter.scale(textScale(), textScale());
  painter.setPen(QPen(look.colour, 1.5));
  painter.setBrush(filled ? QBrush(look.colour) : QBrush(Qt::NoBrush));
  switch (look.marker) {
    case Marker::Circle:
      painter.drawEllipse(QPointF(), 3.5, 3.5);
      break;
    case Marker::Square:
      painter.drawRect(QRectF(-3, -3, 6, 6));
      break;
    case Marker::Triangle:
      painter.drawPolygon(QPolygonF({{-4, 3}, {0, -4}, {4, 3}}));
      break;
    case Marker::Diamond:
      painter.drawPolygon(QPolygonF({{-4, 0}, {0, -4}, {4, 0}, {0, 4}}));
      break;
    case Marker::Pentagon:
      painter.drawPolygon(pentagon());
      break;
    case Marker::Cross:
      painter.drawPolygon(QPolygonF({{-4, -1.5},
                                     {-1.5, -1.5},
                                     {-1.5, -4},
                                     {1.5, -4},
                                     {1.5, -1.5},
                                     {4, -1.5},
                                     {4, 1.5},
                                     {1.5, 1.5},
                                     {1.5, 4},
                                     {-1.5, 4},
                                     {-1.5, 1.5},
                                     {-4, 1.5}}));
      break;
  }
  painter.restore();
}

}  // namespace surefoot
