// SPDX-License-Identifier: GPL-3.0-or-later
// What the tables of the Experiment page have in common: their looks, markers and verdicts in their cells, and columns
// that share the width.
#pragma once

#include <QStyledItemDelegate>
#include <QTableWidget>

#include "core/recipes/claim.h"

namespace surefoot {

/// Data of a cell: the name of its condition, the policy whose marker stands before the text, or a Verdict.
enum CellRole { kNameRole = Qt::UserRole, kPolicyRole, kVerdictRole };

/// Draws the marker or the verdict's sign before a cell's text.
class SignDelegate final : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

void setUpTable(QTableWidget& table, const QStringList& heads);
/// Writes a cell; its text stands at the right, or with `left` at the left.
QTableWidgetItem* put(QTableWidget& table, int row, int column, const QString& text, bool strong = false,
                      bool left = false);
/// Each column gets the width that its texts need; the rest is shared. If there is too little, the first is narrower.
void spreadColumns(QTableWidget& table);

/// "1.1 · 10⁻⁶", ".036", "1.0"; "–": there was no test.
QString pText(double p);
/// "✓ agrees" in words.
QString verdictText(Verdict verdict);

}  // namespace surefoot
