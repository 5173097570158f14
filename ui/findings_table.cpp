// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/findings_table.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <cmath>

#include "core/text.h"
#include "ui/experiment.h"
#include "ui/plain_text.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

namespace {

QString signedText(double value) {
  return (value > 0 ? QStringLiteral("+") : QString()) + toText(fixedText(value, std::abs(value) < 9.95 ? 1 : 0));
}

QString pText(double p) {
  if (std::isnan(p)) return QStringLiteral("–");
  if (p < 1e-10) return QStringLiteral("< 1e−10");
  if (p >= 0.001) return toText(fixedText(p, 3));
  return QString::number(p, 'e', 1).replace('-', QChar(0x2212));
}

/// "−45.0"; of no value "–".
QString changeText(const Interval& i) {
  return std::isfinite(i.value) ? signedText(i.value) : QStringLiteral("–");
}

/// "−55.1 … −32.0"; in place of per cent that are of nothing the difference, "+2.4 falls (+1.0 … +3.8)".
QString intervalText(const Comparison& c) {
  const auto range = [](const Interval& i) {
    return i.known() ? QStringLiteral("%1 … %2").arg(signedText(i.low), signedText(i.high)) : QStringLiteral("–");
  };
  if (std::isfinite(c.change.value)) return range(c.change);
  const QString falls = FindingsTable::tr("%1 falls").arg(changeText(c.difference));
  return c.difference.known() ? QStringLiteral("%1 (%2)").arg(falls, range(c.difference)) : falls;
}

QString plusMinus(const Interval& i, int decimals) {
  if (!std::isfinite(i.value)) return QStringLiteral("–");
  const QString value = toText(fixedText(i.value, decimals));
  return i.known() ? QStringLiteral("%1 ± %2").arg(value, toText(fixedText((i.high - i.low) / 2, decimals)))
                   : value;
}

void setUp(QTableWidget& table, const QStringList& heads) {
  table.setColumnCount(static_cast<int>(heads.size()));
  table.setHorizontalHeaderLabels(heads);
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(28);
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setShowGrid(false);
  table.setFrameShape(QFrame::NoFrame);
  table.setWordWrap(false);
  table.setTabKeyNavigation(false);
  table.horizontalHeader()->setHighlightSections(false);
  table.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table.horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table.horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
  table.horizontalHeader()->setFont(textFont(11, 500));
  table.horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void put(QTableWidget& table, int row, int column, const QString& text, bool strong = false, bool left = false) {
  auto* item = table.item(row, column);
  if (!item) table.setItem(row, column, item = new QTableWidgetItem);
  item->setText(text);
  item->setTextAlignment((left ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  item->setFont(textFont(13, strong ? 500 : 400));
}

}  // namespace

FindingsTable::FindingsTable(Experiment& experiment, QWidget* parent) : QTableWidget(parent), experiment_(experiment) {
  setAccessibleName(tr("Results"));
  setUp(*this, {tr("Condition"), tr("Lives"), tr("Falls ± 95 %"), tr("Change %"), tr("95 % interval"), tr("p ANOVA"),
                tr("p Holm"), tr("X"), tr("Time min")});
  connect(&experiment_, &Experiment::resultsChanged, this, &FindingsTable::refresh);
  connect(&experiment_, &Experiment::planChanged, this, &QTableWidget::clearSelection);
  connect(&experiment_, &Experiment::stateChanged, viewport(), qOverload<>(&QWidget::update));
  setToolTip(tr("The condition of the chosen row stands out in the figures; Escape lets go"));
  connect(this, &QTableWidget::itemSelectionChanged, this, [this] {
    const auto rows = selectedItems();
    experiment_.choose(rows.isEmpty() || !item(rows[0]->row(), 0) ? "" : item(rows[0]->row(), 0)->text().toStdString());
  });
}

void FindingsTable::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return clearSelection();
  QTableWidget::keyPressEvent(event);
}

void FindingsTable::paintEvent(QPaintEvent* event) {
  QTableWidget::paintEvent(event);
  if (rowCount() > 0) return;
  QPainter p(viewport());
  p.setPen(themeOf(*this).quiet);
  p.setFont(textFont(11));
  p.drawText(viewport()->rect(), Qt::AlignCenter, experiment_.whyNoResults());
}

void FindingsTable::refresh() {
  const auto& view = experiment_.view();
  const int selected = currentRow();
  setRowCount(view ? static_cast<int>(view->findings.conditions.size()) : 0);
  if (!view) return viewport()->update();
  int row = 0;
  for (const Finding& f : view->findings.conditions) {
    const bool strong = f.comparison && f.comparison->significant();
    put(*this, row, 0, toText(f.name), strong, true);
    item(row, 0)->setToolTip(tipText(toText(f.name)));
    QStringList warnings;
    for (const std::string& w : f.warnings) warnings << toText(w);
    put(*this, row, 1, QString::number(f.lives));
    put(*this, row, 2, f.lives > 0 ? plusMinus(f.falls, 1) : QString(), strong);
    if (!warnings.isEmpty()) item(row, 2)->setToolTip(tipText(warnings.join('\n')));
    const auto& c = f.comparison;
    put(*this, row, 3, c ? changeText(c->change) : QStringLiteral("–"), strong);
    put(*this, row, 4, c ? intervalText(*c) : QString());
    put(*this, row, 5, c ? pText(c->p()) : QString());
    put(*this, row, 6, c ? pText(c->holm) : QString());
    put(*this, row, 7, strong ? QStringLiteral("✕") : QString(), true);
    put(*this, row, 8,
        f.lives > 0 && std::isfinite(f.minutes.value) ? toText(fixedText(f.minutes.value, 2)) : QString());
    ++row;
  }
  if (selected < 0 && currentRow() >= 0) clearSelection();
}

ClaimsTable::ClaimsTable(Experiment& experiment, QWidget* parent) : QTableWidget(parent), experiment_(experiment) {
  setAccessibleName(tr("Claims of the thesis"));
  setUp(*this,
        {tr("Claim of the thesis"), tr("Thesis"), tr("Ours (95 % interval)"), tr("p"), tr("Verdict"), tr("Why")});
  connect(&experiment_, &Experiment::resultsChanged, this, &ClaimsTable::refresh);
}

void ClaimsTable::refresh() {
  const auto judgements = experiment_.judgements();
  setRowCount(static_cast<int>(judgements.size()));
  int row = 0;
  for (const Judgement& j : judgements) {
    const QString says = QStringLiteral("%1  %2").arg(toText(j.id), toText(j.says));
    put(*this, row, 0, says, false, true);
    item(row, 0)->setToolTip(tipText(says));
    // A change against the reference is in per cent; numbers of one row have one rounding.
    const bool percent = experiment_.isInPercent(j.id);
    const QString unit = percent ? QStringLiteral(" %") : QString();
    const double size = std::max(j.ours ? std::abs(*j.ours) : 0.0, j.high ? std::abs(*j.high) : 0.0);
    const int decimals = size < 1 ? 2 : size < 100 ? 1 : 0;
    const auto text = [&](double v) { return toText(fixedText(v, decimals)); };
    put(*this, row, 1,
        j.thesis.is_number()   ? toText(fixedText(j.thesis.get<double>(), 0)) + unit
        : j.thesis.is_string() ? toText(j.thesis.get<std::string>())
                               : QString());
    QString ours = j.ours ? text(*j.ours) + unit : QString();
    if (j.low && j.high) ours += QStringLiteral("  (%1 … %2)").arg(text(*j.low), text(*j.high));
    put(*this, row, 2, ours);
    put(*this, row, 3, j.p ? pText(*j.p) : QString());
    put(*this, row, 4, QString::fromLatin1(nameOf(j.verdict)), j.verdict == Verdict::Differs);
    const bool weak = j.verdict != Verdict::Agrees && j.p && *j.p >= 0.01 && percent;
    const QString why = j.note.empty() && weak ? tr("not significant (p ≥ .01)") : toText(j.note);
    put(*this, row, 5, why, false, true);
    item(row, 5)->setToolTip(tipText(why));
    ++row;
  }
}

}  // namespace surefoot
