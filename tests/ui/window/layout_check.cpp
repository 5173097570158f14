// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window/layout_check.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QStyle>
#include <QTabBar>
#include <QTableView>
#include <QTest>
#include <QTreeView>

#include "tests/ui/window/text_recorder.h"
#include "ui/controls/labels.h"
#include "ui/style/scale.h"

namespace surefoot {

namespace {

/// Words, how wide they are where they stand, and how wide they must be.
struct Need {
  QString text;
  int has = 0, needs = 0;
};

void addLabel(const QLabel& label, std::vector<Need>& needs) {
  if (label.text().isEmpty()) return;
  const bool wraps = label.wordWrap();
  const bool elided = dynamic_cast<const OneLine*>(&label) != nullptr;
  if (!wraps && !elided) needs.push_back({label.text(), label.width(), label.sizeHint().width()});
  needs.push_back(
      {label.text(), label.height() + 1, wraps ? label.heightForWidth(label.width()) : label.sizeHint().height()});
}

void addField(const QLineEdit& field, std::vector<Need>& needs) {
  const QString text = field.text().isEmpty() ? field.placeholderText() : field.text();
  const int edges = field.width() - field.style()->subElementRect(QStyle::SE_LineEditContents, nullptr, &field).width();
  needs.push_back({text, field.width(), field.fontMetrics().horizontalAdvance(text) + std::min(edges, 4)});
}

void addCombo(const QComboBox& combo, std::vector<Need>& needs) {
  if (combo.isEditable()) return;
  const int icon = combo.itemIcon(combo.currentIndex()).isNull() ? 0 : combo.iconSize().width() + 4;
  needs.push_back({combo.currentText(), combo.width(),
                   combo.fontMetrics().horizontalAdvance(combo.currentText()) + icon + scaled(30)});
}

void addHeads(const QHeaderView& heads, std::vector<Need>& needs) {
  if (heads.orientation() != Qt::Horizontal) return;
  for (int i = 0; i < heads.count(); ++i) {
    const QString text = heads.model()->headerData(i, Qt::Horizontal).toString();
    if (!heads.isSectionHidden(i) && !text.isEmpty())
      needs.push_back({text, heads.sectionSize(i), QFontMetrics(heads.font()).horizontalAdvance(text) + scaled(8)});
  }
}

/// Cells of a table; of its first column a tooltip says all.
void addCells(const QTableView& table, std::vector<Need>& needs) {
  const int margins = 2 * (table.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &table) + 1);
  if (table.wordWrap()) return;
  for (int row = 0; row < std::min(20, table.model()->rowCount()); ++row)
    for (int column = 1; column < table.model()->columnCount(); ++column) {
      const QModelIndex cell = table.model()->index(row, column);
      const QVariant font = cell.data(Qt::FontRole);
      const QFontMetrics metrics(font.isValid() ? font.value<QFont>() : table.font());
      if (const QString text = cell.data().toString(); !text.isEmpty() && !table.isColumnHidden(column))
        needs.push_back({text, table.columnWidth(column), metrics.horizontalAdvance(text) + margins});
    }
}

/// A standard widget's words.
std::vector<Need> needsOf(const QWidget& w) {
  std::vector<Need> needs;
  if (const auto* label = qobject_cast<const QLabel*>(&w)) addLabel(*label, needs);
  if (const auto* field = qobject_cast<const QLineEdit*>(&w)) addField(*field, needs);
  if (const auto* combo = qobject_cast<const QComboBox*>(&w)) addCombo(*combo, needs);
  if (const auto* table = qobject_cast<const QTableView*>(&w)) addCells(*table, needs);
  if (const auto* heads = qobject_cast<const QHeaderView*>(&w)) addHeads(*heads, needs);
  if (const auto* button = qobject_cast<const QAbstractButton*>(&w); button && !button->text().isEmpty())
    needs.push_back({button->text(), button->width(), button->minimumSizeHint().width()});
  if (const auto* tabs = qobject_cast<const QTabBar*>(&w))
    for (int i = 0; i < tabs->count(); ++i)
      needs.push_back(
          {tabs->tabText(i), tabs->tabRect(i).width(), tabs->fontMetrics().horizontalAdvance(tabs->tabText(i))});
  if (const QSize least = w.minimumSizeHint(); !w.isWindow() && w.parentWidget()->layout()) {
    needs.push_back({QStringLiteral("as wide as it must be"), w.width(), least.width()});
    needs.push_back({QStringLiteral("as high as it must be"), w.height(), least.height()});
  }
  return needs;
}

/// Whether a parent lays its children over each other, or beyond its edges, on purpose.
bool overlaysChildren(const QWidget& parent) {
  const bool viewport = parent.parentWidget() && qobject_cast<const QAbstractScrollArea*>(parent.parentWidget());
  return viewport || qobject_cast<const QStackedWidget*>(&parent) || qobject_cast<const QSplitter*>(&parent) ||
         qobject_cast<const QAbstractScrollArea*>(&parent) || parent.inherits("QMainWindow") ||
         parent.inherits("QComboBoxPrivateContainer") || qobject_cast<const QTabBar*>(&parent) ||
         qobject_cast<const QMenuBar*>(&parent) || qobject_cast<const QLineEdit*>(&parent);
}

void checkChildren(const QWidget& parent, std::vector<QString>& wrong) {
  QList<QWidget*> shown;
  for (QWidget* child : parent.findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
    if (child->isVisible() && !child->isWindow() && !child->size().isEmpty()) shown << child;
  for (qsizetype i = 0; i < shown.size(); ++i) {
    if (!parent.rect().contains(shown[i]->geometry()))
      wrong.push_back(QStringLiteral("%1 leaves %2").arg(nameOf(*shown[i]), nameOf(parent)));
    for (qsizetype j = 0; j < i; ++j) {
      const QRect both = shown[i]->geometry() & shown[j]->geometry();
      if (both.width() > 1 && both.height() > 1)
        wrong.push_back(QStringLiteral("%1 lies over %2").arg(nameOf(*shown[i]), nameOf(*shown[j])));
    }
  }
}

}  // namespace

QString nameOf(const QWidget& w) {
  return QStringLiteral("%1 \"%2\"").arg(w.metaObject()->className(), w.accessibleName());
}

std::vector<QString> unreadable(QWidget& window) {
  std::vector<QString> wrong;
  QList<QWidget*> widgets = window.findChildren<QWidget*>();
  widgets.prepend(&window);
  for (QWidget* w : widgets) {
    if (!w->isVisible() || w->size().isEmpty() || w->window() != &window) continue;
    const QWidget* parent = w->parentWidget();  // Qt puts tabs that it does not need beside the page
    if (parent && parent->inherits("QMainWindow") && !parent->rect().intersects(w->geometry())) continue;
    for (const Need& need : needsOf(*w))
      if (need.has < need.needs)
        wrong.push_back(
            QStringLiteral("%1: \"%2\" has %3 px of %4").arg(nameOf(*w), need.text).arg(need.has).arg(need.needs));
    auto* area = qobject_cast<QAbstractScrollArea*>(w);
    if (QString(w->metaObject()->className()).startsWith("surefoot::") && !w->isWindow())
      for (const QString& text : cutOrOverlapping(area ? *area->viewport() : *w, area))
        wrong.push_back(nameOf(*w) + ": " + text);
    if (!overlaysChildren(*w)) checkChildren(*w, wrong);
  }
  return wrong;
}

void expectReadable(QWidget& window, const QString& where) {
  std::vector<QString> wrong;  // what changed just now may be laid out by events that are still to come
  const bool readable = QTest::qWaitFor([&] { return (wrong = unreadable(window)).empty(); }, 2000);
  if (const QString folder = qEnvironmentVariable("SUREFOOT_PICTURES"); !folder.isEmpty())
    window.grab().save(folder + '/' + where + QStringLiteral(".png"));
  if (readable) return;
  for (const QString& text : wrong) ADD_FAILURE() << where.toStdString() << ": " << text.toStdString();
}

}  // namespace surefoot
