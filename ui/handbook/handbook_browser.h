// SPDX-License-Identifier: GPL-3.0-or-later
// Shows pages of the handbook: by their names, in the colours and the text size of the window, with the way back.
#pragma once

#include <QTextBrowser>
#include <QTimer>

#include "core/handbook/page.h"

namespace surefoot {

class HandbookBrowser final : public QTextBrowser {
  Q_OBJECT

 public:
  /// `pictures`: the folder of the pictures that the pages show. The handbook must outlive the browser.
  HandbookBrowser(const Handbook& handbook, QString pictures, QWidget* parent = nullptr);
  /// The page that is shown: "first-steps".
  QString page() const { return source().path(); }
  /// "parameters-policy#policy.epsilon"; of a page that there is none of, the first.
  void open(const QString& page);
  /// Marks these words wherever they stand, on this page and on the next ones; empty: none.
  void mark(const QString& words);
  /// The next place of a text on the page, around its end; false: it stands nowhere.
  bool findNext(const QString& text, bool backward);

 protected:
  QVariant loadResource(int type, const QUrl& name) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  int pictureWidth() const;
  void fit();
  void readAgain();
  void showMarks();

  const Handbook& handbook_;
  QString pictures_, marked_;
  int width_ = 0;  // for which pictures were made
  QTimer again_;   // a page is not read anew while it is being read
};

}  // namespace surefoot
