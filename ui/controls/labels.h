// SPDX-License-Identifier: GPL-3.0-or-later
// Labels whose texts follow the text size. None of them reads its text as HTML.
#pragma once

#include <QLabel>

namespace surefoot {

/// "ε = 0.25", "× 1.5" and "Q(S, A)" stay on one line.
QString unbroken(QString text);

/// A text of so many pixels [at the usual text size]; `quiet`: in the colour of notes.
QLabel* makeText(const QString& text, int pixels, int weight, bool quiet, QWidget* parent);

/// A quiet line that ends in "…" where there is no room for all of it.
class OneLine final : public QLabel {
 public:
  OneLine(int pixels, QWidget* parent);
  QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// "YOUR PREDICTION": a head in small capitals.
QLabel* makeHead(const QString& text, QWidget* parent);

/// A number of falls, in the colour of falls in light and dark.
class FallLabel final : public QLabel {
 public:
  FallLabel(int pixels, int weight, QWidget* parent);

 protected:
  void changeEvent(QEvent* event) override;
};

}  // namespace surefoot
