// SPDX-License-Identifier: GPL-3.0-or-later
// The contents of the handbook by sections, and a field that leaves those pages in which words stand.
#pragma once

#include <QWidget>

#include "core/handbook/page.h"

class QLabel;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace surefoot {

class HandbookContents final : public QWidget {
  Q_OBJECT

 public:
  /// The handbook must outlive it.
  explicit HandbookContents(const Handbook& handbook, QWidget* parent = nullptr);
  /// Marks the page that is shown.
  void choose(const QString& page);
  /// The focus goes into the field, whose words are selected.
  void startSearch();
  void search(const QString& words);
  /// The pages that are listed now, in their order.
  QStringList listed() const;

 Q_SIGNALS:
  void chosen(const QString& page);
  void searched(const QString& words);
  /// Return or Escape: the page is to be read now.
  void left();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fill();

  const Handbook& handbook_;
  QLineEdit* field_;
  QTreeWidget* list_;
  QLabel* nothing_;
  QString page_;
};

}  // namespace surefoot
