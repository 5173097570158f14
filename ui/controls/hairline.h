// SPDX-License-Identifier: GPL-3.0-or-later
// A line of one pixel between two parts of a page.
#pragma once

#include "ui/style/painted.h"
#include "ui/style/theme.h"

namespace surefoot {

class Hairline final : public Painted<> {
 public:
  explicit Hairline(Qt::Orientation orientation, QWidget* parent = nullptr) : Painted(parent) {
    orientation == Qt::Horizontal ? setFixedHeight(1) : setFixedWidth(1);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.fillRect(QWidget::rect(), themeOf(*this).hairline);
  }
};

}  // namespace surefoot
