// SPDX-License-Identifier: GPL-3.0-or-later
// A small quiet button in a header, drawn as an icon; and the "?" that opens the handbook.
#pragma once

#include <QAbstractButton>

#include "ui/style/icons.h"
#include "ui/style/painted.h"

namespace surefoot {

class HeaderButton : public Painted<QAbstractButton> {
  Q_OBJECT

 public:
  static constexpr int kSide = 24;  ///< [px], with texts of the usual size

  /// `checked`: the icon while it is checked; the same: it cannot be.
  HeaderButton(Icon icon, Icon checked, QWidget* parent);
  QSize sizeHint() const override { return scaled({kSide, kSide}); }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  Icon icon_, checked_;
};

/// Opens the page of what is around it (ui/support/help.h).
class HelpButton final : public HeaderButton {
  Q_OBJECT

 public:
  /// `about`: what is explained, for the tooltip: "Value maps".
  explicit HelpButton(const QString& about, QWidget* parent = nullptr);
};

}  // namespace surefoot
