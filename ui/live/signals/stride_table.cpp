// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/signals/stride_table.h"

#include <fmt/format.h>

#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <cmath>

#include "ui/controls/table_parts.h"
#include "ui/language/numbers.h"
#include "ui/live/signals/signals_shown.h"
#include "ui/running/looking.h"
#include "ui/style/theme.h"
#include "ui/support/keyboard.h"

namespace surefoot {

namespace {

/// The measures of a stride, with the decimals in which they are told.
struct StrideColumn {
  const char* title;
  const char* key;
  double (*value)(const Stride&);
  int decimals;
};
const StrideColumn kColumns[] = {
    {QT_TRANSLATE_NOOP("surefoot::StrideTable", "Begins s"), "begins", [](const Stride& s) { return s.begins; }, 2},
    {QT_TRANSLATE_NOOP("surefoot::StrideTable", "Length m"), "length", [](const Stride& s) { return s.length; }, 3},
    {QT_TRANSLATE_NOOP("surefoot::StrideTable", "Duration s"), "duration", [](const Stride& s) { return s.duration; },
     2},
    {QT_TRANSLATE_NOOP("surefoot::StrideTable", "Speed m/s"), "speed", [](const Stride& s) { return s.speed(); }, 2},
    {QT_TRANSLATE_NOOP("surefoot::StrideTable", "Energy J"), "energy", [](const Stride& s) { return s.energy; }, 1},
    {QT_TRANSLATE_NOOP("surefoot::StrideTable", "Energy a metre J/m"), "energy_a_metre",
     [](const Stride& s) { return s.perMetre(); }, 1},
    {QT_TRANSLATE_NOOP("surefoot::StrideTable", "Both feet down %"), "both_down",
     [](const Stride& s) { return 100 * s.bothDown; }, 0},
};

QString numberOr(double value, int decimals) {
  return std::isfinite(value) ? fixedNumber(value, decimals) : QStringLiteral("–");
}

}  // namespace

StrideTable::StrideTable(SignalsShown& shown, QWidget* parent) : QTableWidget(parent), shown_(shown) {
  QStringList heads{tr("Stride")};
  for (const StrideColumn& column : kColumns) heads << tr(column.title);
  setUpTable(*this, heads);
  setAccessibleName(tr("Strides"));
  setProperty(kRowsOnly, true);  // ← → belong to the replay
  shown_.watchedBy(*this);
  connect(&shown_, &SignalsShown::stridesChanged, this, &StrideTable::refresh);
  connect(&shown_, &SignalsShown::changed, this, &StrideTable::refresh);
  connect(this, &QTableWidget::itemSelectionChanged, this, [this] {
    if (filling_) return;
    const QList<QTableWidgetItem*> chosen = selectedItems();
    if (chosen.isEmpty()) return;
    const int row = chosen[0]->row();
    if (const auto stride = strideIn(row)) shown_.markStride(stride);
  });
}

void StrideTable::putStride(int row, const QString& name, const Stride& stride) {
  put(*this, row, 0, name, false, true);
  int column = 1;
  for (const StrideColumn& c : kColumns) put(*this, row, column++, numberOr(c.value(stride), c.decimals));
}

void StrideTable::putMean(int row, const QString& name, const std::vector<Stride>& strides) {
  put(*this, row, 0, name, true, true)->setFlags(Qt::ItemIsEnabled);
  int column = 1;
  for (const StrideColumn& c : kColumns) {
    std::vector<double> values;
    for (const Stride& s : strides) values.push_back(c.value(s));
    const Spread spread = spreadOf(values);
    QString text = numberOr(spread.mean, c.decimals);
    if (std::isfinite(spread.deviation)) text += QStringLiteral(" ± ") + numberOr(spread.deviation, c.decimals);
    if (column == 1) text.clear();
    put(*this, row, column++, text, true)->setFlags(Qt::ItemIsEnabled);
  }
}

/// The first's strides with their mean, then the second's with theirs.
std::optional<MarkedStride> StrideTable::strideIn(int row) const {
  auto at = static_cast<std::size_t>(row);
  if (at < shown_.strides().size()) return MarkedStride{at, false};
  at -= shown_.strides().size() + (shown_.strides().empty() ? 0 : 1);
  return at < shown_.secondStrides().size() ? std::optional(MarkedStride{at, true}) : std::nullopt;
}

void StrideTable::refresh() {
  filling_ = true;
  const bool two = !shown_.secondStrides().empty(), atEnd = !shown_.markedStride();
  int rows = 0, row = 0;
  for (const auto* strides : {&shown_.strides(), &shown_.secondStrides()})
    rows += strides->empty() ? 0 : static_cast<int>(strides->size()) + 1;
  setRowCount(rows);
  for (const auto* strides : {&shown_.strides(), &shown_.secondStrides()}) {
    const bool first = strides == &shown_.strides();
    for (std::size_t i = 0; i < strides->size(); ++i)
      putStride(row++, (first ? tr("%1") : tr("second %1")).arg(i + 1), (*strides)[i]);
    if (!strides->empty())
      putMean(row++,
              (!two    ? tr("mean of %1")
               : first ? tr("first, mean of %1")
                       : tr("second, mean of %1"))
                  .arg(strides->size()),
              *strides);
  }
  clearSelection();
  for (int i = 0; i < rows && shown_.markedStride(); ++i)
    if (strideIn(i) == shown_.markedStride()) selectRow(i);
  spreadColumns(*this);
  if (atEnd && row > 0) scrollToBottom();
  filling_ = false;
}

void StrideTable::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && shown_.markedStride()) {
    clearSelection();
    return shown_.markStride(std::nullopt);
  }
  if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right) return event->ignore();
  QTableWidget::keyPressEvent(event);
}

void StrideTable::paintEvent(QPaintEvent* event) {
  QTableWidget::paintEvent(event);
  if (rowCount() > 0) return;
  const auto& signals = shown_.table().signals();
  const bool walks =
      std::any_of(signals.begin(), signals.end(), [](const Signal& s) { return footOf(s) != Foot::None; });
  QPainter p(viewport());
  p.setFont(scaledFont(11));
  p.setPen(themeOf(*this).quiet);
  p.drawText(viewport()->rect().adjusted(12, 0, -12, 0), Qt::AlignCenter | Qt::TextWordWrap,
             walks || signals.empty() ? tr("Strides appear here: from one touch-down of the left foot to the next.")
                                      : tr("This robot has no left and right foot whose strides could be told."));
}

std::string StrideTable::asCsv() const {
  std::string csv = "q,stride";
  for (const StrideColumn& c : kColumns) csv += std::string(",") + c.key;
  csv += '\n';
  int which = 0;
  for (const auto* strides : {&shown_.strides(), &shown_.secondStrides()}) {
    ++which;
    for (std::size_t i = 0; i < strides->size(); ++i) {
      csv += fmt::format("{},{}", which, i + 1);
      for (const StrideColumn& c : kColumns) {
        const double value = c.value((*strides)[i]);
        csv += std::isfinite(value) ? fmt::format(",{:.6g}", value) : ",";
      }
      csv += '\n';
    }
  }
  return shown_.strides().empty() && shown_.secondStrides().empty() ? std::string() : csv;
}

}  // namespace surefoot

#include "moc_stride_table.cpp"
