// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ActionRows for actions that are combinations (Task::actionVariables): three hundred of them as a few
// columns, one a variable, each with its levels: what the policies choose of it whatever the others are, and the best
// value that an action with this level has.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "ui/action_rows.h"
#include "ui/learning_charts.h"
#include "ui/map_choice.h"
#include "ui/session.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

namespace {
constexpr double kTop = 56, kUnder = 26, kLabels = 66, kBars = 4;  // [px]; the last: between two bars
}

void ActionRows::sumLevels() {
  const Task& task = session_.task();
  levels_.clear();
  for (std::size_t j = 0; j < task.actionVariables.size(); ++j) {
    auto& levels = levels_.emplace_back(task.actionVariables[j].levels.size());
    for (Level& level : levels) {
      level.chance.assign(columns_.size(), 0.0);
      level.best = -kInfinity;
    }
    for (std::size_t a = 0; a < q_.size(); ++a) {
      Level& level = levels[levelOf(task, a, j)];
      level.best = std::max(level.best, q_[a]);
      for (std::size_t i = 0; i < columns_.size(); ++i) level.chance[i] += columns_[i].pi[a];
    }
  }
}

void ActionRows::drawLevels(QPainter& p, const Theme& t) const {
  const Task& task = session_.task();
  const double pitch = (width() - kLabels) / static_cast<double>(levels_.size());
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  const auto& variables = task.actionVariables;
  p.drawText(QPointF(12, kTop - 12), toText(task.actionTitle));
  drawPolicyKey(p, t);
  for (std::size_t j = 0; j < levels_.size(); ++j) {
    const double left = kLabels + pitch * static_cast<double>(j);
    p.setFont(textFont(13, 500));
    p.setPen(t.ink);
    const QString title = QFontMetricsF(p.font()).elidedText(toText(variables[j].title), Qt::ElideRight, pitch - 8);
    p.drawText(QPointF(left, kTop - 12), title);
    drawLevelsOf(p, t, j, left, pitch);
  }
}

/// The three policies, with their markers, in the head.
void ActionRows::drawPolicyKey(QPainter& p, const Theme& t) const {
  double x = 12;
  for (const Column& column : columns_) {
    const bool inForce = column.name == session_.configuration().names.policy;
    drawMarker(p, {x + 4, 12.5}, policyLook(column.name, t), inForce);
    p.setFont(textFont(11, inForce ? 500 : 400));
    p.setPen(inForce ? t.ink : t.quiet);
    p.drawText(QPointF(x + 14, 17), column.title);
    x += 14 + QFontMetricsF(p.font()).horizontalAdvance(column.title) + 18;
  }
  const QString what = tr("%1 actions: by joint").arg(q_.size());
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  const double room = QFontMetricsF(p.font()).horizontalAdvance(what);
  if (x + room < width() - 12) p.drawText(QPointF(width() - 12 - room, 17), what);
}

void ActionRows::drawLevelsOf(QPainter& p, const Theme& t, std::size_t variable, double left, double pitch) const {
  const Task& task = session_.task();
  const auto& levels = levels_[variable];
  const double row = std::clamp((height() - kTop - kUnder) / static_cast<double>(levels.size()), 15.0, 28.0);
  const double bottom = kTop + row * static_cast<double>(levels.size());
  const double best = left + pitch - 12, percent = best - 44, bar = std::max(20.0, percent - 46 - left);
  p.setFont(textFont(11));
  for (const int share : {0, 1, 10, 100}) {  // a square-root axis: the exploring few per cent are what differs
    const double x = std::round(left + bar * std::sqrt(share / 100.0)) + 0.5;
    p.setPen(QPen(share == 0 ? t.outline : t.hairline, 1));
    p.drawLine(QPointF(x, kTop), QPointF(x, bottom));
    p.setPen(t.quiet);
    if (share >= 10 && (share == 100 || bar > 60))
      drawSymbol(p, QRectF(x - 30, bottom + 4, 60, 16), Qt::AlignHCenter, QString::number(share));
  }
  drawSymbol(p, QRectF(percent - 40, bottom + 4, 40, 16), Qt::AlignRight, QStringLiteral("%"));
  drawSymbol(p, QRectF(best - 60, bottom + 4, 60, 16), Qt::AlignRight, tr("max Q"));

  const bool knows = chosen_ != kNoAction && chosen_ >= 0;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const double middle = kTop + (static_cast<double>(levels.size() - l) - 0.5) * row;
    const bool chosen = knows && levelOf(task, static_cast<std::size_t>(chosen_), variable) == l;
    if (chosen) {
      p.setPen(Qt::NoPen);
      p.setBrush(t.fill);
      p.drawRoundedRect(QRectF(left - 4, middle - row / 2 + 1, pitch - 4, row - 2), 4, 4);
    }
    if (variable == 0) {
      p.setPen(t.ink);
      p.setFont(textFont(13));
      drawSymbol(p, QRectF(0, middle - 10, kLabels - 16, 20), Qt::AlignRight,
                 toText(fixedText(task.actionVariables[0].levels[l], 1)));
    }
    drawLevel(p, t, levels[l], chosen, {left, bar, percent, best, middle, row});
  }
}

void ActionRows::drawLevel(QPainter& p, const Theme& t, const Level& level, bool chosen, const LevelPlace& at) const {
  const double height = std::max(2.0, (at.row - kBars) / static_cast<double>(columns_.size()));
  double shown = 0.0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const bool inForce = columns_[i].name == session_.configuration().names.policy;
    QColor colour = policyLook(columns_[i].name, t).colour;
    if (!inForce) colour.setAlphaF(0.55f);
    if (inForce || i == 0) shown = level.chance[i];
    p.setPen(Qt::NoPen);
    p.setBrush(colour);
    const double top = at.middle + (static_cast<double>(i) - static_cast<double>(columns_.size()) / 2) * height;
    p.drawRect(QRectF(at.left, top, at.bar * std::sqrt(std::clamp(level.chance[i], 0.0, 1.0)), height));
  }
  p.setFont(textFont(13, chosen ? 500 : 400));
  p.setPen(t.ink);
  drawSymbol(p, QRectF(at.percent - 60, at.middle - 10, 60, 20), Qt::AlignRight, toText(fixedText(100 * shown, 1)));
  p.setPen(chosen ? t.ink : t.quiet);
  drawSymbol(p, QRectF(at.best - 60, at.middle - 10, 60, 20), Qt::AlignRight,
             toText(fixedText(level.best, std::abs(level.best) < 9.95 ? 1 : 0)));
}

}  // namespace surefoot
