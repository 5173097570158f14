// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/signals/phase_portrait.h"

#include <fmt/format.h>

#include <QMenu>
#include <algorithm>
#include <cmath>

#include "core/text/text.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/live/signals/signals_shown.h"
#include "ui/running/looking.h"
#include "ui/style/round_numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr int kAxisText = 11;  // [px]

QString tickText(double value, double step) {
  const int decimals = step >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
  return localNumbers(decimals == 0 ? countText(value) : fixedText(std::abs(value) < step / 2 ? 0.0 : value, decimals));
}

QString axisTitle(const Signal& s) {
  QString title = fromCore(s.title);
  if (!s.symbol.empty()) title += ' ' + toText(s.symbol);
  return s.unit.empty() ? title : QStringLiteral("%1 [%2]").arg(title, toText(s.unit));
}

}  // namespace

PhasePortrait::PhasePortrait(SignalsShown& shown, QWidget* parent) : Painted(parent), shown_(shown) {
  setAccessibleName(tr("Phase portrait"));
  shown_.watchedBy(*this);
  for (const auto is : {&SignalsShown::changed, &SignalsShown::moment})
    connect(&shown_, is, this, [this] { update(); });
}

std::pair<std::size_t, std::size_t> PhasePortrait::rowsShown(const SignalTable& table) const {
  if (table.rows() == 0) return {0, 0};
  const std::vector<double>& time = table.columns()[0];
  const double later = &table == &shown_.second() ? shown_.secondLater() : 0.0;
  const auto from = std::lower_bound(time.begin(), time.end(), shown_.from() - later);
  const auto to = std::upper_bound(from, time.end(), shown_.to() - later);
  return {static_cast<std::size_t>(from - time.begin()), static_cast<std::size_t>(to - time.begin())};
}

PhasePortrait::Axis PhasePortrait::axisOf(std::size_t signal, double pixels) const {
  double low = kInfinity, high = -kInfinity;
  for (const SignalTable* table : {&shown_.table(), &shown_.second()}) {
    const auto* column = columnLike(*table, shown_.table(), signal);
    const auto [from, to] = rowsShown(*table);
    for (std::size_t row = from; column && row < to; ++row) {
      const double value = (*column)[row];
      if (!std::isnan(value)) low = std::min(low, value), high = std::max(high, value);
    }
  }
  if (low > high) low = 0.0, high = 1.0;
  if (high - low < 1e-9) low -= 0.5, high += 0.5;
  const double step = niceAbove((high - low) / std::max(2.0, pixels / 70.0));
  return {std::floor(low / step) * step, std::ceil(high / step) * step, step};
}

QPointF PhasePortrait::at(double x, double y) const {
  return {plot_.left() + (x - horizontal_.low) / (horizontal_.high - horizontal_.low) * plot_.width(),
          plot_.bottom() - (y - vertical_.low) / (vertical_.high - vertical_.low) * plot_.height()};
}

QPointF PhasePortrait::at(std::size_t row) const {
  const auto& columns = shown_.table().columns();
  return at(columns[x_][row], columns[y_][row]);
}

void PhasePortrait::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.fillRect(rect(), t.panel);
  const SignalTable& table = shown_.table();
  const auto [from, to] = rowsShown(table);
  if (to < from + 2) {
    p.setFont(textFont(kAxisText));
    p.setPen(t.quiet);
    p.drawText(rect().adjusted(12, 0, -12, 0), Qt::AlignCenter | Qt::TextWordWrap,
               tr("Two signals against each other"));
    return;
  }
  plot_ = QRectF(rect()).adjusted(58, 10, -18, -62);
  std::tie(x_, y_) = shown_.axes();
  horizontal_ = axisOf(x_, plot_.width());
  vertical_ = axisOf(y_, plot_.height());
  drawAxes(p);
  p.setRenderHint(QPainter::Antialiasing);
  p.save();
  p.setClipRect(plot_.adjusted(-3, -3, 3, 3));
  QColor faint = shown_.learnerColour(t);
  faint.setAlphaF(0.4f);
  p.setPen(QPen(faint, 1));
  drawWay(p, table, from, to);
  const SignalTable& second = shown_.second();
  if (second.rows() > 1) {
    QPen dashed(t.ink, 1.1);
    dashed.setDashPattern({4, 3});
    p.setPen(dashed);
    const auto own = shown_.cycle(second, shown_.secondStrides());
    const auto all = rowsShown(second);
    own ? drawWay(p, second, own->first, own->second + 1) : drawWay(p, second, all.first, all.second);
  }
  const auto cycle = shown_.cycle(table, shown_.strides());
  if (cycle) {
    p.setPen(QPen(shown_.learnerColour(t), 2.2));
    drawWay(p, table, cycle->first, std::min(cycle->second + 1, table.rows()));
    drawArrows(p, cycle->first, cycle->second);
    if (!shown_.strides().empty()) {
      p.setPen(QPen(t.ink, 1.5));
      p.setBrush(t.panel);
      const QPointF touch = at(cycle->first);
      p.drawRect(QRectF(touch - QPointF(4, 4), QSizeF(8, 8)));
    }
  }
  if (const auto row = shown_.row(); row && *row < table.rows()) {
    p.setPen(QPen(t.ink, 2));
    p.setBrush(t.panel);
    p.drawEllipse(at(*row), 5.5, 5.5);
    p.setBrush(t.ink);
    p.setPen(Qt::NoPen);
    p.drawEllipse(at(*row), 1.8, 1.8);
  }
  p.restore();
  drawLegend(p, cycle.has_value());
}

void PhasePortrait::drawAxes(QPainter& p) const {
  const Theme& t = themeOf(*this);
  const auto& signals = shown_.table().signals();
  p.setFont(textFont(kAxisText));
  for (double v = horizontal_.low; v <= horizontal_.high + 1e-9; v += horizontal_.step) {
    const double x =
        std::round(plot_.left() + (v - horizontal_.low) / (horizontal_.high - horizontal_.low) * plot_.width()) + 0.5;
    p.setPen(QPen(t.hairline, 1));
    p.drawLine(QPointF(x, plot_.top()), QPointF(x, plot_.bottom()));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(x - 40, plot_.bottom() + 3, 80, 16), Qt::AlignHCenter, tickText(v, horizontal_.step));
  }
  for (double v = vertical_.low; v <= vertical_.high + 1e-9; v += vertical_.step) {
    const double y =
        std::round(plot_.bottom() - (v - vertical_.low) / (vertical_.high - vertical_.low) * plot_.height()) + 0.5;
    p.setPen(QPen(t.hairline, 1));
    p.drawLine(QPointF(plot_.left(), y), QPointF(plot_.right(), y));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(18, y - 8, plot_.left() - 24, 16), Qt::AlignRight, tickText(v, vertical_.step));
  }
  p.setPen(t.quiet);
  drawSymbol(p, QRectF(plot_.left(), plot_.bottom() + 19, plot_.width(), 16), Qt::AlignHCenter, axisTitle(signals[x_]));
  p.save();
  p.translate(10, plot_.center().y());
  p.rotate(-90);
  drawSymbol(p, QRectF(-plot_.height() / 2, -8, plot_.height(), 16), Qt::AlignHCenter, axisTitle(signals[y_]));
  p.restore();
}

void PhasePortrait::drawWay(QPainter& p, const SignalTable& table, std::size_t from, std::size_t to) const {
  const std::vector<double>& episode = table.columns()[1];
  const auto* xs = columnLike(table, shown_.table(), x_);
  const auto* ys = columnLike(table, shown_.table(), y_);
  if (!xs || !ys) return;
  const std::vector<double>&x = *xs, &y = *ys;
  QPolygonF piece;
  const auto flush = [&] {
    if (piece.size() > 1) p.drawPolyline(piece);
    piece.clear();
  };
  for (std::size_t row = from; row < std::min(to, table.rows()); ++row) {
    if (row > from && (episode[row] != episode[row - 1] || comesAfterAGap(table, row))) flush();
    if (std::isnan(x[row]) || std::isnan(y[row])) {
      flush();
      continue;
    }
    constexpr double kNear = 0.7;  // [px]: nearer points draw nothing that is seen
    const QPointF point = at(x[row], y[row]);
    if (!piece.isEmpty() && (point - piece.back()).manhattanLength() < kNear) continue;
    // An angle that wraps jumps through half of the picture: no line is drawn there.
    if (!piece.isEmpty() && std::abs(point.x() - piece.back().x()) > plot_.width() / 2) flush();
    piece << point;
  }
  flush();
}

void PhasePortrait::drawArrows(QPainter& p, std::size_t from, std::size_t to) const {
  const SignalTable& table = shown_.table();
  p.setPen(Qt::NoPen);
  p.setBrush(shown_.learnerColour(themeOf(*this)));
  for (const double share : {0.25, 0.75}) {
    const auto row = from + static_cast<std::size_t>(share * static_cast<double>(to - from));
    if (row + 1 >= table.rows() || row + 1 > to) continue;
    const QPointF a = at(row), b = at(row + 1), way = b - a;
    const double length = std::hypot(way.x(), way.y());
    if (length < 1 || std::isnan(length)) continue;
    const QPointF along = way / length, across(-along.y(), along.x()), tip = a + along * 6;
    p.drawPolygon(QPolygonF({tip, a - along * 5 + across * 4.5, a - along * 5 - across * 4.5}));
  }
  p.setBrush(Qt::NoBrush);
}

void PhasePortrait::drawLegend(QPainter& p, bool cycle) const {
  const Theme& t = themeOf(*this);
  p.setFont(textFont(kAxisText));
  double x = 12;
  const double y = height() - 14;
  const auto entry = [&](const QPen& pen, const QString& text) {
    const double wide = symbolWidth(p.font(), text);
    if (x + 26 + wide > width()) return;
    p.setPen(pen);
    p.drawLine(QPointF(x, y), QPointF(x + 18, y));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(x + 24, y - 8, wide + 4, 16), Qt::AlignLeft, text);
    x += 24 + wide + 18;
  };
  const QColor colour = shown_.learnerColour(t);
  if (cycle)
    entry(QPen(colour, 2.2), shown_.markedStride()      ? tr("the marked stride")
                             : shown_.strides().empty() ? tr("last cycle")
                                                        : tr("last stride"));
  QColor faint = colour;
  faint.setAlphaF(0.4f);
  entry(QPen(faint, 1.2), cycle ? tr("all that is shown") : shown_.names().first);
  if (shown_.second().rows() == 0) return;
  QPen dashed(t.ink, 1.1);
  dashed.setDashPattern({4, 3});
  entry(dashed, shown_.names().second);
}

QString PhasePortrait::axesText() const {
  if (shown_.table().signals().empty()) return tr("Signals");
  const auto [x, y] = shown_.axes();
  const auto& signals = shown_.table().signals();
  const auto name = [&](std::size_t at) {
    return fromCore(signals[at].symbol.empty() ? signals[at].title : signals[at].symbol);
  };
  return QStringLiteral("%1 × %2").arg(name(x), name(y));
}

void PhasePortrait::fillAxis(QMenu& menu, bool horizontal) {
  const auto& signals = shown_.table().signals();
  if (signals.empty()) return;
  const auto [x, y] = shown_.axes();
  for (std::size_t i = 0; i < signals.size(); ++i) {
    if (signals[i].kind == Signal::Kind::OnOff) continue;
    QAction* action = menu.addAction(fromCore(signals[i].title));
    action->setCheckable(true);
    action->setChecked(i == (horizontal ? x : y));
    connect(action, &QAction::triggered, this,
            [this, horizontal, key = signals[i].key, a = signals[x].key, b = signals[y].key] {
              horizontal ? shown_.setAxes(key, b) : shown_.setAxes(a, key);
            });
  }
}

void PhasePortrait::fillMenu(QMenu& menu) {
  fillAxis(*menu.addMenu(tr("Horizontal")), true);
  fillAxis(*menu.addMenu(tr("Vertical")), false);
}

std::string PhasePortrait::asCsv() const {
  const SignalTable& table = shown_.table();
  if (table.rows() == 0) return {};
  const auto [x, y] = shown_.axes();
  std::string csv = fmt::format("time,{},{}\n", table.signals()[x].key, table.signals()[y].key);
  const auto [from, to] = rowsShown(table);
  for (std::size_t row = from; row < to; ++row)
    csv += fmt::format("{},{},{}\n", table.columns()[0][row], table.columns()[x][row], table.columns()[y][row]);
  return csv;
}

}  // namespace surefoot

#include "moc_phase_portrait.cpp"
