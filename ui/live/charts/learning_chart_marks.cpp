// SPDX-License-Identifier: GPL-3.0-or-later
// The dashed verticals of the charts: changes in the life, and the end of learning.
#include <QHelpEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/language/from_core.h"
#include "ui/live/charts/learning_charts.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/session/history.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/plain_text.h"

namespace surefoot {

QString LearningChart::textOf(const Change& change) const {
  const QString values = QStringLiteral("%1 → %2");
  if (change.key == "policy") {
    const auto title = [&](const std::string& name) {
      const auto entry = findEntry(life_.registry().policies, "policy", name);
      return fromCore(entry ? (*entry)->title : name);
    };
    return values.arg(title(change.before), title(change.after));
  }
  if (change.key == "push") return tr("pushed by hand");
  if (change.key == "place") return tr("placed by hand");
  if (change.key == "go_on") return tr("gone on from an earlier moment");
  const auto* entry = life_.configuration().parameters.find(change.key);
  const QString title = fromCore(entry ? entry->parameter.title : change.key).toLower();
  return title + ' ' + values.arg(toText(change.before), toText(change.after)).replace('-', QChar(0x2212));
}

double LearningChart::timeOfStep(std::int64_t step) const {
  if (span_.inMinutes()) return span_.timeOf(0, step);
  const auto& points = life_.curves().live().points;
  const auto after =
      std::partition_point(points.begin(), points.end(), [&](const CurvePoint& p) { return p.lifeSteps <= step; });
  return after == points.begin() ? 0.0 : xOf(*std::prev(after));
}

/// The marks in the shown part, in the order of their times.
std::vector<LearningChart::Mark> LearningChart::marks() const {
  const ValueSnapshot* v = life_.values();
  std::vector<Mark> list;
  if (!v) return list;
  // A slider that is dragged makes many changes: changes of one parameter that follow closely are one mark.
  struct Together {
    Change change;
    double x;
  };
  std::vector<Together> groups;
  const double near = 0.04 * (span_.to() - span_.from());
  for (const Change& change : v->changes) {
    const double x = timeOfStep(change.step);
    if (x < span_.from() || x > span_.to()) continue;
    if (!groups.empty() && groups.back().change.key == change.key && x - groups.back().x < near)
      groups.back().change.after = change.after;
    else
      groups.push_back({change, x});
  }
  constexpr std::size_t kMost = 24;
  for (std::size_t i = groups.size() > kMost ? groups.size() - kMost : 0; i < groups.size(); ++i)
    if (groups[i].change.before != groups[i].change.after) list.push_back({groups[i].x, textOf(groups[i].change)});
  if (v->endOfLearning > 0) {
    const double end = span_.timeOf(v->endOfLearning, v->endOfLearningSteps);
    if (end >= span_.from() && end <= span_.to()) list.push_back({end, tr("end of learning")});
  }
  std::stable_sort(list.begin(), list.end(), [](const Mark& a, const Mark& b) { return a.x < b.x; });
  return list;
}

/// Each text stands beside its line, the newest lowest, in rows that fill the lower part of the chart. A text without
/// room there is shown under the cursor.
void LearningChart::drawMarks(QPainter& p, const Theme& t) const {
  const std::vector<Mark> list = marks();
  QPen pen(t.ink, 1, Qt::CustomDashLine);
  pen.setDashPattern({2, 3});
  p.setPen(pen);
  for (const Mark& mark : list) {
    const double at = std::round(toPixel(mark.x, 0).x()) + 0.5;
    p.drawLine(QPointF(at, plot_.top()), QPointF(at, plot_.bottom()));
  }
  constexpr double kGap = 4;  // [px]
  p.setFont(textFont(11));
  const double h = std::ceil(QFontMetricsF(p.font()).height());
  const int rows = std::max(1, static_cast<int>(0.7 * plot_.height() / h));
  std::vector<QRectF> taken;
  for (auto mark = list.rbegin(); mark != list.rend(); ++mark) {
    const double at = toPixel(mark->x, 0).x(), w = symbolWidth(p.font(), mark->text) + kGap;
    const double left = at + kGap + w < plot_.right() ? at + kGap : std::max(plot_.left(), at - kGap - w);
    QRectF where(left, plot_.bottom() - 2 - h, w, h);
    const auto meets = [&] {
      return std::any_of(taken.begin(), taken.end(), [&](const QRectF& r) { return r.intersects(where); });
    };
    int row = 0;
    for (; row < rows && meets(); ++row) where.translate(0, -h);
    if (row == rows) continue;
    taken.push_back(where);
    QColor veil = t.panel;
    veil.setAlphaF(0.88f);
    p.fillRect(where, veil);
    p.setPen(t.quiet);
    drawSymbol(p, where, Qt::AlignLeft, mark->text);
  }
}

// Tooltips: the texts of changes under the cursor, and the use of a fall's mark.
bool LearningChart::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::Leave) {
    mouseY_.reset();
    span_.setCursor(std::nullopt);
  }
  if (event->type() != QEvent::ToolTip) return QChartView::viewportEvent(event);
  constexpr double kNear = 6;  // [px]
  const auto& help = static_cast<QHelpEvent&>(*event);
  const QPointF at = QPointF(help.pos()) / textSize();
  QStringList texts;
  for (const Mark& mark : marks())
    if (std::abs(toPixel(mark.x, 0).x() - at.x()) < kNear) texts << mark.text;
  if (shows_ == Shows::Falls && at.y() > plot_.bottom() - 12)
    for (const FallMark& mark : fallMarks())
      if (std::abs(mark.x - at.x()) < 2) {
        texts << (mark.byHand    ? tr("A fall after a person placed or pushed the body. A click replays it.")
                  : mark.answers ? tr("A click replays this fall.")
                                 : tr("This fall is no longer kept; it cannot be replayed."));
        break;
      }
  QToolTip::showText(help.globalPos(), tipText(texts.join('\n')), this);
  return true;
}

}  // namespace surefoot
