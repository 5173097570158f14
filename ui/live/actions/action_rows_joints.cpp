// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ActionRows for actions that are combinations (Task::actionVariables). Three hundred actions become a few
// columns, one per variable. Each level has its probability under the policies, summed over the other variables, and
// the best value of an action with this level.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/live/actions/action_rows.h"
#include "ui/live/maps/map_choice.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/session/editing.h"
#include "ui/style/policy_look.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr double kTop = 34, kUnder = 26, kBetween = 4;  // [px], with texts of the usual size

/// The word that ends every variable's title, such as "voltage"; else nothing.
std::string commonEnd(const std::vector<ActionVariable>& variables) {
  const std::string& title = variables[0].title;
  const std::string end = title.substr(title.rfind(' ') + 1);
  const auto ends = [&](const ActionVariable& v) { return v.title.ends_with(' ' + end); };
  return std::all_of(variables.begin(), variables.end(), ends) ? end : std::string();
}

/// "Stance hip" from "stance hip voltage".
QString headOf(const ActionVariable& v, const std::string& end) {
  QString title = fromCore(end.empty() ? v.title : v.title.substr(0, v.title.size() - end.size() - 1));
  title[0] = title[0].toUpper();
  return title;
}

}  // namespace

void ActionRows::sumLevels() {
  const Task& task = life_.task();
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
  const auto& variables = life_.task().actionVariables;
  const double k = textScale(), labels = k * 66;
  const double pitch = (width() - labels) / static_cast<double>(levels_.size());
  const std::string end = commonEnd(variables);
  if (!risk_.empty()) drawSentence(p, t, height() - 20 * k);
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  drawSymbol(p, 12, k * (kTop - 12), fromCore(end.empty() ? life_.task().actionTitle : end));
  for (std::size_t j = 0; j < levels_.size(); ++j) {
    const double left = labels + pitch * static_cast<double>(j);
    p.setFont(textFont(13, 500));
    p.setPen(t.ink);
    const QString title = QFontMetricsF(p.font()).elidedText(headOf(variables[j], end), Qt::ElideRight, pitch - 8);
    drawSymbol(p, left, k * (kTop - 12), title);
    drawLevelsOf(p, t, j, left, pitch);
  }
}

void ActionRows::drawLevelsOf(QPainter& p, const Theme& t, std::size_t variable, double left, double pitch) const {
  const Task& task = life_.task();
  const auto& levels = levels_[variable];
  const double k = textScale(), n = static_cast<double>(levels.size()), top = k * kTop;
  const double under = kUnder + (risk_.empty() ? 0 : 18);
  const double row = std::clamp((height() - top - k * under) / n, 8.0, 28.0 * k);
  const double right = left + pitch - 12 * k, values = symbolWidth(textFont(13, 500), QStringLiteral("−1234")) + 14 * k;
  const double percents = symbolWidth(textFont(13, 500), QStringLiteral("100.0")) + 8 * k;
  const bool room = right - left - values - percents > 36 * k;  // room for the values, too
  LevelPlace at{left, 0, room ? right - values : right, room ? right : 0, 0, row};
  at.bar = std::max(12.0, at.percent - percents - left);
  drawLevelScale(p, t, at, top + row * n);
  for (std::size_t l = 0; l < levels.size(); ++l) {
    at.middle = top + (n - static_cast<double>(l) - 0.5) * row;
    const bool chosen = chosen_ >= 0 && levelOf(task, static_cast<std::size_t>(chosen_), variable) == l;
    if (chosen) {
      p.setPen(Qt::NoPen);
      p.setBrush(t.fill);
      p.drawRoundedRect(QRectF(left - 6, at.middle - row / 2 + 1, pitch - 4, row - 2), 4, 4);
    }
    if (variable == 0) {
      const double end = left - 24 * k;
      p.setPen(t.ink);
      p.setFont(rowFont(row, 400));
      drawSymbol(p, QRectF(0, at.middle - row / 2, end, row), Qt::AlignRight,
                 fixedNumber(task.actionVariables[0].levels[l], 1));
      p.setPen(t.quiet);
      p.setFont(textFont(11));
      if (l + 1 == levels.size())
        drawSymbol(p, QRectF(end + 4, at.middle - row / 2, 40, row), Qt::AlignLeft, toText(task.actionUnit));
    }
    drawLevelBars(p, t, levels[l], at);
    drawLevelNumbers(p, t, levels[l], chosen, at);
  }
}

void ActionRows::drawLevelScale(QPainter& p, const Theme& t, const LevelPlace& at, double bottom) const {
  p.setFont(textFont(11));
  const double height = QFontMetricsF(p.font()).height();
  const auto write = [&](double right, const QString& text) {
    drawSymbol(p, QRectF(right - 80, bottom + 3, 80, height), Qt::AlignRight, text);
  };
  double last = -1e9;
  for (const int share : {0, 1, 10, 100}) {  // square-root axis: policies differ in the few per cent of exploring
    const double x = std::round(at.left + at.bar * std::sqrt(share / 100.0)) + 0.5;
    p.setPen(QPen(share == 0 ? t.outline : t.hairline, 1));
    p.drawLine(QPointF(x, textScale() * kTop), QPointF(x, bottom));
    p.setPen(t.quiet);
    const QString text = localNumbers(QString::number(share));
    const double half = symbolWidth(p.font(), text) / 2;
    if (share == 0 || x - half < last + 4) continue;
    last = x + half;
    write(last, text);
  }
  const double percent = symbolWidth(p.font(), QStringLiteral("%"));
  if (last + 2 < at.percent - percent) write(at.percent, QStringLiteral("%"));
  if (at.best > 0) write(at.best, tr("max Q"));
}

/// The bar of the policy in force is as high as two of the others.
void ActionRows::drawLevelBars(QPainter& p, const Theme& t, const Level& level, const LevelPlace& at) const {
  const double unit = (at.row - kBetween * textScale()) / (static_cast<double>(columns_.size()) + 1);
  double top = at.middle - (at.row - kBetween * textScale()) / 2;
  p.setPen(Qt::NoPen);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    QColor colour = policyLook(columns_[i].name, t).colour;
    if (!inForce(i)) colour.setAlphaF(0.55f);
    p.setBrush(colour);
    const double height = inForce(i) ? 2 * unit : unit;
    p.drawRect(QRectF(at.left, top, at.bar * std::sqrt(std::clamp(level.chance[i], 0.0, 1.0)), height));
    top += height;
  }
}

/// Only the policy in force has numbers.
void ActionRows::drawLevelNumbers(QPainter& p, const Theme& t, const Level& level, bool chosen,
                                  const LevelPlace& at) const {
  const auto write = [&](double right, const QString& text) {
    drawSymbol(p, QRectF(right - 200, at.middle - at.row / 2, 200, at.row), Qt::AlignRight, text);
  };
  p.setFont(rowFont(at.row, chosen ? 500 : 400));
  p.setPen(t.ink);
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (inForce(i)) write(at.percent, fixedNumber(100 * level.chance[i], 1));
  if (at.best <= 0) return;
  p.setPen(chosen ? t.ink : t.quiet);
  const double size = std::abs(level.best);
  write(at.best, fixedNumber(level.best, size < 0.0005 ? 1 : size < 0.095 ? 3 : size < 9.95 ? 1 : 0));
}

}  // namespace surefoot
