// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/claims_table.h"

#include <QHeaderView>
#include <algorithm>
#include <cmath>

#include "ui/controls/table_parts.h"
#include "ui/experiment/experiment.h"
#include "ui/experiment/figures/condition_name.h"
#include "ui/language/numbers.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

/// A number with its interval; all numbers of a row are rounded to the same decimals.
QString oursText(const Judgement& j, const QString& unit) {
  const double size = std::max(j.ours ? std::abs(*j.ours) : 0.0, j.high ? std::abs(*j.high) : 0.0);
  const int decimals = size < 1 ? 2 : size < 100 ? 1 : 0;
  const auto text = [&](double v) { return std::isfinite(v) ? fixedNumber(v, decimals) : QStringLiteral("–"); };
  QString ours = j.ours ? text(*j.ours) + unit : QString();
  if (j.low && j.high && std::isfinite(*j.low) && std::isfinite(*j.high))
    ours += QStringLiteral(" (%1 … %2)").arg(text(*j.low), text(*j.high));
  return ours;
}

}  // namespace

ClaimsTable::ClaimsTable(Experiment& experiment, QWidget* parent) : QTableWidget(parent), experiment_(experiment) {
  setAccessibleName(tr("Claims of the thesis"));
  setUpTable(*this, {tr("Code"), tr("Claim of the thesis"), tr("Thesis"), tr("Ours (95 % interval)"), tr("p"),
                     tr("Verdict"), tr("Why")});
  setWordWrap(true);
  for (const int column : {Says, Thesis, Ours, VerdictIs, Why})
    horizontalHeaderItem(column)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  horizontalHeaderItem(Code)->setToolTip(
      tr("The claim's number in the recipe and in RESULTS.md: a letter for the topic, counted within it"));
  connect(&experiment_, &Experiment::resultsChanged, this, &ClaimsTable::refresh);
}

void ClaimsTable::resizeEvent(QResizeEvent* event) {
  QTableWidget::resizeEvent(event);
  layOut();
}

void ClaimsTable::showEvent(QShowEvent* event) {
  QTableWidget::showEvent(event);
  layOut();
}

/// Short columns get the width of their texts; columns of sentences share the rest and wrap.
void ClaimsTable::layOut() {
  int rest = viewport()->width();
  for (const int column : {Code, P, VerdictIs}) {
    const int need = std::max(sizeHintForColumn(column), horizontalHeader()->sectionSizeHint(column)) + scaled(8);
    setColumnWidth(column, need);
    rest -= need;
  }
  rest = std::max(rest, 40 * QFontMetrics(scaledFont(13)).averageCharWidth());
  for (const auto& [column, share] : {std::pair{Says, 0.36}, {Thesis, 0.14}, {Ours, 0.22}, {Why, 0.28}})
    setColumnWidth(column, static_cast<int>(share * rest));
  resizeRowsToContents();
}

void ClaimsTable::refresh() {
  const auto& judgements = experiment_.judgements();
  setRowCount(static_cast<int>(judgements.size()));
  int row = 0;
  for (const Judgement& j : judgements) {
    put(*this, row, Code, toText(j.id), false, true);
    put(*this, row, Says, shownName(j.says), false, true);
    // A change against the reference is in per cent.
    const bool percent = experiment_.isInPercent(j.id);
    const QString unit = percent ? QStringLiteral(" %") : QString();
    put(*this, row, Thesis,
        j.thesis.is_number() ? fixedNumber(j.thesis.get<double>(), 0) + unit +
                                   (j.thesisP ? tr(", p %1").arg(pText(*j.thesisP)) : QString())
        : j.thesis.is_string() ? shownName(j.thesis.get<std::string>())
                               : QString(),
        false, true);
    put(*this, row, Ours, oursText(j, unit), false, true);
    put(*this, row, P, j.p ? pText(*j.p) : QString());
    put(*this, row, VerdictIs, verdictText(j.verdict), j.verdict == Verdict::Differs, true)
        ->setData(kVerdictRole, static_cast<int>(j.verdict));
    const bool weak = j.verdict != Verdict::Agrees && j.p && *j.p >= 0.01 && percent;
    put(*this, row, Why, j.note.empty() && weak ? tr("not significant (p ≥ .01)") : shownName(j.note), false, true);
    ++row;
  }
  if (isVisible()) layOut();
}

}  // namespace surefoot

#include "moc_claims_table.cpp"
