// SPDX-License-Identifier: GPL-3.0-or-later
// How the rows of ActionRows are drawn where an action is one number.
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/text/text.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/live/actions/action_rows.h"
#include "ui/live/maps/map_choice.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/session/editing.h"
#include "ui/style/colour_map.h"
#include "ui/style/policy_look.h"
#include "ui/style/round_numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr double kBar = 12;  // [px], with texts of the usual size

double widthOf(const QString& text, int pixels, int weight = 400) {
  return symbolWidth(textFont(pixels, weight), text);
}

QString percentText(double chance) {
  const double percent = 100 * chance;
  return fixedNumber(percent, percent >= 0.005 && percent < 0.095 ? 2 : 1);
}

QString headOf(const Task& task) {
  const QString unit = toText(task.actionUnit), title = fromCore(task.actionTitle);
  return unit.isEmpty() ? title : QStringLiteral("%1, %2").arg(title, unit);
}

/// Numbers below a scale, as many as fit without touching.
class ScaleNumbers {
 public:
  ScaleNumbers(QPainter& p, double y, double apart) : p_(p), y_(y), apart_(apart) {}
  void draw(double x, const QString& text) {
    const double half = symbolWidth(p_.font(), text) / 2;
    if (x - half < last_ + apart_ || (zero_ && x + half > *zero_ - apart_ && x < *zero_)) return;
    last_ = x + half;
    const double height = QFontMetricsF(p_.font()).height();
    drawSymbol(p_, QRectF(x - half, y_ + 4, 2 * half, height), Qt::AlignHCenter, text);
  }
  /// Keeps the place of the number 0 free.
  void keepZero(double x) { zero_ = x - symbolWidth(p_.font(), QStringLiteral("0")) / 2; }
  /// No number from here on to the right.
  double last() const { return last_; }

 private:
  QPainter& p_;
  double y_, apart_, last_ = -1e9;
  std::optional<double> zero_;
};

}  // namespace

/// The font of a row, smaller if rows are low.
QFont ActionRows::rowFont(double row, int weight) const {
  QFont font = textFont(13, weight);
  font.setPixelSize(std::clamp(static_cast<int>(0.82 * row), 6, font.pixelSize()));
  return font;
}

ActionRows::Geometry ActionRows::geometry() const {
  const Task& task = life_.task();
  const double k = textScale(), w = width(), risk = risk_.empty() ? 0 : 136;
  Geometry g{};
  double names = 0, titles = 0;
  for (std::size_t a = 0; a < task.actions.size(); ++a)
    names = std::max(names, widthOf(actionNameOf(task, a), 13, 500));
  for (const Column& c : columns_) titles = std::max(titles, 15 * k + widthOf(c.title, 13, 500) + 5 * k);
  g.label = std::max(59 * k, 12 + names);
  g.qLeft = g.label + 17 * k;
  const double percent = widthOf(QStringLiteral("100.0"), 13, 500), q = std::max(numberWidth_, 30.0) * k;
  double column = std::max(titles, percent + 40 * k), qLeast = g.qLeft + (60 + 10 + 22 + risk) * k + q;
  for (std::size_t i = 0; i < columns_.size(); ++i) g.columns.push_back(i);
  if (qLeast + column * static_cast<double>(g.columns.size()) > w)  // shorter bars before a policy goes
    column = std::max(titles, percent + 28 * k), qLeast -= 20 * k;
  while (g.columns.size() > 1 && qLeast + column * static_cast<double>(g.columns.size()) > w) {
    const auto last = std::find_if(g.columns.rbegin(), g.columns.rend(), [this](std::size_t i) { return !inForce(i); });
    g.columns.erase(std::next(last).base());
  }
  const auto n = static_cast<double>(g.columns.size());
  g.first = std::round(std::max(qLeast, std::min((n > 3 ? 0.36 : 0.428) * w + risk * k, w - n * column)));
  g.qNumber = g.first - (22 + risk) * k;
  if (risk > 0) g.riskLeft = g.qNumber + 24 * k, g.riskRight = g.riskLeft + 72 * k, g.riskNumber = g.riskRight + 40 * k;
  g.qRight = g.qNumber - q - 10 * k;
  g.pitch = (w - g.first) / n;
  g.number = g.pitch - (risk > 0 ? 8 : 16) * k;  // with one column more they stand closer
  g.bar = std::max(8.0, g.number - percent - (risk > 0 ? 4 : 8) * k);
  g.below = titles + widthOf(tr("in force"), 11) + 6 * k > g.pitch;
  const double rows = std::max<double>(1, static_cast<double>(task.actions.size()));
  g.top = k * (g.below ? 44 : 32);
  g.row = std::clamp((height() - g.top - k * foot()) / rows, 8.0, 32.0 * k);
  g.bottom = g.top + rows * g.row;
  return g;
}

std::pair<double, double> ActionRows::scaleAndNumbers() const {
  const Geometry g = geometry();
  double widest = 0;
  for (const double q : q_) widest = std::max(widest, symbolWidth(rowFont(g.row, 500), valueText(q)));
  return {g.qRight, g.qNumber - widest};
}

double ActionRows::xOf(double value, const Geometry& g) const {
  return g.qLeft + (g.qRight - g.qLeft) * (std::clamp(value, low_, high_) - low_) / (high_ - low_);
}

void ActionRows::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.fillRect(rect(), t.panel);
  p.setRenderHint(QPainter::Antialiasing);
  if (!life_.task().actionVariables.empty()) return levels_.empty() ? void() : drawLevels(p, t);
  const Geometry g = geometry();
  drawHead(p, t, g);
  if (q_.empty()) return;
  if (chosen_ != kNoAction) {
    const double highlight = g.top + (static_cast<double>(q_.size()) - 1 - chosen_) * g.row;
    p.setPen(Qt::NoPen);
    p.setBrush(t.fill);
    p.drawRoundedRect(QRectF(4, highlight + 2, width() - 8, g.row - 4), 4, 4);
  }
  drawScales(p, t, g);
  for (std::size_t a = 0; a < q_.size(); ++a) drawBars(p, t, g, a);
  drawThreshold(p, t, g);
  for (std::size_t a = 0; a < q_.size(); ++a) drawNumbers(p, t, g, a);
  if (!risk_.empty()) drawRisk(p, t, g);
}

void ActionRows::drawHead(QPainter& p, const Theme& t, const Geometry& g) const {
  const double k = textScale(), baseline = 20 * k;
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  drawSymbol(p, 12, baseline, headOf(life_.task()));
  p.setFont(textFont(13, 500));
  p.setPen(t.ink);
  drawSymbol(p, g.qNumber - symbolWidth(p.font(), QStringLiteral("Q")), baseline, QStringLiteral("Q"));
  for (std::size_t i = 0; i < g.columns.size(); ++i) {
    const Column& column = columns_[g.columns[i]];
    const bool now = inForce(g.columns[i]);
    const double x = g.first + g.pitch * static_cast<double>(i), left = x + 15 * k;
    drawMarker(p, {x + 4 * k, baseline - 4.5 * k}, policyLook(column.name, t), now);
    p.setFont(textFont(13, now ? 500 : 400));
    p.setPen(t.ink);
    drawSymbol(p, left, baseline, column.title);
    if (!now) continue;
    const double end = left + symbolWidth(p.font(), column.title) + 5 * k;
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    g.below ? drawSymbol(p, left, baseline + 14 * k, tr("in force")) : drawSymbol(p, end, baseline, tr("in force"));
  }
}

void ActionRows::drawScales(QPainter& p, const Theme& t, const Geometry& g) const {
  p.setFont(textFont(11));
  const double step = niceAbove((high_ - low_) / 4.0001), height = QFontMetricsF(p.font()).height();
  ScaleNumbers numbers(p, g.bottom, 8);
  numbers.keepZero(std::round(xOf(0, g)) + 0.5);
  for (int i = static_cast<int>(std::ceil(low_ / step)); i * step <= high_; ++i) {
    const double v = i * step;
    const double x = std::round(xOf(v, g)) + 0.5;
    p.setPen(QPen(v == 0 ? t.outline : t.hairline, 1));
    p.drawLine(QPointF(x, g.top), QPointF(x, g.bottom));
    p.setPen(t.quiet);
    numbers.draw(x, localNumbers(step < 1 ? fixedText(v, step < 0.1 ? 2 : 1) : countText(v)));
  }
  for (std::size_t i = 0; i < g.columns.size(); ++i) {
    const double x0 = g.first + g.pitch * static_cast<double>(i);
    ScaleNumbers percents(p, g.bottom, 4);
    for (const int percent : {0, 1, 10, 100}) {  // square-root axis: policies differ in the few per cent of exploring
      const double x = std::round(x0 + g.bar * std::sqrt(percent / 100.0)) + 0.5;
      p.setPen(QPen(percent == 0 ? t.outline : t.hairline, 1));
      p.drawLine(QPointF(x, g.top), QPointF(x, g.bottom));
      p.setPen(t.quiet);
      percents.draw(x, localNumbers(QString::number(percent)));
    }
    const QRectF unit(x0 + g.number - 20, g.bottom + 4, 20, height);
    if (percents.last() + 2 < unit.right() - symbolWidth(p.font(), QStringLiteral("%")))
      drawSymbol(p, unit, Qt::AlignRight, QStringLiteral("%"));
  }
}

void ActionRows::drawBars(QPainter& p, const Theme& t, const Geometry& g, std::size_t action) const {
  const double middle = g.top + (static_cast<double>(q_.size() - action) - 0.5) * g.row;
  const double bar = std::min(kBar * textScale(), 0.6 * g.row), zero = xOf(0, g), x = xOf(q_[action], g);
  p.setPen(Qt::NoPen);
  const auto draw = [&](double value) {
    p.setBrush(QColor::fromRgb(divergingColour(value >= 0 ? 0.5 : -0.5, t.dark)));
    p.drawRect(QRectF(std::min(zero, xOf(value, g)), middle - bar / 2, std::abs(xOf(value, g) - zero), bar));
  };
  if (positive_.empty()) {
    draw(q_[action]);
  } else {
    draw(positive_[action]);
    draw(negative_[action]);
  }
  p.setBrush(t.ink);
  p.drawRect(QRectF(x - 1.25, middle - 0.75 * bar, 2.5, 1.5 * bar));
  for (std::size_t i = 0; i < g.columns.size(); ++i) {
    const Column& column = columns_[g.columns[i]];
    QColor colour = policyLook(column.name, t).colour;
    if (!inForce(g.columns[i])) colour.setAlphaF(0.55f);
    p.setBrush(colour);
    p.drawRect(QRectF(g.first + g.pitch * static_cast<double>(i), middle - bar / 2,
                      g.bar * std::sqrt(column.pi[action]), bar));
  }
}

void ActionRows::drawNumbers(QPainter& p, const Theme& t, const Geometry& g, std::size_t action) const {
  const double middle = g.top + (static_cast<double>(q_.size() - action) - 0.5) * g.row;
  const auto write = [&](double right, const QString& text, bool strong, const QColor& colour) {
    p.setFont(rowFont(g.row, strong ? 500 : 400));
    p.setPen(colour);
    drawSymbol(p, QRectF(right - 200, middle - g.row / 2, 200, g.row), Qt::AlignRight, text);
  };
  write(g.label, actionNameOf(life_.task(), action), static_cast<int>(action) == chosen_, t.ink);
  write(g.qNumber, valueText(q_[action]), true, t.ink);
  for (std::size_t i = 0; i < g.columns.size(); ++i) {
    const bool now = inForce(g.columns[i]);
    const Column& column = columns_[g.columns[i]];
    const bool out = std::isinf(column.worth[action]);  // not allowed, which is not the same as never drawn
    write(g.first + g.pitch * static_cast<double>(i) + g.number,
          out ? QStringLiteral("–") : percentText(column.pi[action]), now && !out, now && !out ? t.ink : t.quiet);
  }
}

void ActionRows::drawThreshold(QPainter& p, const Theme& t, const Geometry& g) const {
  if (life_.configuration().names.policy != "trl") return;
  const double x = xOf(life_.threshold(), g), k = textScale();
  if (onScale(life_.threshold())) {  // else the flag shows on which side it lies
    QPen pen(t.trl, 2 * k, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({3, 2});
    p.setPen(pen);
    p.drawLine(QPointF(x, g.top - 4), QPointF(x, g.bottom));
  }
  const QString beyond = life_.threshold() > high_  ? QStringLiteral(" ›")
                         : life_.threshold() < low_ ? QStringLiteral(" ‹")
                                                    : QString();
  const QString text = tr("threshold %1").arg(countNumber(life_.threshold())) + beyond;
  p.setFont(textFont(11, 500));
  const double w = symbolWidth(p.font(), text) + 10 * k;
  const double right = g.qNumber - symbolWidth(textFont(13, 500), QStringLiteral("Q")) - 6 * k;
  const double left = 12 + widthOf(headOf(life_.task()), 11) + 6 * k;
  const QRectF flag(std::max(std::min(left, right - w), std::min(x - w / 2, right - w)), g.top - 23 * k, w, 17 * k);
  p.setPen(Qt::NoPen);
  p.setBrush(t.trlStrong);
  p.drawRoundedRect(flag, 3, 3);
  p.setPen(t.dark ? t.paper : QColor(Qt::white));
  drawSymbol(p, flag, Qt::AlignHCenter, text);
}

}  // namespace surefoot
