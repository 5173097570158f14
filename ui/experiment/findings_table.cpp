// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/findings_table.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "ui/controls/table_parts.h"
#include "ui/experiment/experiment.h"
#include "ui/experiment/figures/condition_name.h"
#include "ui/language/numbers.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {

QString signedText(double value) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  return (value > 0 ? QStringLiteral("+") : QString()) + fixedNumber(value, std::abs(value) < 9.95 ? 1 : 0);
}

bool known(const Interval& i) {
  return std::isfinite(i.low) && std::isfinite(i.high);
}

QString rangeText(const Interval& i) {
  return known(i) ? QStringLiteral("%1 … %2").arg(signedText(i.low), signedText(i.high)) : QStringLiteral("–");
}

/// The interval of the change. If there is no change in per cent: the difference, "+2.4 falls (+1.0 … +3.8)".
QString rangeText(const Comparison& c) {
  if (std::isfinite(c.change.value)) return rangeText(c.change);
  const QString falls = FindingsTable::tr("%1 falls").arg(signedText(c.difference.value));
  return known(c.difference) ? QStringLiteral("%1 (%2)").arg(falls, rangeText(c.difference)) : falls;
}

QString valueText(double value, int decimals) {
  return std::isfinite(value) ? fixedNumber(value, decimals) : QStringLiteral("–");
}

}  // namespace

FindingsTable::FindingsTable(Experiment& experiment, QWidget* parent) : QTableWidget(parent), experiment_(experiment) {
  setAccessibleName(tr("Results"));
  setUpTable(*this,
             {tr("Condition"), tr("Lives"), tr("Falls"), tr("± (95 %)"), tr("Change %"), tr("% (95 % interval)"),
              tr("p"), tr("p Holm"), tr("X"), tr("Time min"), tr("Expl. %"), tr("End %"), tr("Thesis"), tr("Verdict")});
  horizontalHeaderItem(VerdictIs)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  const std::pair<Column, QString> tips[] = {
      {Name, tr("pre(3): its lives began with what was learned on scenario 3")},
      {PlusMinus, tr("Half of the 95 % interval of the mean, in falls")},
      {ChangeIs, tr("Of the falls, against the reference")},
      {Range, tr("The 95 % interval of the change, in per cent")},
      {P, tr("This condition against its reference: by pairs of lives or Q-functions where both have the same, by the "
             "Q-functions where lives share them, else the one-way analysis of variance of the lives")},
      {Holm, tr("The same, corrected for all comparisons with this reference (Holm 1979)")},
      {Mark, tr("X: differs from the reference with p < .01")},
      {Time, tr("Simulated minutes until the end of learning; – for a task without a clock")},
      {Explored, tr("Share of actions that were not the best by the values at that moment: who explores less falls "
                    "less")},
      {GreedyEnd, tr("Of 100 episodes of the greedy policy at the end of a life, when nothing is learned any more, how "
                     "many fall")}};
  for (const auto& [column, tip] : tips) horizontalHeaderItem(column)->setToolTip(tipText(tip));
  connect(&experiment_, &Experiment::resultsChanged, this, &FindingsTable::refresh);
  connect(&experiment_, &Experiment::planChanged, this, &QTableWidget::clearSelection);
  connect(&experiment_, &Experiment::stateChanged, viewport(), qOverload<>(&QWidget::update));
  connect(&experiment_, &Experiment::chosenChanged, this, &FindingsTable::showChosen);
  setToolTip(tr("The condition of the chosen row stands out in the figures; Escape lets go"));
  connect(this, &QTableWidget::itemSelectionChanged, this, [this] {
    const auto rows = selectedItems();
    experiment_.choose(rows.isEmpty() || !item(rows[0]->row(), Name)
                           ? ""
                           : item(rows[0]->row(), Name)->data(kNameRole).toString().toStdString());
  });
}

void FindingsTable::showChosen() {
  const QSignalBlocker quiet(this);
  const QString chosen = toText(experiment_.chosen());
  if (chosen.isEmpty()) return clearSelection();
  for (int row = 0; row < rowCount(); ++row)
    if (item(row, Name)->data(kNameRole).toString() == chosen) selectRow(row);
}

void FindingsTable::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && !selectedItems().isEmpty()) return clearSelection();
  QTableWidget::keyPressEvent(event);
}

void FindingsTable::resizeEvent(QResizeEvent* event) {
  QTableWidget::resizeEvent(event);
  spreadColumns(*this);
  if (const auto rows = selectedItems(); !rows.isEmpty()) scrollToItem(rows[0]);
}

void FindingsTable::paintEvent(QPaintEvent* event) {
  QTableWidget::paintEvent(event);
  QPainter p(viewport());
  if (rowCount() > 0) {  // a last row that is cut would show half its numbers
    const int last = rowAt(viewport()->height() - 1);
    const int top = last < 0 ? 0 : rowViewportPosition(last);
    if (last > rowAt(0) && top + rowHeight(last) > viewport()->height())
      p.fillRect(QRect(0, top, viewport()->width(), viewport()->height() - top), palette().base());
    return;
  }
  p.setPen(themeOf(*this).quiet);
  p.setFont(scaledFont(11));
  p.drawText(viewport()->rect(), Qt::AlignCenter, experiment_.whyNoResults());
}

void FindingsTable::refresh() {
  const auto& view = experiment_.view();
  const int selected = currentRow();
  setRowCount(view ? static_cast<int>(view->findings.conditions.size()) : 0);
  if (!view) return viewport()->update();
  int row = 0;
  const auto& all = view->findings.conditions;
  for (const Finding& f : all) fillRow(row++, f);
  for (int i = 0; i < row; ++i)  // rows that are a reference for others say so
    if (const std::string& name = all[static_cast<std::size_t>(i)].name;
        std::any_of(all.begin(), all.end(), [&](const Finding& f) { return f.reference == name && f.name != name; }))
      item(i, Name)->setText(tr("%1 (reference)").arg(shownName(name)));
  bool thesis = false;
  for (int i = 0; i < rowCount(); ++i) thesis = thesis || !item(i, Thesis)->text().isEmpty();
  for (const auto& [column, measure] : {std::pair(Explored, &Finding::exploring), {GreedyEnd, &Finding::finalFalls}})
    setColumnHidden(column, std::none_of(all.begin(), all.end(),
                                         [&](const Finding& f) { return std::isfinite((f.*measure).value); }));
  setColumnHidden(Thesis, !thesis);
  setColumnHidden(VerdictIs, !thesis);
  spreadColumns(*this);
  if (selected < 0 && currentRow() >= 0) clearSelection();
}

void FindingsTable::fillRow(int row, const Finding& f) {
  const auto& c = f.comparison;
  const bool strong = c && c->significant();
  const bool soFar = !experiment_.isComplete(f.name);
  auto* name = put(*this, row, Name, shownName(f.name), strong, true);
  name->setData(kNameRole, toText(f.name));
  name->setData(kPolicyRole, toText(experiment_.policyOf(f.name)));
  name->setToolTip(tipText(shownName(f.name)));
  auto* lives = put(*this, row, Lives, countNumber(f.lives));
  lives->setData(Qt::ForegroundRole, soFar ? QVariant(QBrush(themeOf(*this).caution)) : QVariant());
  lives->setToolTip(
      tipText(soFar ? tr("So far: not all lives of this condition, or of what it is compared with") : QString()));
  QStringList warnings;
  for (const std::string& w : f.warnings) warnings << toText(w);
  put(*this, row, Falls, f.lives > 0 ? valueText(f.falls.value, 1) : QString(), strong)
      ->setToolTip(tipText(warnings.join('\n')));
  const bool interval = f.lives > 0 && known(f.falls);
  put(*this, row, PlusMinus,
      interval      ? QStringLiteral("± ") + valueText((f.falls.high - f.falls.low) / 2, 1)
      : f.lives > 0 ? QStringLiteral("–")
                    : QString());
  put(*this, row, ChangeIs, c ? signedText(c->change.value) : QStringLiteral("–"), strong);
  put(*this, row, Range, c ? rangeText(*c) : QString());
  put(*this, row, P, c ? pText(c->p()) : QString());
  put(*this, row, Holm, c ? pText(c->holm) : QString());
  put(*this, row, Mark, strong ? soFar ? tr("✕ so far") : QStringLiteral("✕") : QString(), true);
  put(*this, row, Time,
      f.lives > 0 && std::isfinite(f.minutes.value) ? valueText(f.minutes.value, 2)
      : f.lives > 0                                 ? QStringLiteral("–")
                                                    : QString());
  put(*this, row, Explored, valueText(100 * f.exploring.value, 1));
  put(*this, row, GreedyEnd, valueText(100 * f.finalFalls.value, 1));
  const ThesisVerdict* thesis = experiment_.thesisOn(f.name);
  put(*this, row, Thesis, thesis ? toText(thesis->says) : QString());
  auto* verdict = put(*this, row, VerdictIs, QString(), false, true);
  verdict->setData(kVerdictRole, thesis ? QVariant(static_cast<int>(thesis->verdict)) : QVariant());
  if (!thesis) return;
  verdict->setText(soFar ? tr("%1 so far").arg(verdictText(thesis->verdict)) : verdictText(thesis->verdict));
  QStringList claims;
  for (const std::string& id : thesis->claims) claims << toText(id);
  verdict->setToolTip(tipText(tr("Claims %1 of the thesis; all of them stand under \"The thesis's claims\"")
                                  .arg(claims.join(QStringLiteral(", ")))));
}

}  // namespace surefoot

#include "moc_findings_table.cpp"
