// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/lives_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/lessons/verdict.h"
#include "core/text/text.h"
#include "ui/language/numbers.h"
#include "ui/style/round_numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

QString shortText(double value) {
  return localNumbers(lessonNumber(value));
}

}  // namespace

LivesView::LivesView(QStringList labels, QString unit, bool paired, QWidget* parent)
    : Painted(parent),
      labels_(std::move(labels)),
      unit_(std::move(unit)),
      paired_(paired) {
  setFocusPolicy(Qt::TabFocus);
  setAccessibleName(unit_);
}

void LivesView::showDifference(bool on) {
  if (std::exchange(isDifferenceShown_, on) != on) update();
}

std::optional<Interval> LivesView::difference() const {
  if (!isDifferenceShown_ || lives_.size() != 2) return std::nullopt;
  return compare(lives_[0], lives_[1]).difference;
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

/// Every dot and every interval is on it.
void LivesView::chooseScale() {
  double least = 0, most = 0;
  const auto include = [&](double value) { least = std::min(least, value), most = std::max(most, value); };
  for (const auto& way : lives_) {
    for (const double value : way) include(value);
    if (const Interval mean = meanWithInterval(way); mean.known()) include(mean.low), include(mean.high);
  }
  if (const auto d = difference(); d && d->known()) include(d->low), include(d->high);
  if (most == least) most = least + 1;
  step_ = niceAbove((most - least) / 5.0001);
  low_ = step_ * std::floor(least / step_ + 1e-9);
  high_ = step_ * std::ceil(most / step_ - 1e-9);
}

double LivesView::xOf(double value) const {
  return left_ + (value - low_) / (high_ - low_) * (right_ - left_);
}

double LivesView::lineOf(std::size_t way) const {
  return std::round(top_ + row_ * (static_cast<double>(way) + 0.5)) + 0.5;
}

/// Lives of one seed belong together: a line for each.
void LivesView::paintPairs(QPainter& p) const {
  if (!paired_ || lives_.size() != 2 || lives_[0].size() != lives_[1].size()) return;
  QColor line = themeOf(*this).ink;
  line.setAlphaF(0.34f);
  p.setPen(QPen(line, 1));
  for (std::size_t i = 0; i < lives_[0].size(); ++i)
    p.drawLine(QPointF(xOf(lives_[0][i]), lineOf(0)), QPointF(xOf(lives_[1][i]), lineOf(1)));
}

/// A dot for each life. Dots that would hide each other stand on each other.
void LivesView::paintDots(QPainter& p, std::size_t way) const {
  constexpr double kDot = 4;
  std::vector<double> values = lives_[way];
  std::sort(values.begin(), values.end());
  QColor dot = themeOf(*this).ink;
  dot.setAlphaF(0.45f);
  p.setPen(Qt::NoPen);
  p.setBrush(dot);
  const double apart = std::min(2 * kDot, 0.45 * row_ / static_cast<double>(values.size()));
  double column = -1e9, height = 0;
  for (const double value : values) {
    const double x = xOf(value);
    height = x - column < 1.5 * kDot ? height + std::max(apart, 2.0) : 0;
    if (height == 0) column = x;
    p.drawEllipse(QPointF(x, lineOf(way) + std::min(height, 0.45 * row_)), kDot, kDot);
  }
}

void LivesView::paintMean(QPainter& p, std::size_t way) const {
  paintInterval(p, meanWithInterval(lives_[way]), lineOf(way) - std::min(14.0, row_ / 3));
}

void LivesView::paintTexts(QPainter& p, std::size_t way) const {
  const Theme& t = themeOf(*this);
  const double y = lineOf(way);
  // Rows that are nearer to each other than their letters get smaller letters.
  const int pixels = static_cast<int>(std::clamp(row_ - 2, 8.0, 13.0));
  p.setFont(textFont(pixels));
  p.setPen(t.ink);
  const QString label =
      QFontMetricsF(p.font()).elidedText(labels_[static_cast<qsizetype>(way)], Qt::ElideRight, left_ - 24);
  drawSymbol(p, QRectF(12, y - 10, left_ - 24, 20), Qt::AlignLeft, label);
  p.setPen(QPen(t.hairline, 1));
  p.drawLine(QPointF(left_, y), QPointF(right_, y));
  if (way >= lives_.size()) return;
  p.setFont(textFont(pixels, 500));
  p.setPen(t.ink);
  drawSymbol(p, QRectF(right_ + 12, y - 10, width() - right_ - 16, 20), Qt::AlignLeft,
             shortText(meanWithInterval(lives_[way]).value));
}

/// How far the means lie apart, with the interval that decides: does it hold 0?
void LivesView::paintDifference(QPainter& p) const {
  const Theme& t = themeOf(*this);
  const Interval d = *difference();
  const double y = lineOf(lives_.size()), zero = xOf(0);
  p.setFont(textFont(13));
  p.setPen(t.ink);
  drawSymbol(p, QRectF(12, y - 10, left_ - 24, 20), Qt::AlignLeft, tr("difference"));
  drawSymbol(p, QRectF(right_ + 12, y - 10, width() - right_ - 16, 20), Qt::AlignLeft, shortText(d.value));
  p.setPen(QPen(t.hairline, 1));
  p.drawLine(QPointF(left_, y), QPointF(right_, y));
  p.setPen(QPen(t.ink, 1, Qt::DashLine));
  p.drawLine(QPointF(zero, y - row_ / 2), QPointF(zero, y + row_ / 2));
  paintInterval(p, d, y);
}

void LivesView::paintInterval(QPainter& p, const Interval& interval, double y) const {
  const Theme& t = themeOf(*this);
  p.setPen(QPen(t.ink, 1.75));
  if (interval.known()) {
    p.drawLine(QPointF(xOf(interval.low), y), QPointF(xOf(interval.high), y));
    for (const double end : {interval.low, interval.high})
      p.drawLine(QPointF(xOf(end), y - 4), QPointF(xOf(end), y + 4));
  }
  p.setBrush(t.ink);
  p.drawEllipse(QPointF(xOf(interval.value), y), 3.5, 3.5);
}

void LivesView::paintAxis(QPainter& p, double bottom) const {
  const Theme& t = themeOf(*this);
  p.setFont(textFont(11));
  double free = left_ - 1e9;  // numbers that would touch are left out
  for (double x = low_; x <= high_ + 1e-9 * step_; x += step_) {
    p.setPen(QPen(t.outline, 1));
    p.drawLine(QPointF(xOf(x), bottom), QPointF(xOf(x), bottom + 4));
    const QString text = shortText(x);
    const double half = symbolWidth(p.font(), text) / 2;
    if (xOf(x) - half < free) continue;
    free = xOf(x) + half + 8;
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(xOf(x) - 40, bottom + 5, 80, 14), Qt::AlignHCenter, text);
  }
  p.setPen(t.quiet);
  const QRectF below(12, bottom + 20, width() - 24, 16);
  p.drawText(below, Qt::AlignHCenter, QFontMetricsF(p.font()).elidedText(unit_, Qt::ElideRight, below.width()));
  if (row_ < 24) return;
  const bool pairs = paired_ && lives_.size() == 2;
  const QString line = pairs ? tr("a line: one seed; ") : QString();
  for (const QString& key : {tr("a dot: one life; %1bar: 95 % interval of the mean").arg(line),
                             tr("%1bar: 95 % interval").arg(line), tr("bar: 95 % interval")})
    if (symbolWidth(p.font(), key) <= right_ - left_) {
      p.drawText(QRectF(left_, 4, right_ - left_, 16), Qt::AlignLeft, key);
      break;
    }
  p.drawText(QRectF(right_ + 12, 4, width() - right_ - 16, 16), Qt::AlignLeft, tr("mean"));
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
  const double bottom = height() - 40;
  const auto ways = static_cast<double>(labels_.size() + (difference() ? 1 : 0));
  top_ = (bottom - 20) / ways < 24 ? 8 : 20;
  row_ = (bottom - top_) / ways;
  if (!lives_.empty()) paintPairs(p);
  for (std::size_t w = 0; w < static_cast<std::size_t>(labels_.size()); ++w) paintTexts(p, w);
  for (std::size_t w = 0; w < lives_.size(); ++w) paintDots(p, w), paintMean(p, w);
  if (difference()) paintDifference(p);
  if (!lives_.empty()) return paintAxis(p, bottom);
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  p.drawText(QRectF(0, bottom, width(), 40), Qt::AlignCenter, tr("They are being lived …"));
}

}  // namespace surefoot

#include "moc_lives_view.cpp"
