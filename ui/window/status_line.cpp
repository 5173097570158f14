// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/status_line.h"

#include <QPainter>
#include <cmath>

#include "core/life/rule_of_thumb.h"
#include "core/text/text.h"
#include "ui/language/numbers.h"
#include "ui/running/running_life.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/counted.h"

namespace surefoot {

StatusLine::StatusLine(RunningLife& life, QWidget* parent) : Painted(parent), life_(life) {
  whenScaled(this, [this] { setFixedHeight(scaled(24)); });
  setAccessibleName(tr("State of the life"));
  connect(&life_, &RunningLife::valuesArrived, this, &StatusLine::refresh);
  connect(&life_, &RunningLife::stateChanged, this, &StatusLine::refresh);
  connect(&life_, &RunningLife::replaced, this, &StatusLine::refresh);
  refresh();
}

QStringList StatusLine::segments() {
  constexpr std::int64_t kLeastActions = 1000;
  const Numbers& s = life_.numbers();
  QStringList list;
  if (!std::isnan(s.simulatedSeconds))
    list << tr("%1 min simulated")
                .arg(localNumbers(s.simulatedSeconds < 6e4 ? fixedText(s.simulatedSeconds / 60, 2)
                                                           : countText(s.simulatedSeconds / 60)));
  list << stepsText(s.steps);
  const double speed = s.stepsPerSecond;
  if (life_.running() && speed > 0)
    list << (speed >= 1e5 ? tr("%1 M steps/s").arg(fixedNumber(speed / 1e6, 2))
                          : tr("%1 steps/s").arg(countNumber(speed)));
  const ValueSnapshot* v = life_.values();
  if (v && v->rule) {
    const RuleText rule = textOf(*v->rule);
    list << tr("n* %1 → rule-of-thumb threshold %2").arg(localNumbers(rule.transitions), localNumbers(rule.threshold));
  } else if (!life_.task().goalReward) {
    list << tr("rule-of-thumb threshold: not defined here");
  }
  if (v && !v->memory.empty() && v->memory[0].occupied && v->memory[0].slots > 0)
    list << tr("table %1 % full")
                .arg(fixedNumber(
                    100.0 * static_cast<double>(*v->memory[0].occupied) / static_cast<double>(v->memory[0].slots), 0));
  if (v && v->guarded > 0 && v->steps > 0)
    list << tr("the guardian acted in %1 % of the steps")
                .arg(fixedNumber(100.0 * static_cast<double>(v->guarded) / static_cast<double>(v->steps), 1));
  if (v && v->priceOfFall) list << tr("a fall costs %1 more").arg(countNumber(*v->priceOfFall));
  if (v && v->totals.rewinds > 0)
    list << counted(v->totals.rewinds, tr("%1 falls taken back", nullptr, forms(v->totals.rewinds)));
  cautious_ = -1;
  if (v && v->calibration && v->calibration->all.count >= kLeastActions) {
    const auto percent = [](double share) { return fixedNumber(100 * share, share < 0.0995 ? 1 : 0); };
    const auto& risk = *v->calibration;
    const auto verdict = risk.verdict();
    if (verdict == Calibration::Verdict::Errs) cautious_ = static_cast<int>(list.size());
    const QString words = verdict == Calibration::Verdict::Holds  ? tr("risk holds: %1 % said, %2 % fell")
                          : verdict == Calibration::Verdict::Errs ? tr("risk errs: %1 % said, %2 % fell")
                                                                  : tr("risk unclear: %1 % said, %2 % fell");
    list << words.arg(percent(risk.all.said), percent(risk.all.fell));
  }
  list << tr("seed %1").arg(life_.configuration().seed);
  if (const QString beginning = life_.beginning(); !beginning.isEmpty()) list << tr("began %1").arg(beginning);
  return list;
}

QString StatusLine::state() const {
  const ValueSnapshot* v = life_.values();
  QString text = v && v->endOfLearning > 0
                     ? tr("learning ended at episode %1").arg(countNumber(static_cast<double>(v->endOfLearning)))
                     : QString();
  if (v && v->walksSince) text = tr("walks since minute %1").arg(fixedNumber(*v->walksSince, 0));
  if (const auto apart = life_.snapshot().flewApart; apart > 0)
    text = counted(apart, tr("the robot flew apart %1 times", nullptr, forms(apart))) +
           (text.isEmpty() ? "" : "; " + text);
  if (life_.snapshot().finished)
    text = tr("the life is complete") + (text.isEmpty() ? "" : "; " + text);
  else if (!life_.running())
    text = (life_.file().followed ? tr("followed") : tr("paused")) + (text.isEmpty() ? "" : "; " + text);
  return text;
}

void StatusLine::say(const QString& left, const QString& right) {
  following_ = false;
  segments_ = {left};
  state_ = right;
  update();
}

void StatusLine::follow() {
  following_ = true;
  refresh();
}

void StatusLine::refresh() {
  if (!following_) return;
  const QStringList now = segments();
  const QString nowState = state();
  if (now == segments_ && nowState == state_) return;
  segments_ = now;
  state_ = nowState;
  update();
}

void StatusLine::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.fillRect(rect(), t.panel);
  p.fillRect(QRect(0, 0, width(), 1), t.hairline);
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  const double stateWidth = symbolWidth(p.font(), state_);
  drawSymbol(p, QRectF(0, 0, width() - 12, height()), Qt::AlignRight, state_);
  double x = 12;
  for (const QString& segment : segments_) {
    const double w = symbolWidth(p.font(), segment);
    if (x + w > width() - stateWidth - 32) break;
    if (x > 12) p.fillRect(QRectF(x - 12, 6, 1, 12), t.hairline);
    p.setPen(following_ && &segment - segments_.data() == cautious_ ? t.caution : t.quiet);
    drawSymbol(p, QRectF(x, 0, w, height()), Qt::AlignLeft, segment);
    x += w + 24;
  }
}

}  // namespace surefoot

#include "moc_status_line.cpp"
