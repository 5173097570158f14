// SPDX-License-Identifier: GPL-3.0-or-later
// What the tables of the Experiment page have in common: their looks, markers and verdicts in their cells, and columns
// that share the width.
#pragma once

#include <QStyledItemDelegate>
#include <QTableWidget>

#include "core/recipes/claim.h"

namespace surefoot {

/// Of a cell: its condition's name, the policy whose marker stands before the text, or a Verdict.
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
/// A cell; numbers stand at its right.
QTableWidgetItem* put(QTableWidget& table, int row, int column, const QString& text, bool strong = false,
                      bool left = false);
/// The columns take what they need and share the rest; the first gives way where there is too little.
void spreadColumns(QTableWidget& table);

/// "1.1 · 10⁻⁶", ".036", "1.0"; "–": there was no test.
QString pText(double p);
/// "✓ agrees" in words.
QString verdictText(Verdict verdict);

}  // namespace surefoot
