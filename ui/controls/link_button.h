// SPDX-License-Identifier: GPL-3.0-or-later
// A quiet word in a panel's header that can be clicked; with a menu it has a chevron.
#pragma once

#include <QToolButton>

#include "ui/style/painted.h"

namespace surefoot {

class LinkButton final : public Painted<QToolButton> {
  Q_OBJECT

 public:
  explicit LinkButton(const QString& text, QWidget* parent = nullptr);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent*) override;
};

}  // namespace surefoot
