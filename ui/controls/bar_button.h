// SPDX-License-Identifier: GPL-3.0-or-later
// A button of a toolbar, 32 px: filled with ink (the main one), framed with a text, or quiet.
#pragma once

#include <QAbstractButton>

#include "ui/style/icons.h"
#include "ui/style/painted.h"

class QAction;

namespace surefoot {

class BarButton final : public Painted<QAbstractButton> {
  Q_OBJECT

 public:
  enum class Look { Main, Quiet, Framed };
  BarButton(Icon icon, Look look, const QString& tip, QWidget* parent = nullptr);
  /// A button for an action, with the action's text.
  BarButton(QAction* action, Icon icon, Look look, QWidget* parent);
  void setIcon(Icon icon);
  void setTip(const QString& tip);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  void followAction();

  QAction* action_ = nullptr;
  Icon icon_;
  Look look_;
};

}  // namespace surefoot
