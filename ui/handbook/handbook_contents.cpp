// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/handbook/handbook_contents.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/handbook/search.h"
#include "ui/controls/labels.h"
#include "ui/style/scale.h"
#include "ui/support/plain_text.h"

namespace surefoot {

HandbookContents::HandbookContents(const Handbook& handbook, QWidget* parent)
    : QWidget(parent),
      handbook_(handbook),
      field_(new QLineEdit),
      list_(new QTreeWidget),
      nothing_(makeText(tr("No page has all of these words."), 11, 400, true, nullptr)) {
  field_->setPlaceholderText(tr("Search"));
  field_->setAccessibleName(tr("Search the handbook"));
  field_->setClearButtonEnabled(true);
  list_->setAccessibleName(tr("Contents"));
  list_->setHeaderHidden(true);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setUniformRowHeights(true);
  list_->setTextElideMode(Qt::ElideRight);
  nothing_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->addWidget(field_);
  column->addWidget(nothing_);
  column->addWidget(list_, 1);
  whenScaled(this, [this, column] {
    column->setContentsMargins(scaled({12, 12, 0, 12}));
    column->setSpacing(scaled(8));
    field_->setFont(scaledFont(13));
    list_->setFont(scaledFont(13));
    list_->setIndentation(scaled(12));
    setMinimumWidth(scaled(180));
    fill();
  });
  field_->installEventFilter(this);
  connect(field_, &QLineEdit::textChanged, this, [this](const QString& words) {
    fill();
    Q_EMIT searched(words.trimmed());
  });
  const auto take = [this](const QTreeWidgetItem* item) {
    const QString page = item ? item->data(0, Qt::UserRole).toString() : QString();
    if (page.isEmpty() || page == page_) return;
    page_ = page;
    Q_EMIT chosen(page);
  };
  connect(list_, &QTreeWidget::currentItemChanged, this, [take](QTreeWidgetItem* item) { take(item); });
  connect(list_, &QTreeWidget::itemActivated, this, [this] { Q_EMIT left(); });
}

/// Without words, by sections; with words, the pages in which they stand, the nearest first.
void HandbookContents::fill() {
  const QSignalBlocker quiet(list_);
  list_->clear();
  const QString words = field_->text().trimmed();
  const auto row = [this](const HandbookPage& page) {
    auto* item = new QTreeWidgetItem({QString::fromStdString(page.title)});
    item->setToolTip(0, tipText(QString::fromStdString(page.section)));
    item->setData(0, Qt::UserRole, QString::fromStdString(page.name));
    return item;
  };
  QTreeWidgetItem* section = nullptr;
  const auto found = pagesWith(handbook_, words.toStdString());
  for (const HandbookPage* page : found) {
    if (!words.isEmpty()) {
      list_->addTopLevelItem(row(*page));
      continue;
    }
    const QString title = QString::fromStdString(page->section);
    if (!section || section->text(0) != title) {
      section = new QTreeWidgetItem(list_, {title});
      section->setFont(0, scaledFont(13, 500));
    }
    section->addChild(row(*page));
  }
  nothing_->setVisible(found.empty());
  list_->setVisible(!found.empty());
  choose(page_);
}

void HandbookContents::choose(const QString& page) {
  const QSignalBlocker quiet(list_);
  page_ = page;
  for (QTreeWidgetItemIterator item(list_); *item; ++item)
    if ((*item)->data(0, Qt::UserRole) == page && !page.isEmpty()) {
      list_->setCurrentItem(*item);
      return list_->scrollToItem(*item);
    }
  list_->setCurrentItem(nullptr);
}

void HandbookContents::startSearch() {
  field_->setFocus(Qt::ShortcutFocusReason);
  field_->selectAll();
}

void HandbookContents::search(const QString& words) {
  field_->setText(words);
}

QStringList HandbookContents::listed() const {
  QStringList pages;
  for (QTreeWidgetItemIterator item(list_); *item; ++item)
    if (const QString page = (*item)->data(0, Qt::UserRole).toString(); !page.isEmpty()) pages << page;
  return pages;
}

/// In the field: ↓ goes into the list, Return reads the first page, Escape forgets the words.
bool HandbookContents::eventFilter(QObject* watched, QEvent* event) {
  const bool override = event->type() == QEvent::ShortcutOverride;
  if (watched != field_ || (!override && event->type() != QEvent::KeyPress))
    return QWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (override) {
    if (key == Qt::Key_Escape && !field_->text().isEmpty()) event->accept();  // not the window's Escape
    return false;
  }
  if (key == Qt::Key_Down) {
    list_->setFocus(Qt::OtherFocusReason);
    if (!list_->currentItem()) list_->setCurrentItem(list_->topLevelItem(0));
    return true;
  }
  if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    const QStringList pages = listed();
    if (!field_->text().trimmed().isEmpty() && !pages.isEmpty()) Q_EMIT chosen(pages.front());
    Q_EMIT left();
    return true;
  }
  if (key != Qt::Key_Escape || field_->text().isEmpty()) return QWidget::eventFilter(watched, event);
  field_->clear();
  return true;
}

}  // namespace surefoot

#include "moc_handbook_contents.cpp"
