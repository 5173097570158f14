// SPDX-License-Identifier: GPL-3.0-or-later
// An option of a question: a radio button whose words go on in the next line. The chosen one lies on fill.
#pragma once

#include <QAbstractButton>

#include "ui/style/painted.h"

namespace surefoot {

class OptionButton final : public Painted<QAbstractButton> {
  Q_OBJECT

 public:
  explicit OptionButton(const QString& text, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent*) override;
};

}  // namespace surefoot
