// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/lives_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/lessons/verdict.h"
#include "core/text/text.h"
#include "ui/style/round_numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

QString shortText(double value) {
  return toText(lessonNumber(value));
}

}  // namespace

LivesView::LivesView(QStringList labels, QString unit, QWidget* parent)
    : Painted(parent),
      labels_(std::move(labels)),
      unit_(std::move(unit)) {
  setFocusPolicy(Qt::TabFocus);
  setAccessibleName(unit_);
}

void LivesView::show(std::vector<std::vector<double>> lives) {
  lives_ = std::move(lives);
  QStringList said;
  for (std::size_t w = 0; w < lives_.size(); ++w) {
    const Interval mean = meanWithInterval(lives_[w]);
    said << tr("%1: mean %2, 95 percent interval %3 to %4")
                .arg(labels_[static_cast<qsizetype>(w)], shortText(mean.value), shortText(mean.low),
                     shortText(mean.high));
  }
  setAccessibleDescription(said.join(QStringLiteral("; ")));
  update();
}

std::string LivesView::asCsv() const {
  std::string csv = "way,life,value\n";
  for (std::size_t w = 0; w < lives_.size(); ++w)
    for (std::size_t i = 0; i < lives_[w].size(); ++i)
      csv += fmt::format("{},{},{:.9g}\n", csvCell(labels_[static_cast<qsizetype>(w)].toStdString()), i, lives_[w][i]);
  return csv;
}

void LivesView::chooseScale() {
  double least = 0, most = 0;
  for (const auto& way : lives_)
    for (const double value : way) least = std::min(least, value), most = std::max(most, value);
  if (most == least) most = least + 1;
  step_ = niceAbove((most - least) / 5.0001);
  low_ = step_ * std::floor(least / step_ + 1e-9);
  high_ = step_ * std::ceil(most / step_ - 1e-9);
}

double LivesView::xOf(double value) const {
  return left_ + (value - low_) / (high_ - low_) * (right_ - left_);
}

void LivesView::paintWay(QPainter& p, std::size_t way, double top, double height) const {
  const Theme& t = themeOf(*this);
  const double y = std::round(top + height / 2) + 0.5;
  p.setFont(textFont(13));
  p.setPen(t.ink);
  const QString label = labels_[static_cast<qsizetype>(way)];
  drawSymbol(p, QRectF(12, y - 10, left_ - 24, 20), Qt::AlignLeft,
             QFontMetricsF(p.font()).elidedText(label, Qt::ElideRight, left_ - 24));
  p.setPen(QPen(t.hairline, 1));
  p.drawLine(QPointF(left_, y), QPointF(right_, y));
  if (way >= lives_.size()) return;
  QColor dot = t.ink;
  dot.setAlphaF(0.35f);
  p.setPen(Qt::NoPen);
  p.setBrush(dot);
  for (const double value : lives_[way]) p.drawEllipse(QPointF(xOf(value), y), 4, 4);
  const Interval mean = meanWithInterval(lives_[way]);
  const double above = y - std::min(14.0, height / 3);
  p.setPen(QPen(t.ink, 1.75));
  if (mean.known()) {
    const double from = std::clamp(xOf(mean.low), left_, right_), to = std::clamp(xOf(mean.high), left_, right_);
    p.drawLine(QPointF(from, above), QPointF(to, above));
    for (const double end : {from, to}) p.drawLine(QPointF(end, above - 4), QPointF(end, above + 4));
  }
  p.setBrush(t.ink);
  p.drawEllipse(QPointF(xOf(mean.value), above), 3.5, 3.5);
  p.setFont(textFont(13, 500));
  drawSymbol(p, QRectF(right_ + 12, y - 10, width() - right_ - 16, 20), Qt::AlignLeft, shortText(mean.value));
}

void LivesView::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.fillRect(rect(), t.panel);
  chooseScale();
  double widest = 60;
  for (const QString& label : labels_) widest = std::max(widest, symbolWidth(textFont(13), label));
  left_ = std::min(widest, 0.35 * width()) + 32;
  right_ = width() - 72;
  const double bottom = height() - 40, row = (bottom - 8) / static_cast<double>(labels_.size());
  for (std::size_t w = 0; w < static_cast<std::size_t>(labels_.size()); ++w)
    paintWay(p, w, 8 + row * static_cast<double>(w), row);
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  if (lives_.empty()) return p.drawText(rect(), Qt::AlignCenter, tr("They are being lived …"));
  for (double x = low_; x <= high_ + 1e-9; x += step_) {
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(xOf(x), bottom), QPointF(xOf(x), bottom + 4));
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(xOf(x) - 40, bottom + 5, 80, 14), Qt::AlignHCenter, shortText(x));
  }
  p.drawText(QRectF(12, bottom + 20, width() - 24, 16), Qt::AlignHCenter, tr("dark: mean and 95 % interval"));
}

}  // namespace surefoot

#include "moc_lives_view.cpp"
