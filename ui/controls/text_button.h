// SPDX-License-Identifier: GPL-3.0-or-later
// A button with words, 32 px: filled with ink (the one that goes on), or framed.
#pragma once

#include <QAbstractButton>

#include "ui/style/painted.h"

namespace surefoot {

class TextButton final : public Painted<QAbstractButton> {
  Q_OBJECT

 public:
  enum class Look { Main, Framed };
  TextButton(const QString& text, Look look, QWidget* parent = nullptr);
  void setLook(Look look);
  /// A triangle before the words, as on Run.
  void setStarts(bool starts);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent*) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  Look look_;
  bool starts_ = false;
};

}  // namespace surefoot
