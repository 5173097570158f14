// SPDX-License-Identifier: GPL-3.0-or-later
// The handbook in a window of its own, beside the program's: contents with a search, the page, the way back and
// forward, and a line to find words on the page. Everything by keys: Ctrl+L searches, Ctrl+F finds, Alt+← goes back.
#pragma once

#include <QWidget>

#include "core/handbook/page.h"

class QLineEdit;
class QToolButton;

namespace surefoot {

class HandbookBrowser;
class HandbookContents;

class HandbookWindow final : public QWidget {
  Q_OBJECT

 public:
  HandbookWindow(Handbook handbook, const QString& pictures, QWidget* parent);
  /// Shows a page, "panel-maps" or "parameters-policy#policy.epsilon", and comes to the front.
  void open(const QString& page);
  HandbookBrowser& browser() { return *browser_; }
  HandbookContents& contents() { return *contents_; }

 Q_SIGNALS:
  /// Ctrl+ +, − and 0: by so many steps; 0: the usual size.
  void textSizeAsked(int steps);

 private:
  QWidget* makeBar();
  QWidget* makeFind();
  void addKeys();
  void showFind(bool shown);
  void find(bool backward);

  const Handbook handbook_;
  HandbookContents* contents_;
  HandbookBrowser* browser_;
  QLineEdit* find_ = nullptr;
};

}  // namespace surefoot
