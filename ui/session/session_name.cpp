// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/session_name.h"

#include "ui/style/theme.h"

namespace surefoot {

namespace {
constexpr int kPixels = 11;
constexpr int kLetters = 24;  // longer names are cut
}  // namespace

SessionName::SessionName(QWidget* parent) : Painted(parent) {}

QString SessionName::text() const {
  return unsaved_ ? name_ + '*' : name_;
}

void SessionName::say(const QString& name, bool unsaved, const QString& tip) {
  name_ = name;
  unsaved_ = unsaved;
  setToolTip(tip);
  setAccessibleName(unsaved ? tr("Session %1, not saved").arg(name) : tr("Session %1").arg(name));
  update();
}

/// The width does not change with the name, so that the tabs stand still.
QSize SessionName::sizeHint() const {
  const QFontMetricsF metrics(textFont(kPixels));
  return scaled(
      QSize(static_cast<int>(metrics.averageCharWidth() * kLetters) + 16, static_cast<int>(metrics.height()) + 4));
}

void SessionName::paintEvent(QPaintEvent*) {
  ScaledPainter p(this);
  p.setFont(textFont(kPixels));
  p.setPen(themeOf(*this).quiet);
  const QFontMetricsF metrics(p.font());
  const double star = unsaved_ ? metrics.horizontalAdvance('*') : 0;
  const QString name = metrics.elidedText(name_, Qt::ElideMiddle, width() - 16 - star);
  p.drawText(QRectF(rect()).adjusted(0, 0, -16, 0), Qt::AlignRight | Qt::AlignVCenter, unsaved_ ? name + '*' : name);
}

}  // namespace surefoot

#include "moc_session_name.cpp"
