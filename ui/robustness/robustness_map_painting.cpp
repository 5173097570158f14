// SPDX-License-Identifier: GPL-3.0-or-later
// What a map of robustness looks like.
#include <fmt/format.h>
#include <QFileInfo>
#include <QPaintEvent>
#include <QPainter>
#include <cmath>

#include "core/robustness/robustness_text.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/robustness/robustness_map.h"
#include "ui/style/colour_map.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr double kHeadOfColumns = 22;                                         // [px] from the top
constexpr double kRoomForNumber = 28, kRoomForInterval = 48, kTwoLines = 30;  // [px] of a cell

/// Falls are vermilion, successes blue, and white is none of either.
QColor colourOf(const RobustnessPlan& plan, double share, bool dark) {
  return QColor(divergingColour(plan.canFall ? -share : share, dark));
}

/// Ink that can be read on a colour.
QColor inkOn(const QColor& c) {
  const double light = 0.299 * c.redF() + 0.587 * c.greenF() + 0.114 * c.blueF();
  return light > 0.55 ? lightTheme().ink : QColor(Qt::white);
}

QString percent(double share) {
  return fixedNumber(100 * share, 0);
}

QString elided(const QFont& font, const QString& text, double width, Qt::TextElideMode mode = Qt::ElideRight) {
  return QFontMetricsF(font).elidedText(text, mode, width);
}

}  // namespace

void RobustnessMap::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.setFont(textFont(13));
  if (!robustness_) {
    p.setPen(t.quiet);
    p.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
               tr("How often it falls appears here: a column a push, a row a model."));
    return;
  }
  const Layout l = layOut();
  paintRows(p, l);
  for (std::size_t f = 0; f < robustness_->plan.functions.size(); ++f) {
    paintHeads(p, l, f);
    paintMap(p, l, f);
  }
  paintFoot(p, l);
}

void RobustnessMap::paintRows(QPainter& p, const Layout& l) const {
  const Theme& t = themeOf(*this);
  const double width = l.labels - 12;
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  p.drawText(QRectF(0, kHeadOfColumns, width, 20), Qt::AlignRight | Qt::AlignVCenter, tr("push, N s"));
  p.setFont(textFont(13));
  p.setPen(t.ink);
  for (std::size_t m = 0; m < l.rows; ++m) {
    const QRectF cell = l.at(0, m, 0);
    p.drawText(QRectF(0, cell.top(), width, cell.height()), Qt::AlignRight | Qt::AlignVCenter,
               elided(p.font(), fromCore(robustness_->plan.models[m].title), width, Qt::ElideMiddle));
  }
}

void RobustnessMap::paintHeads(QPainter& p, const Layout& l, std::size_t function) const {
  const Theme& t = themeOf(*this);
  const RobustnessPlan& plan = robustness_->plan;
  const QRectF map = l.map(function);
  p.setFont(textFont(13, 500));
  p.setPen(t.ink);
  const QString name = QFileInfo(toText(plan.functions[function])).fileName();
  p.drawText(QRectF(map.left(), 0, map.width(), 20), Qt::AlignLeft | Qt::AlignVCenter,
             elided(p.font(), name, map.width()));
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  const auto text = [&](std::size_t push) {
    return localNumbers(fmt::format("{:.3g}", plan.pushes[push])).replace('-', QChar(0x2212));
  };
  double widest = 0;
  for (std::size_t push = 0; push < l.columns; ++push)
    widest = std::max(widest, QFontMetricsF(p.font()).horizontalAdvance(text(push)) + 6);
  const auto every = static_cast<std::size_t>(std::max(1.0, std::ceil(widest / l.cell)));
  for (std::size_t push = 0; push < l.columns; push += every) {
    const double middle = l.at(function, 0, push).center().x();
    const double left = std::min(std::max(middle - widest / 2, map.left() - 6), map.right() + 6 - widest);
    p.drawText(QRectF(every == 1 ? middle - widest / 2 : left, kHeadOfColumns, widest, 20), Qt::AlignCenter,
               text(push));
  }
}

void RobustnessMap::paintCell(QPainter& p, const Layout& l, const QRectF& where, const Tally& tally) const {
  const Theme& t = themeOf(*this);
  const RobustnessPlan& plan = robustness_->plan;
  const Interval share = plan.canFall ? tally.fallen() : tally.succeeded();
  const QColor colour = colourOf(plan, share.value, t.dark);
  p.fillRect(where.adjusted(0, 0, -1, -1), colour);
  if (l.cell < kRoomForNumber) return;
  p.setPen(inkOn(colour));
  const bool both = l.cell >= kRoomForInterval && l.row >= kTwoLines;
  const double middle = where.center().y();
  p.setFont(textFont(13, 500));
  p.drawText(both ? QRectF(where.left(), middle - 15, where.width(), 16) : where.adjusted(0, 0, -1, -1),
             Qt::AlignCenter, percent(share.value));
  if (!both) return;
  p.setFont(textFont(11));
  p.drawText(QRectF(where.left(), middle, where.width() - 1, 13), Qt::AlignCenter,
             QStringLiteral("%1–%2").arg(percent(share.low), percent(share.high)));
}

void RobustnessMap::paintMap(QPainter& p, const Layout& l, std::size_t function) const {
  const Theme& t = themeOf(*this);
  for (std::size_t m = 0; m < l.rows; ++m)
    for (std::size_t push = 0; push < l.columns; ++push) {
      const QRectF where = l.at(function, m, push);
      paintCell(p, l, where, robustness_->at(function, m, push));
      if (!robustness_->differ(m, push)) continue;
      p.setPen(QPen(t.ink, 2));
      p.drawRect(where.adjusted(1, 1, -2, -2));
    }
  if (!chosen_ || exporting_) return;
  p.setPen(QPen(t.accent, 2));
  p.drawRect(l.at(function, chosen_->model, chosen_->push).adjusted(-1, -1, 0, 0));
}

// 0 % … 100 %
void RobustnessMap::paintScale(QPainter& p, QPointF at) const {
  const Theme& t = themeOf(*this);
  constexpr int kStops = 60;
  for (int i = 0; i < kStops; ++i)
    p.fillRect(QRectF(at.x() + 30 + 2 * i, at.y() + 5, 2, 8), colourOf(robustness_->plan, (i + 0.5) / kStops, t.dark));
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  p.drawText(QRectF(at.x(), at.y(), 26, 18), Qt::AlignLeft | Qt::AlignVCenter, tr("0 %"));
  p.drawText(QRectF(at.x() + 30 + 2 * kStops + 4, at.y(), 110, 18), Qt::AlignLeft | Qt::AlignVCenter,
             robustness_->plan.canFall ? tr("100 % fell") : tr("100 % succeeded"));
}

void RobustnessMap::paintFoot(QPainter& p, const Layout& l) const {
  const Theme& t = themeOf(*this);
  const double top = l.map(0).bottom() + 8;
  constexpr double kScaleWidth = 270;
  paintScale(p, {0, top});
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  const bool two = robustness_->plan.functions.size() > 1;
  if (two) {
    p.setPen(QPen(t.ink, 2));
    p.drawRect(QRectF(kScaleWidth + 1, top + 3, 14, 11));
    p.setPen(t.quiet);
  }
  const QString words = two ? tr("the 95 % intervals of the two have nothing in common") : QString();
  const double from = kScaleWidth + (two ? 22 : 0);
  p.drawText(QRectF(from, top, width() - from, 18), Qt::AlignLeft | Qt::AlignVCenter,
             elided(p.font(), words, width() - from));
  p.drawText(QRectF(0, top + 18, width(), 18), Qt::AlignLeft | Qt::AlignVCenter,
             elided(p.font(), conditions(), width()));
}

/// Under which conditions the map was made.
QString RobustnessMap::conditions() const {
  const RobustnessPlan& plan = robustness_->plan;
  QString text = tr("%1 starts a cell").arg(countNumber(static_cast<double>(plan.starts)));
  if (plan.stepTime) {
    const auto seconds = [&](std::int64_t steps) {
      return localNumbers(QString::number(static_cast<double>(steps) * *plan.stepTime));
    };
    text += plan.earliest == plan.latest
                ? tr(", pushed at %1 s").arg(seconds(plan.earliest))
                : tr(", pushed between %1 and %2 s").arg(seconds(plan.earliest), seconds(plan.latest));
    text += tr(", followed for %1 s").arg(seconds(plan.after));
  }
  return text + tr(", policy %1, seed %2").arg(toText(plan.policy)).arg(plan.seed);
}

}  // namespace surefoot
