// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/world/world_picture.h"

#include <algorithm>
#include <cmath>

#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/style/round_numbers.h"
#include "ui/style/scene_painter.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

// [px], with texts of the usual size
constexpr double kScale = 46;          // from the floor down: metre scale, and which leg stands
constexpr double kNoScale = 20;        // … with neither of them
constexpr double kReadOut = 22;        // height of a row of read-outs
constexpr double kUnderReadOuts = 20;  // from the last one's baseline to the bottom edge
constexpr double kHeadroom = 28;       // above the highest thing drawn
constexpr double kSide = 24;           // beside the widest scene
constexpr double kMostAround = 0.45;   // of the height, for all that is around a plain scene
constexpr double kEdge = 12;           // around it where there is less room
constexpr double kMostScale = 1700;    // [px/m]
constexpr double kGap = 6;             // between symbol, value and unit [px]

/// Room for the value, wide enough that it does not move while its digits change.
double valueWidth(const ReadOut& r) {
  const QString widest = r.decimals > 0 ? QStringLiteral("−00.") + QString(r.decimals, '0') : QStringLiteral("−000");
  return std::max(symbolWidth(textFont(13, 500), widest),
                  symbolWidth(textFont(13, 500), fixedNumber(r.value, r.decimals)));
}

/// The distance from the left end of a read-out to the right edge of its number.
double numberEdge(const ReadOut& r) {
  return symbolWidth(textFont(13), fromCore(r.symbol)) + kGap + valueWidth(r);
}

double readOutWidth(const ReadOut& r) {
  return numberEdge(r) + 4 + symbolWidth(textFont(11), toText(r.unit));
}

}  // namespace

void WorldPicture::follow(Point tip, std::size_t most, double jump) {
  mostTrail_ = most;
  if (!trail_.empty() && std::hypot(trail_.back().x - tip.x, trail_.back().y - tip.y) > jump) trail_.clear();
  trail_.push_back(tip);
  if (trail_.size() > most) trail_.pop_front();
}

void WorldPicture::measure(QSize size, double caption, WorldPicture* beside) {
  size_ = size;
  caption_ = caption;
  const double k = textScale();
  double widest = 1;
  for (const ReadOut& r : readOuts) widest = std::max(widest, readOutWidth(r) + 12);
  const auto n = static_cast<int>(readOuts.size());
  ownColumns_ = std::clamp(static_cast<int>((size.width() - 12) / widest), 1, std::max(1, n));
  const int most = beside ? std::min(ownColumns_, beside->ownColumns_) : ownColumns_, rows = (n + most - 1) / most;
  columns_ = rows > 0 ? (n + rows - 1) / rows : 1;
  readOutsHeight_ = k * (kReadOut * rows + kUnderReadOuts);
  const double around = readOutsHeight_ + caption + k * ((scene.metres ? kScale : kNoScale) + kHeadroom);
  const bool tight = plain && around > kMostAround * size.height();  // the body is what one looks at: no numbers
  if (tight) readOutsHeight_ = 0;
  hasNumbers_ = scene.metres && !tight;
  const double above = caption + (tight ? kEdge : k * kHeadroom);
  band_ = readOutsHeight_ + (tight ? kEdge : k * (scene.metres ? kScale : kNoScale));

  fit_ = std::min(kMostScale, (size.height() - band_ - above) / scene.height);
  if (scene.width > 0) fit_ = std::min(fit_, (size.width() - 2 * kSide) / scene.width);
  const double least = 0.5 * fit_;  // below this scale, words move in from the edge instead
  for (const Shape& shape : scene.shapes) {
    const auto* label = std::get_if<Label>(&shape);
    if (!label || label->align == 0 || label->halo) continue;
    const double words =
        symbolWidth(ScenePainter::fontOf(*label), localNumbers(fromCore(label->text))) + k * std::abs(label->dx) + 4;
    if (const double reach = std::abs(label->at.x - scene.focus.x); reach > 0)
      fit_ = std::min(fit_, (size.width() / 2.0 - words) / reach);
  }
  fit_ = std::max({fit_, least, 1.0});
  if (!scene.metres) band_ += std::max(0.0, (size.height() - band_ - above - fit_ * scene.height) / 2);
  scale_ = fit_;
  if (beside) scale_ = beside->scale_ = std::min(fit_, beside->fit_);
}

double WorldPicture::strokes() const {
  constexpr double kUsual = 240;  // height of the drawn scene [px]
  return textScale() * std::clamp(scale_ * scene.height / kUsual, 0.4, 1.0);
}

Point WorldPicture::toMetres(QPointF at) const {
  const double scale = pixelsPerMetre();
  return {camera + (at.x() - pan.x() - size_.width() / 2.0) / scale, (floorLevel() - at.y()) / scale};
}

QPointF WorldPicture::toPixel(Point p) const {
  const double scale = pixelsPerMetre();
  return {size_.width() / 2.0 + pan.x() + (p.x - camera) * scale, floorLevel() - p.y * scale};
}

QRectF WorldPicture::room() const {
  return {0, caption_, double(size_.width()), size_.height() - readOutsHeight_ - caption_};
}

void WorldPicture::paint(QPainter& p, const Theme& t, bool flash) const {
  p.fillRect(QRect({0, 0}, size_), t.paper);
  p.setRenderHint(QPainter::Antialiasing);
  p.save();  // at any zoom, the read-outs stay free
  p.setClipRect(room());
  paintGround(p, t, true);
  paintBody(p, t, flash);
  p.restore();
  paintReadOuts(p, t);
}

void WorldPicture::paintGround(QPainter& p, const Theme& t, bool trail) const {
  if (scene.metres) paintFloor(p, t);
  if (trail) paintTrail(p, t);
}

void WorldPicture::paintBody(QPainter& p, const Theme& t, bool flash) const {
  ScenePainter painter(
      p, t, flash, [this](Point at) { return toPixel(at); }, pixelsPerMetre());
  painter.setBounds(QRectF({0, 0}, QSizeF(size_)).adjusted(3, 2 + caption_, -3, -2));
  painter.setStrokes(strokes());
  paintScene(scene, painter);
}

void WorldPicture::paintFloor(QPainter& p, const Theme& t) const {
  const double y = floorLevel(), scale = pixelsPerMetre(), k = textScale();
  p.setPen(QPen(t.ink, 1.25));
  p.drawLine(QPointF(0, y), QPointF(size_.width(), y));
  p.setFont(textFont(11));
  // Numbers at 1, 2 or 5 times a power of ten, as near to each other as can be read; ten (or five) ticks between two.
  const double step = niceAbove((symbolWidth(p.font(), QStringLiteral("−0.00 m")) + 8) / scale);
  const int parts = step / 10 * scale >= 4 ? 10 : step / 5 * scale >= 4 ? 5 : 1;
  const double left = camera - (size_.width() / 2.0 + pan.x()) / scale, right = left + size_.width() / scale;
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  const auto first = static_cast<std::int64_t>(std::ceil(left / step * parts));
  const double edge = symbolWidth(p.font(), fixedNumber(0, decimals) + QStringLiteral(" m")) / 2 + 4;
  const bool zero = left + edge / scale <= 0 && right - edge / scale >= 0;
  const double middle = zero ? 0.0 : std::round((left + right) / 2 / step);  // bears the unit
  for (auto i = first; static_cast<double>(i) * step / parts <= right; ++i) {
    const double x = toPixel({static_cast<double>(i) * step / parts, 0}).x();
    const bool number = i % parts == 0;
    p.setPen(QPen(number ? t.ink : t.outline, 1));
    p.drawLine(QPointF(x, y), QPointF(x, y + k * (number ? 9 : i % 5 == 0 ? 6 : 4)));
    if (!number || !hasNumbers_) continue;
    const double value = static_cast<double>(i / parts);  // in steps
    QString text = fixedNumber(value * step, decimals);
    if (value == middle) text += QStringLiteral(" m");
    const double half = symbolWidth(p.font(), text) / 2;
    if (x - half < 4 || x + half > size_.width() - 4) continue;
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(x - half, y + k * 10, 2 * half, k * 16), Qt::AlignHCenter, text);
  }
}

void WorldPicture::paintTrail(QPainter& p, const Theme& t) const {
  for (std::size_t i = 1; i < trail_.size(); ++i) {
    QColor colour = t.quiet;
    colour.setAlphaF(static_cast<float>(0.5 * static_cast<double>(i) / static_cast<double>(mostTrail_)));
    p.setPen(QPen(colour, 1.25));
    p.drawLine(toPixel(trail_[i - 1]), toPixel(trail_[i]));
  }
}

void WorldPicture::paintReadOuts(QPainter& p, const Theme& t) const {
  const double k = textScale(), column = (size_.width() - 24.0) / std::max(1, columns_);
  const auto n = static_cast<int>(readOuts.size());
  for (int i = 0; i < n; ++i) {
    const ReadOut& r = readOuts[static_cast<std::size_t>(i)];
    const double x = 12 + column * (i % columns_);
    const double y = size_.height() - k * (kUnderReadOuts + kReadOut * ((n - 1) / columns_ - i / columns_));
    p.setFont(textFont(13));
    p.setPen(t.quiet);
    drawSymbol(p, x, y, fromCore(r.symbol));
    double edge = 0, most = column;  // numbers in one column share their right edge
    for (int j = i % columns_; j < n; j += columns_) {
      const ReadOut& other = readOuts[static_cast<std::size_t>(j)];
      edge = std::max(edge, numberEdge(other));
      most = std::min(most, column - (readOutWidth(other) - numberEdge(other)) - 16);
    }
    const double right = x + std::max(numberEdge(r), std::min(edge, most));
    p.setFont(textFont(13, 500));
    p.setPen(t.ink);
    const QString value = fixedNumber(r.value, r.decimals);
    drawSymbol(p, right - symbolWidth(p.font(), value), y, value);
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    drawSymbol(p, right + 4, y, toText(r.unit));
  }
}

}  // namespace surefoot
