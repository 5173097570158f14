// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/condition_list.h"

#include <QPainter>

#include "core/plans/plan_time.h"
#include "ui/experiment/experiment.h"
#include "ui/experiment/figures/condition_name.h"
#include "ui/language/numbers.h"
#include "ui/style/policy_look.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/counted.h"

namespace surefoot {

namespace {
constexpr int kRow = 32, kLine = 24, kPadding = 12, kHead = 34, kGroup = 26;  // [px]
}  // namespace

ConditionList::ConditionList(Experiment& experiment, QWidget* parent) : Painted(parent), experiment_(experiment) {
  setAccessibleName(tr("Conditions"));
  const auto refresh = [this] {
    std::vector<std::string> names;
    for (const StoredCondition& c : experiment_.storedPlan().conditions) names.push_back(c.name);
    names_ = groupNames(names);
    updateGeometry();
    setMinimumHeight(sizeHint().height());
    update();
  };
  whenScaled(this, refresh);
  connect(&experiment_, &Experiment::planChanged, this, refresh);
  connect(&experiment_, &Experiment::resultsChanged, this, refresh);
  connect(&experiment_, &Experiment::progressed, this, qOverload<>(&QWidget::update));
}

QSize ConditionList::sizeHint() const {
  const auto rows = static_cast<int>(experiment_.storedPlan().conditions.size());
  const auto groups = static_cast<int>(names_.groups.size());
  return scaled({264, kRow * rows + kGroup * groups + kHead + kLine * static_cast<int>(design().size()) + 16});
}

/// What p is of: what is independent in this plan.
QString ConditionList::testWords() const {
  const auto& plan = experiment_.plan();
  const PreLearning* before = plan && !plan->conditions.empty() && plan->conditions.back().preLearning
                                  ? &*plan->conditions.back().preLearning
                                  : nullptr;
  return before && before->pool == 0       ? tr("pairs of Q-functions, p < .01")
         : before                          ? tr("%1 Q-functions, p < .01").arg(before->pool)
         : experiment_.storedPlan().paired ? tr("pairs of lives, p < .01")
                                           : tr("one-way ANOVA, p < .01");
}

std::vector<std::pair<QString, QString>> ConditionList::design() const {
  std::vector<std::pair<QString, QString>> list;
  const StoredPlan& stored = experiment_.storedPlan();
  if (stored.conditions.empty()) return list;
  if (const auto& plan = experiment_.plan(); plan && !plan->conditions.empty()) {
    const Condition& c = plan->conditions.front();
    list.push_back({tr("Environment"), toText(c.configuration.names.environment)});
    if (c.preLearning) {
      const Configuration& before = c.preLearning->configuration;
      list.push_back({tr("Pre-learning"),
                      before.until
                          ? tr("scenario %1, to %2").arg(toText(before.names.scenario), fixedNumber(*before.until, 0))
                          : tr("scenario %1, %2 min")
                                .arg(toText(before.names.scenario))
                                .arg(localNumbers(QString::number(before.minutes.value_or(0))))});
      list.push_back(
          {tr("Q-functions"), c.preLearning->pool == 0 ? tr("one a life") : QString::number(c.preLearning->pool)});
    }
    if (c.configuration.minutes)
      list.push_back(
          {tr("A life"), tr("%1 simulated min").arg(localNumbers(QString::number(*c.configuration.minutes)))});
    if (c.configuration.episodes) list.push_back({tr("A life"), episodesText(*c.configuration.episodes)});
  }
  list.push_back({tr("Lives"), tr("%1 a condition").arg(stored.conditions.front().lives)});
  list.push_back({tr("Seeds"), stored.paired ? tr("paired, from %1").arg(stored.seed)
                                             : tr("independent, from %1").arg(stored.seed)});
  list.push_back({tr("Test"), testWords()});
  if (!stored.growth.empty()) list.push_back({tr("Lives grow"), tr("until it is decided")});
  if (experiment_.minutes() > 0)
    list.push_back({tr("Takes"), tr("about %1").arg(localNumbers(roundedTime(experiment_.minutes())))});
  return list;
}

void ConditionList::drawGroup(QPainter& p, const QString& title, double y) const {
  const Theme& t = themeOf(*this);
  p.setFont(textFont(11, 500));
  p.setPen(t.quiet);
  const int room = width() - 2 * kPadding;
  drawSymbol(p, QRectF(kPadding, y + 8, room, 16), Qt::AlignLeft,
             p.fontMetrics().elidedText(title, Qt::ElideRight, room));
}

void ConditionList::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.fillRect(rect(), t.panel);
  p.setRenderHint(QPainter::Antialiasing);
  const StoredPlan& stored = experiment_.storedPlan();
  if (stored.conditions.empty()) {
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    p.drawText(rect().adjusted(kPadding, 8, -kPadding, 0), Qt::AlignTop | Qt::TextWordWrap,
               tr("Conditions appear here. Choose a plan above, or open one."));
    return;
  }
  const int right = width() - kPadding;
  double y = 0;
  for (std::size_t place = 0; place < names_.order.size(); ++place) {
    for (const NameGroups::Run& group : names_.groups) {
      if (group.first != place) continue;
      drawGroup(p, group.title, y);
      y += kGroup;
    }
    const StoredCondition& c = stored.conditions[names_.order[place]];
    drawMarker(p, {kPadding + 6.0, y + 14}, policyLook(experiment_.policyOf(c.name), t), true);
    const int lives = experiment_.livesOf(c.name);
    const QString count = QStringLiteral("%1 / %2").arg(lives).arg(c.lives);
    p.setFont(textFont(13));
    const double w = symbolWidth(p.font(), count);
    p.setPen(lives == c.lives ? t.quiet : t.ink);
    drawSymbol(p, QRectF(right - w, y + 4, w, 20), Qt::AlignRight, count);
    p.setPen(t.ink);
    const double room = right - w - 12 - 36;
    drawSymbol(p, QRectF(36, y + 4, room, 20), Qt::AlignLeft,
               p.fontMetrics().elidedText(nameInGroup(c.name), Qt::ElideMiddle, static_cast<int>(room)));
    p.fillRect(QRectF(36, y + 26, right - 36, 2), t.track);
    if (c.lives > 0)
      p.fillRect(QRectF(36, y + 26, (right - 36.0) * lives / c.lives, 2), lives == c.lives ? t.quiet : t.ink);
    y += kRow;
  }
  p.fillRect(QRectF(kPadding, y + 6, right - kPadding, 1), t.hairline);
  QFont head = textFont(11, 500);
  head.setLetterSpacing(QFont::AbsoluteSpacing, 0.6);
  p.setFont(head);
  p.setPen(t.quiet);
  p.drawText(QPointF(kPadding, y + 26), tr("DESIGN"));
  y += kHead;
  p.setFont(textFont(13));
  for (const auto& [name, value] : design()) {
    p.setPen(t.quiet);
    drawSymbol(p, QRectF(kPadding, y, 120, kLine), Qt::AlignLeft, name);
    p.setPen(t.ink);
    drawSymbol(p, QRectF(kPadding, y, right - kPadding, kLine), Qt::AlignRight, value);
    y += kLine;
  }
}

}  // namespace surefoot

#include "moc_condition_list.cpp"
