// SPDX-License-Identifier: GPL-3.0-or-later
// How the world is measured and drawn.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/text/text.h"
#include "ui/controls/preferences.h"
#include "ui/live/world/world_view.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/running/task_words.h"
#include "ui/style/policy_look.h"
#include "ui/style/round_numbers.h"
#include "ui/style/scene_painter.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/keyboard.h"

namespace surefoot {

namespace {

// [px], with texts of the usual size
constexpr double kScale = 46;          // from the floor down: metre scale, and which leg stands
constexpr double kNoScale = 20;        // … with neither of them
constexpr double kReadOut = 22;        // height of a row of read-outs
constexpr double kUnderReadOuts = 20;  // from the last one's baseline to the bottom edge
constexpr double kHeadroom = 28;       // above the highest thing drawn
constexpr double kCaption = 26;        // with two worlds: the caption with this world's policy and agent
constexpr double kSide = 24;           // beside the widest scene
constexpr double kMostAround = 0.45;   // of the height, for all that is around a plain scene
constexpr double kEdge = 12;           // around it where there is less room
constexpr double kMostScale = 1700;    // [px/m]
constexpr double kGap = 6;             // between symbol, value and unit [px]

/// Room for the value, wide enough that it does not move while its digits change.
double valueWidth(const ReadOut& r) {
  const QString widest = r.decimals > 0 ? QStringLiteral("−00.") + QString(r.decimals, '0') : QStringLiteral("−000");
  return std::max(symbolWidth(textFont(13, 500), widest),
                  symbolWidth(textFont(13, 500), toText(fixedText(r.value, r.decimals))));
}

/// The distance from the left end of a read-out to the right edge of its number.
double numberEdge(const ReadOut& r) {
  return symbolWidth(textFont(13), toText(r.symbol)) + kGap + valueWidth(r);
}

double readOutWidth(const ReadOut& r) {
  return numberEdge(r) + 4 + symbolWidth(textFont(11), toText(r.unit));
}

}  // namespace

/// Finds how many read-outs with units fit in a row, and the scale at which all is visible, also the words.
void WorldView::measure() {
  if (plain_)
    readOuts_.clear();
  else
    readOuts_ = life_.environment().readOuts(looking_.shown().pose);
  const double k = textScale();
  double widest = 1;
  for (const ReadOut& r : readOuts_) widest = std::max(widest, readOutWidth(r) + 12);
  const auto n = static_cast<int>(readOuts_.size());
  ownColumns_ = std::clamp(static_cast<int>((width() - 12) / widest), 1, std::max(1, n));
  const bool both = beside_ && beside_->isVisible() && beside_->fit_ > 0;
  const int most = both ? std::min(ownColumns_, beside_->ownColumns_) : ownColumns_, rows = (n + most - 1) / most;
  columns_ = rows > 0 ? (n + rows - 1) / rows : 1;
  readOutsHeight_ = k * (kReadOut * rows + kUnderReadOuts);
  const double around = readOutsHeight_ + captionHeight() + k * ((scene_.metres ? kScale : kNoScale) + kHeadroom);
  const bool tight = plain_ && around > kMostAround * height();  // the body is what one looks at: no numbers
  if (tight) readOutsHeight_ = 0;
  hasNumbers_ = scene_.metres && !tight;
  const double above = captionHeight() + (tight ? kEdge : k * kHeadroom);
  band_ = readOutsHeight_ + (tight ? kEdge : k * (scene_.metres ? kScale : kNoScale));

  fit_ = std::min(kMostScale, (height() - band_ - above) / scene_.height);
  if (scene_.width > 0) fit_ = std::min(fit_, (width() - 2 * kSide) / scene_.width);
  const double least = 0.5 * fit_;  // below this scale, words move in from the edge instead
  for (const Shape& shape : scene_.shapes) {
    const auto* label = std::get_if<Label>(&shape);
    if (!label || label->align == 0 || label->halo) continue;
    const double words = symbolWidth(ScenePainter::fontOf(*label), toText(label->text)) + k * std::abs(label->dx) + 4;
    if (const double reach = std::abs(label->at.x - scene_.focus.x); reach > 0)
      fit_ = std::min(fit_, (width() / 2.0 - words) / reach);
  }
  fit_ = std::max({fit_, least, 1.0});
  if (!scene_.metres) band_ += std::max(0.0, (height() - band_ - above - fit_ * scene_.height) / 2);
}

double WorldView::captionHeight() const {
  return beside_ && beside_->isVisible() ? kCaption * textScale() : 0;
}

void WorldView::drawSpring(QPainter& p, const Theme& t) const {
  if (!hand_) return;
  p.setPen(QPen(t.accent, 1.5, Qt::DashLine));
  p.drawLine(toPixel(scene_.tip), *hand_);
  p.setBrush(t.accent);
  p.setPen(Qt::NoPen);
  p.drawEllipse(*hand_, 4, 4);
}

// The body as it would stand in the state under the cursor on a map.
void WorldView::drawGhost(QPainter& p, const Theme& t) const {
  const std::vector<double>& state = looking_.examined();
  if (state.size() != life_.task().state.size()) return;
  const auto pose = life_.environment().poseAt(state);
  if (pose.empty()) return;
  Scene ghost;
  life_.environment().draw(pose, ghost);
  p.setOpacity(0.28);
  const double dx = scene_.focus.x - ghost.focus.x;  // the ghost stands where the body stands
  ScenePainter painter(
      p, t, false,
      [&](Point at) {
        return toPixel({at.x + dx, at.y});
      },
      pixelsPerMetre());
  painter.setStrokes(strokes());
  for (const Shape& shape : ghost.shapes)
    if (!std::holds_alternative<Label>(shape)) std::visit(painter, shape);
  p.setOpacity(1.0);
}

void WorldView::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.fillRect(rect(), t.paper);
  if (scene_.shapes.empty()) return;
  measure();
  p.setRenderHint(QPainter::Antialiasing);
  p.save();  // at any zoom, the read-outs stay free
  p.setClipRect(QRectF(0, captionHeight(), width(), height() - readOutsHeight_ - captionHeight()));
  drawPicture(p, t);
  p.restore();
  drawReadOuts(p, t);
  drawCaption(p, t);
  if (plain_ && looking_.playback()) drawChoice(p, t);
  if (ring_) drawFocusRing(p, *this);
}

void WorldView::drawPicture(QPainter& p, const Theme& t) const {
  if (scene_.metres) drawFloor(p, t);
  if (!reducedMotion()) drawTrail(p, t);
  drawGhost(p, t);
  const double scale = pixelsPerMetre();
  ScenePainter painter(
      p, t, looking_.shown().flash && !reducedMotion(), [this](Point at) { return toPixel(at); }, scale);
  painter.setBounds(QRectF(rect()).adjusted(3, 2 + captionHeight(), -3, -2));
  painter.setStrokes(strokes());
  paintScene(scene_, painter);
  drawSpring(p, t);
}

void WorldView::drawFloor(QPainter& p, const Theme& t) const {
  const double y = floorLevel(), scale = pixelsPerMetre(), k = textScale();
  p.setPen(QPen(t.ink, 1.25));
  p.drawLine(QPointF(0, y), QPointF(width(), y));
  p.setFont(textFont(11));
  // Numbers at 1, 2 or 5 times a power of ten, as near to each other as can be read; ten (or five) ticks between two.
  const double step = niceAbove((symbolWidth(p.font(), QStringLiteral("−0.00 m")) + 8) / scale);
  const int parts = step / 10 * scale >= 4 ? 10 : step / 5 * scale >= 4 ? 5 : 1;
  const double left = camera_ - (width() / 2.0 + pan_.x()) / scale, right = left + width() / scale;
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  const auto first = static_cast<std::int64_t>(std::ceil(left / step * parts));
  const double edge = symbolWidth(p.font(), toText(fixedText(0, decimals)) + QStringLiteral(" m")) / 2 + 4;
  const bool zero = left + edge / scale <= 0 && right - edge / scale >= 0;
  const double middle = zero ? 0.0 : std::round((left + right) / 2 / step);  // bears the unit
  for (auto i = first; static_cast<double>(i) * step / parts <= right; ++i) {
    const double x = toPixel({static_cast<double>(i) * step / parts, 0}).x();
    const bool number = i % parts == 0;
    p.setPen(QPen(number ? t.ink : t.outline, 1));
    p.drawLine(QPointF(x, y), QPointF(x, y + k * (number ? 9 : i % 5 == 0 ? 6 : 4)));
    if (!number || !hasNumbers_) continue;
    const double value = static_cast<double>(i / parts);  // in steps
    QString text = toText(fixedText(value * step, decimals));
    if (value == middle) text += QStringLiteral(" m");
    const double half = symbolWidth(p.font(), text) / 2;
    if (x - half < 4 || x + half > width() - 4) continue;
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(x - half, y + k * 10, 2 * half, k * 16), Qt::AlignHCenter, text);
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

/// With two worlds, the caption says which one this is, and shows its policy and agent.
void WorldView::drawCaption(QPainter& p, const Theme& t) const {
  if (captionHeight() == 0) return;
  const double k = textScale(), baseline = 18 * k;
  const Names& names = life_.configuration().names;
  const auto& registry = life_.registry();
  const auto title = [](const auto& entry, const std::string& name) { return toText(entry ? (*entry)->title : name); };
  p.setFont(textFont(13, 500));
  p.setPen(t.ink);
  double x = 12;
  drawSymbol(p, x, baseline, which_);
  x += symbolWidth(p.font(), which_) + 14 * k;
  drawMarker(p, {x, baseline - 4.5 * k}, policyLook(names.policy, t), true);
  p.setFont(textFont(13));
  drawSymbol(p, x + 9 * k, baseline,
             title(findEntry(registry.policies, "policy", names.policy), names.policy) + QStringLiteral(", ") +
                 title(findEntry(registry.agents, "agent", names.agent), names.agent));
}

/// In a replay: whether the action that is carried out now was the best by what the robot knew then.
void WorldView::drawChoice(QPainter& p, const Theme& t) const {
  const Shown* chosen = looking_.whenChosen();
  const Task& task = life_.task();
  if (!chosen || !chosen->explores || chosen->action < 0) return;
  const auto action = static_cast<std::size_t>(chosen->action);
  if (action >= task.actions.size()) return;
  QString words = *chosen->explores ? tr("taken at random") : tr("taken as the best");
  // A combination of several is too long to be read here; its parts are drawn at the joints.
  const bool isNumber = task.actionVariables.empty() && task.actionNames.empty();
  if (task.actionVariables.empty()) words += QStringLiteral(": ") + actionNameOf(task, action);
  if (isNumber) words += ' ' + toText(task.actionUnit);
  p.setFont(textFont(13, 500));
  p.setPen(*chosen->explores ? t.fallText : t.ink);
  drawSymbol(p, 12, height() - 12, words);
}

void WorldView::drawReadOuts(QPainter& p, const Theme& t) const {
  const double k = textScale(), column = (width() - 24.0) / std::max(1, columns_);
  const auto n = static_cast<int>(readOuts_.size());
  for (int i = 0; i < n; ++i) {
    const ReadOut& r = readOuts_[static_cast<std::size_t>(i)];
    const double x = 12 + column * (i % columns_);
    const double y = height() - k * (kUnderReadOuts + kReadOut * ((n - 1) / columns_ - i / columns_));
    p.setFont(textFont(13));
    p.setPen(t.quiet);
    drawSymbol(p, x, y, toText(r.symbol));
    double edge = 0, most = column;  // numbers in one column share their right edge
    for (int j = i % columns_; j < n; j += columns_) {
      const ReadOut& other = readOuts_[static_cast<std::size_t>(j)];
      edge = std::max(edge, numberEdge(other));
      most = std::min(most, column - (readOutWidth(other) - numberEdge(other)) - 16);
    }
    const double right = x + std::max(numberEdge(r), std::min(edge, most));
    p.setFont(textFont(13, 500));
    p.setPen(t.ink);
    const QString value = toText(fixedText(r.value, r.decimals));
    drawSymbol(p, right - symbolWidth(p.font(), value), y, value);
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    drawSymbol(p, right + 4, y, toText(r.unit));
  }
}

}  // namespace surefoot
