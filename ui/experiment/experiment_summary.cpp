// SPDX-License-Identifier: GPL-3.0-or-later
// The finding in one sentence, and the number of lives, which can be changed without reading the plan.
#include <QRegularExpression>
#include <QSpinBox>
#include <QWheelEvent>
#include <cmath>

#include "ui/experiment/experiment_page.h"
#include "ui/experiment/figures/condition_name.h"
#include "ui/experiment/plan_editor.h"
#include "ui/language/numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/support/counted.h"

namespace surefoot {

namespace {

QString percent(double value) {
  return fixedNumber(std::abs(value), 0);
}

/// "(95 % interval 29 to 53 %)"; if falls became fewer, the smaller reduction comes first.
QString reductionText(const Interval& i) {
  if (!std::isfinite(i.low) || !std::isfinite(i.high)) return {};
  return ExperimentPage::tr(" (95 % interval %1 to %2 %)").arg(fixedNumber(-i.high, 0), fixedNumber(-i.low, 0));
}

const Finding* bestOf(const Findings& findings) {
  const Finding* best = nullptr;
  for (const Finding& f : findings.conditions)
    if (f.comparison && f.comparison->significant() && f.comparison->change.value < 0 &&
        (!best || f.comparison->change.value < best->comparison->change.value))
      best = &f;
  return best;
}

}  // namespace

QString summaryOf(const Experiment& experiment) {
  if (experiment.isOpening()) return ExperimentPage::tr("It is being opened …");
  if (!experiment.view()) return ExperimentPage::tr("The finding in one sentence appears here.");
  const Findings& findings = experiment.view()->findings;
  const Finding* best = bestOf(findings);
  if (!best)
    return findings.complete
               ? ExperimentPage::tr("No condition falls significantly less than its reference (p &lt; .01).")
               : ExperimentPage::tr("So far no condition falls significantly less than its reference (p &lt; .01).");
  const Interval& change = best->comparison->change;
  const QString soFar = experiment.isComplete(best->name)
                            ? QString()
                            : ExperimentPage::tr("So far (%1 of %2 lives) ", nullptr, forms(experiment.livesPlanned()))
                                  .arg(countNumber(experiment.livesShown()))
                                  .arg(countNumber(experiment.livesPlanned()));
  QString text = ExperimentPage::tr("%1<b>%2 falls %3 % less than %4</b>%5.")
                     .arg(soFar, shownName(best->name).toHtmlEscaped(), percent(change.value),
                          shownName(best->reference).toHtmlEscaped(), reductionText(change));
  if (const ThesisVerdict* thesis = experiment.thesisOn(best->name); thesis && thesis->says.ends_with('%'))
    text += ExperimentPage::tr(" The thesis reports %1.").arg(toText(thesis->says).toHtmlEscaped());
  if (best->betweenQFunctions)
    text += ExperimentPage::tr(" Q-functions carry %1 % of the variance.")
                .arg(fixedNumber(100 * best->betweenQFunctions->share, 0));
  return text;
}

std::string withLives(const std::string& plan, int lives) {
  static const QRegularExpression there(QStringLiteral("^([ \\t]*)lives[ \\t]*=[ \\t]*[0-9_]+"),
                                        QRegularExpression::MultilineOption);
  QString text = toText(plan);
  const QString line = QStringLiteral("lives = %1").arg(lives);
  const auto match = there.match(text);
  const auto table =
      text.indexOf(QRegularExpression(QStringLiteral("^[ \\t]*\\["), QRegularExpression::MultilineOption));
  if (match.hasMatch() && (table < 0 || match.capturedStart() < table))
    text.replace(match.capturedStart(), match.capturedLength(), match.captured(1) + line);
  else
    text.prepend(line + '\n');
  return text.toStdString();
}

namespace {

constexpr int kMostLives = 100'000;

/// The wheel leaves it alone: another number is another experiment.
class LivesBox final : public QSpinBox {
 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

}  // namespace

void ExperimentPage::askForLives() {
  lives_ = new LivesBox;
  lives_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  lives_->setAccessibleName(tr("Lives a condition"));
  lives_->setToolTip(
      tr("How many lives each condition lives; more make intervals narrower. Another number begins again, "
         "what was lived is kept."));
  lives_->setRange(1, kMostLives);
  lives_->setSuffix(tr(" lives"));
  lives_->setKeyboardTracking(false);
  connect(lives_, &QSpinBox::editingFinished, this, [this] { setLives(lives_->value()); });
}

/// A plan whose lives grow says itself how many there are: the box shows that, and takes no number.
void ExperimentPage::showLives() {
  const Plan* plan = experiment_.plan() ? &*experiment_.plan() : nullptr;
  const bool grows = plan && plan->growth;
  lives_->setEnabled(!experiment_.text().empty() && !experiment_.isOpening() && !grows);
  const QSignalBlocker quiet(lives_);
  lives_->setRange(grows ? 0 : 1, kMostLives);
  lives_->setSpecialValueText(!grows ? QString() : plan->growth.search ? tr("a search") : tr("until decided"));
  if (plan && !lives_->hasFocus()) lives_->setValue(grows ? 0 : plan->lives);
}

void ExperimentPage::setLives(int lives) {
  if (!experiment_.plan() || experiment_.text().empty() || experiment_.plan()->lives == lives) return;
  if (editor_->hasEdits()) {
    editor_->setText(toText(withLives(editor_->text().toStdString(), lives)));
    return Q_EMIT refused(
        tr("The plan has edits that are not used yet, so the number of lives is written there; Use "
           "this plan takes all of it."));
  }
  if (const Status s = experiment_.setText(withLives(experiment_.text(), lives)); !s)
    Q_EMIT refused(toText(s.error().message));
}

}  // namespace surefoot
