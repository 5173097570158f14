// SPDX-License-Identifier: GPL-3.0-or-later
// The context menu of a view: the view's own entries, and its picture and numbers as files or for the clipboard. It
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
  /// Belongs to the view. If it is no CsvSource, `csv` gives its numbers; empty: no numbers (yet). A view that
  /// could not have the focus can now get it by Tab, and shows a ring then.
  explicit ViewMenu(QWidget& view, std::function<std::string()> csv = {});
  /// Asks for a file and writes the view to it: png, svg, pdf or csv.
  void exportAs(const QString& ending);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void open(const QPoint& at);
  void copyPicture();
  void copyNumbers();
  std::string numbers() const;
  bool hasNumbers() const;
  bool filterMouse(QEvent& event);

  QWidget& view_;
  std::function<std::string()> csv_;
  std::optional<QPoint> pressed_;  // where the right button went down; after a drag no menu opens
};

}  // namespace surefoot
