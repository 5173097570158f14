// SPDX-License-Identifier: GPL-3.0-or-later
// The context menu of a view: what it offers itself, and its picture and numbers as files or for the clipboard. It
// opens by the right button, by the Menu key and by Shift+F10.
#pragma once

#include <QObject>
#include <QPoint>
#include <functional>
#include <optional>
#include <string>

class QWidget;

namespace surefoot {

class ViewMenu final : public QObject {
  Q_OBJECT

 public:
  /// Belongs to the view. `csv` gives its numbers where the view is no CsvSource; empty: it has none, or none yet. A
  /// view that took no focus takes it by Tab from now on, with a ring that shows it.
  explicit ViewMenu(QWidget& view, std::function<std::string()> csv = {});

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void open(const QPoint& at);
  void copyPicture();
  void copyNumbers();
  void exportAs(const QString& ending);
  std::string numbers() const;
  bool hasNumbers() const;
  bool filterMouse(QEvent& event);

  QWidget& view_;
  std::function<std::string()> csv_;
  std::optional<QPoint> pressed_;  // the right button went down there; a drag is no question for a menu
};

}  // namespace surefoot
