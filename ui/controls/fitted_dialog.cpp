// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/fitted_dialog.h"

#include <QDialog>
#include <QScreen>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/style/scale.h"

namespace surefoot {

namespace {
constexpr int kScreenEdge = 48;  // [px] of the screen kept clear: the title bar
}  // namespace

void fillDialog(QDialog& dialog, QWidget* body, QWidget* foot) {
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(body);
  auto* column = new QVBoxLayout(&dialog);
  column->setContentsMargins(1, 1, 1, 1);  // its outline
  column->setSpacing(0);
  column->addWidget(scroll, 1);
  if (foot) column->addWidget(foot);
  whenScaled(&dialog, [&dialog, body, foot, scroll] {
    const QSize room = dialog.screen()->availableGeometry().size() - QSize(kScreenEdge, kScreenEdge);
    QSize wanted = body->sizeHint();
    const QSize below = foot ? foot->sizeHint() : QSize(0, 0);
    wanted = {std::max(wanted.width(), below.width()), wanted.height() + below.height()};
    wanted += QSize(2, 2);
    wanted.rwidth() += scroll->style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    dialog.setMinimumSize(scaled({240, 120}).boundedTo(room));
    dialog.resize(wanted.boundedTo(room));
  });
}

}  // namespace surefoot
