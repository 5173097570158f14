// SPDX-License-Identifier: GPL-3.0-or-later
// Panels beside each other; where there is no room for that, one at a time under tabs.
#pragma once

#include <QWidget>

class QSplitter;
class QTabBar;

namespace surefoot {

class LinkButton;

class PanelRow final : public QWidget {
  Q_OBJECT

 public:
  explicit PanelRow(QWidget* parent = nullptr);
  /// A panel, which is hidden until it is shown.
  void add(QWidget* panel, const QString& title);
  /// These and no others.
  void show(const QList<QWidget*>& panels);
  bool holds(const QWidget* panel) const;

 Q_SIGNALS:
  void fullSizeAsked(QWidget* panel);  ///< by the button beside the tabs; a header's own button speaks for itself

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void layOut();

  QTabBar* tabs_;
  LinkButton* full_;
  QSplitter* splitter_;
  QList<QWidget*> shown_;
};

}  // namespace surefoot
