// SPDX-License-Identifier: GPL-3.0-or-later
// The risk of a fall in the rows of ActionRows: a bar on a logarithmic axis, because limits lie between 0.1 and 10 %.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/language/numbers.h"
#include "ui/live/actions/action_rows.h"
#include "ui/live/maps/map_choice.h"
#include "ui/running/running_life.h"
#include "ui/session/editing.h"
#include "ui/style/policy_look.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr double kLeast = 0.001;                  // left end of the axis
constexpr std::int64_t kYoung = 1000;             // steps, before which numbers say little
constexpr double kFoot = 34, kWithSentence = 52;  // [px] below the rows, with texts of the usual size

QString riskText(double risk) {
  const double percent = 100 * std::clamp(risk, 0.0, 1.0);
  return fixedNumber(percent, percent < 9.95 ? 1 : 0);
}

}  // namespace

bool ActionRows::riskIsYoung() const {
  return life_.numbers().steps < kYoung;
}

/// The limit of the policy in force; none: it does not look at the risk of each action.
std::optional<double> ActionRows::riskLimit() const {
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (inForce(i)) return risk_.empty() ? std::nullopt : columns_[i].policy->caution().limit();
  return std::nullopt;
}

double ActionRows::foot() const {
  return risk_.empty() ? kFoot : kWithSentence;
}

double ActionRows::xOfRisk(double risk, const Geometry& g) const {
  const double share = 1.0 - std::log10(std::clamp(risk, kLeast, 1.0)) / std::log10(kLeast);
  return g.riskLeft + share * (g.riskRight - g.riskLeft);
}

/// Where actions are combinations, too many for a row each.
QString ActionRows::sentenceOfMany(std::optional<double> limit) const {
  QStringList parts;
  if (chosen_ >= 0) parts << tr("risk of the next action %1 %").arg(riskText(risk_[static_cast<std::size_t>(chosen_)]));
  const auto below = limit ? std::count_if(risk_.begin(), risk_.end(), [&](double r) { return r <= *limit; }) : 0;
  if (limit)
    parts << tr("%1 of %2 actions are below the limit of %3 %")
                 .arg(below)
                 .arg(risk_.size())
                 .arg(localNumbers(QString::number(100 * *limit, 'g', 3)));
  return parts.join(QStringLiteral("; "));
}

/// Several that are left out, none of which is worth much.
QString ActionRows::sentenceOfSeveral(const std::vector<std::size_t>& out) const {
  QStringList names;
  double least = 1.0, most = 0.0;
  for (const std::size_t a : out) {
    names << actionNameOf(life_.task(), a);
    least = std::min(least, risk_[a]), most = std::max(most, risk_[a]);
  }
  const QString last = names.takeLast(), unit = toText(life_.task().actionUnit);
  return tr("%1 and %2 are left out: %3 to %4 in 100 such actions end in a fall.")
      .arg(names.join(QStringLiteral(", ")), unit.isEmpty() ? last : last + ' ' + unit, riskText(least),
           riskText(most));
}

QString ActionRows::sentence() const {
  const auto now = std::find_if(columns_.begin(), columns_.end(),
                                [this](const Column& c) { return c.name == life_.configuration().names.policy; });
  if (risk_.empty() || now == columns_.end() || riskIsYoung()) return {};
  const auto placeOf = [](const auto& it, const auto& row) { return static_cast<std::size_t>(it - row.begin()); };
  const Caution& caution = now->policy->caution();
  if (!life_.task().actionVariables.empty()) return sentenceOfMany(caution.limit());
  const auto name = [this](std::size_t a) {
    const QString unit = toText(life_.task().actionUnit);
    return actionNameOf(life_.task(), a) + (unit.isEmpty() ? QString() : ' ' + unit);
  };
  std::size_t best = placeOf(std::max_element(q_.begin(), q_.end()), q_);
  if (caution.rule() == CautionRule::Weight) {
    const double price = caution.weight() * std::max(0.0, risk_[best]);
    if (price < 0.05 * (high_ - low_)) return {};
    return tr("%1 is worth most, but its risk of %2 % counts as −%3.")
        .arg(name(best), riskText(risk_[best]), countNumber(price));
  }
  const auto limit = caution.limit();
  if (!limit) return {};
  if (*std::min_element(risk_.begin(), risk_.end()) > *limit)
    return caution.rule() == CautionRule::Filter ? tr("All are above the limit: the least risky is taken.")
                                                 : tr("All are above the limit: only the best is taken.");
  double among = -1e300;  // the best value among the allowed
  std::optional<std::size_t> out;
  std::vector<std::size_t> all;  // that are left out
  for (std::size_t a = 0; a < q_.size(); ++a) {
    if (risk_[a] <= *limit) {
      among = std::max(among, q_[a]);
      continue;
    }
    if (!out || q_[a] > q_[*out]) out = a;
    if (caution.rule() == CautionRule::Filter || a != best) all.push_back(a);
  }
  if (!out || (caution.rule() == CautionRule::Explore && *out == best)) return {};
  const bool more = q_[*out] > among, nearly = q_[*out] > among - 0.1 * (high_ - low_);
  if (!more && !nearly && all.size() > 1) return sentenceOfSeveral(all);
  const QString words = more ? tr("%1 is worth most, but %2 in 100 such actions end in a fall.")
                        : nearly
                            ? tr("%1 is worth nearly as much as the best, but %2 in 100 such actions end in a fall.")
                            : tr("%1 is left out: %2 in 100 such actions end in a fall.");
  return words.arg(name(*out), riskText(risk_[*out]));
}

void ActionRows::drawRisk(QPainter& p, const Theme& t, const Geometry& g) const {
  const double k = textScale(), baseline = 20 * k;
  p.setFont(textFont(13, 500));
  p.setPen(t.ink);
  drawSymbol(p, g.riskNumber - symbolWidth(p.font(), tr("Risk")), baseline, tr("Risk"));
  drawRiskScale(p, t, g);
  const auto limit = riskLimit();
  for (std::size_t a = 0; a < risk_.size(); ++a) {
    const double middle = g.top + (static_cast<double>(risk_.size() - a) - 0.5) * g.row;
    const double bar = std::min(6 * k, 0.4 * g.row);
    p.setPen(Qt::NoPen);
    p.setBrush(t.fall);
    p.drawRect(QRectF(g.riskLeft, middle - bar / 2, xOfRisk(risk_[a], g) - g.riskLeft, bar));
    p.setFont(rowFont(g.row, 500));
    p.setPen(riskIsYoung() ? t.quiet : limit && risk_[a] > *limit ? t.fallText : t.ink);
    const QString text = riskIsYoung() ? riskText(risk_[a]) + '?' : riskText(risk_[a]);
    drawSymbol(p, QRectF(g.riskNumber - 200, middle - g.row / 2, 200, g.row), Qt::AlignRight, text);
  }
  drawRiskLimit(p, t, g);
  drawSentence(p, t, g.bottom + 22 * k);
}

void ActionRows::drawSentence(QPainter& p, const Theme& t, double top) const {
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  const double height = QFontMetricsF(p.font()).height();
  drawSymbol(p, QRectF(12, top, width() - 24, height), Qt::AlignLeft,
             QFontMetricsF(p.font()).elidedText(sentence(), Qt::ElideRight, width() - 24));
}

void ActionRows::drawRiskScale(QPainter& p, const Theme& t, const Geometry& g) const {
  p.setFont(textFont(11));
  const double height = QFontMetricsF(p.font()).height();
  double last = -1e9;
  for (const double percent : {0.1, 1.0, 10.0, 100.0}) {
    const double x = std::round(xOfRisk(percent / 100, g)) + 0.5;
    p.setPen(QPen(percent == 0.1 ? t.outline : t.hairline, 1));
    p.drawLine(QPointF(x, g.top), QPointF(x, g.bottom));
    const QString text = localNumbers(QString::number(percent));
    const double half = symbolWidth(p.font(), text) / 2;
    if (x - half < last + 4) continue;
    last = x + half;
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(x - half, g.bottom + 4, 2 * half, height), Qt::AlignHCenter, text);
  }
  if (last + 2 < g.riskNumber - symbolWidth(p.font(), QStringLiteral("%")))
    drawSymbol(p, QRectF(g.riskNumber - 20, g.bottom + 4, 20, height), Qt::AlignRight, QStringLiteral("%"));
}

void ActionRows::drawRiskLimit(QPainter& p, const Theme& t, const Geometry& g) const {
  const auto limit = riskLimit();
  if (!limit) return;
  const double x = xOfRisk(*limit, g), k = textScale();
  QPen pen(t.trl, 2 * k, Qt::CustomDashLine, Qt::FlatCap);
  pen.setDashPattern({3, 1.5});
  p.setPen(pen);
  p.drawLine(QPointF(x, g.top - 4), QPointF(x, g.bottom));
  const QString text = tr("limit %1 %").arg(localNumbers(QString::number(100 * *limit, 'g', 3)));
  p.setFont(textFont(11, 500));
  const double w = symbolWidth(p.font(), text) + 10 * k;
  const double right = g.riskNumber - symbolWidth(textFont(13, 500), tr("Risk")) - 4 * k;
  const QRectF flag(std::min(x - w / 2, right - w), g.top - 23 * k, w, 17 * k);
  p.setPen(Qt::NoPen);
  p.setBrush(t.trlStrong);
  p.drawRoundedRect(flag, 3, 3);
  p.setPen(t.dark ? t.paper : QColor(Qt::white));
  drawSymbol(p, flag, Qt::AlignHCenter, text);
}

bool ActionRows::onRiskLimit(const QPointF& at) const {
  const auto limit = riskLimit();
  if (!limit || !levels_.empty()) return false;
  const Geometry g = geometry();
  return std::abs(at.x() - xOfRisk(*limit, g)) < 6 && at.y() > 6 && at.y() < g.bottom;
}

/// In steps that a person would take: two digits.
void ActionRows::dragRiskLimit(double x) {
  if (!riskLimit()) return;  // it went away while it was dragged
  const Geometry g = geometry();
  const double share = std::clamp((x - g.riskLeft) / (g.riskRight - g.riskLeft), 0.0, 1.0);
  const double risk = std::pow(10.0, std::log10(kLeast) * (1.0 - share));
  const double step = std::pow(10.0, std::floor(std::log10(risk)) - 1);
  const double value = std::min(1.0, std::round(risk / step) * step);
  if (value != riskLimit()) static_cast<void>(static_cast<bool>(editing_.setParameter("policy.risk_limit", value)));
}

}  // namespace surefoot
