// SPDX-License-Identifier: GPL-3.0-or-later
// A dock with a header of our own: title, a quiet note, a "?", and a button that gives it the whole window and back.
#pragma once

#include <QDockWidget>

#include "ui/style/painted.h"

class QAbstractButton;

namespace surefoot {

/// A widget in a header that can make itself smaller.
class Folding {
 public:
  virtual ~Folding() = default;
  /// Makes the widget at most `room` wide [px], if it can.
  virtual void fold(int room) = 0;
};

/// The 32 px above a panel's content. Drawn, so that every panel's baseline is the same.
class PanelHeader final : public Painted<> {
  Q_OBJECT

 public:
  PanelHeader(const QString& title, bool canFill, QWidget* parent = nullptr);
  void setTitle(const QString& title);
  void setNote(const QString& note);
  const QString& note() const { return note_; }
  /// A "?" before the button, which opens this page of the handbook (ui/support/help.h).
  void setHelp(const QString& page);
  void setFull(bool full);
  /// A panel that floats is a window of its own: its header is the title bar, with a button to close it.
  void setFloating(bool floating);
  /// The world lies on paper, all else on the panel's colour.
  void setOnPaper(bool paper) { paper_ = paper; }
  /// Puts a small widget at the right end, before the button.
  void addWidget(QWidget* widget);
  bool hasWidget() const { return extra_ != nullptr; }
  /// Places that widget again at once; without it, when it has told of its new size and the events are handled.
  void layOutExtra() { resizeEvent(nullptr); }
  QSize sizeHint() const override { return scaled({100, usualHeight()}); }
  QSize minimumSizeHint() const override { return scaled({60, usualHeight()}); }

 Q_SIGNALS:
  void fullSizeAsked();
  void closeAsked();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override;

 private:
  static int usualHeight();
  double titleEnd() const;
  void orderTabs();

  QString title_, note_;
  QAbstractButton *button_ = nullptr, *close_ = nullptr, *help_ = nullptr;
  QWidget* extra_ = nullptr;
  bool paper_ = false, floating_ = false;
};

class Panel final : public QDockWidget {
  Q_OBJECT

 public:
  Panel(const QString& title, const QString& name, QWidget* content, bool canFill, QWidget* parent);
  PanelHeader& header() { return *header_; }
  /// Its content, to be exported; of a view that scrolls, all of it.
  QWidget* view() const;

 private:
  PanelHeader* header_;
};

}  // namespace surefoot
