// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/bar_button.h"

#include <QAction>
#include <QPainter>

#include "ui/style/theme.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {
constexpr int kButton = 32, kFramed = 80;  // [px]
}

BarButton::BarButton(Icon icon, Look look, const QString& tip, QWidget* parent)
    : Painted(parent),
      icon_(icon),
      look_(look) {
  setFocusPolicy(Qt::TabFocus);  // a click needs no focus ring
  whenScaled(this, [this] { setFixedSize(sizeHint()); });
  setTip(tip);
}

BarButton::BarButton(QAction* action, Icon icon, Look look, QWidget* parent) : BarButton(icon, look, {}, parent) {
  action_ = action;
  connect(this, &QAbstractButton::clicked, action, &QAction::trigger);
  connect(action, &QAction::changed, this, &BarButton::followAction);
  followAction();
}

QSize BarButton::sizeHint() const {
  return scaled({look_ == Look::Framed ? kFramed : kButton, kButton});
}

void BarButton::setIcon(Icon icon) {
  icon_ = icon;
  update();
}

void BarButton::setTip(const QString& tip) {
  setToolTip(tipText(tip));
  setAccessibleName(tip);
}

void BarButton::followAction() {
  setEnabled(action_->isEnabled());
  setText(action_->text().remove('&'));
  setAccessibleName(text());
  const QString shortcut = action_->shortcut().toString(QKeySequence::NativeText);
  const QString tip = action_->toolTip();
  setToolTip(tipText(shortcut.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, shortcut)));
  update();
}

void BarButton::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const QRectF frame = QRectF(rect()).adjusted(1, 1, -1, -1);
  const bool pressed = isDown() || (look_ == Look::Framed && action_ && action_->isChecked());
  QColor ink = isEnabled() ? t.ink : t.outline;
  p.setPen(Qt::NoPen);
  p.setBrush(Qt::NoBrush);
  if (look_ == Look::Main) {
    p.setBrush(isEnabled() ? t.ink : t.track);
    ink = t.panel;
  } else if (look_ == Look::Framed) {
    p.setPen(QPen(pressed ? t.ink : t.outline, pressed ? 1.75 : 1));
    if (pressed || underMouse()) p.setBrush(t.fill);
  } else if (underMouse()) {
    p.setBrush(t.fill);
  }
  p.drawRoundedRect(frame, 4, 4);
  if (hasFocus()) {
    p.setPen(QPen(t.accent, 2));
    p.setBrush(Qt::NoBrush);
    p.drawRoundedRect(frame, 4, 4);
  }
  if (look_ == Look::Framed) {
    drawIcon(p, icon_, QRectF(4, 0, 24, height()), ink);
    p.setFont(textFont(13, 500));
    p.setPen(ink);
    p.drawText(QRectF(28, 0, width() - 32, height()), Qt::AlignVCenter | Qt::AlignLeft, text());
  } else {
    drawIcon(p, icon_, rect(), ink);
  }
}

}  // namespace surefoot

#include "moc_bar_button.cpp"
