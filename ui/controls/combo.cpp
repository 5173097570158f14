// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/combo.h"

#include <QPixmap>
#include <QWheelEvent>

#include "ui/style/painted.h"
#include "ui/style/policy_look.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/plain_text.h"

namespace surefoot {

Combo::Combo(const QString& name, QWidget* parent) : QComboBox(parent) {
  setAccessibleName(name);
  setToolTip(tipText(name));
  setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard focus to the page
}

std::string Combo::chosen() const {
  return currentData().toString().toStdString();
}

void Combo::choose(const std::string& name) {
  if (const int item = findData(toText(name)); item >= 0) setCurrentIndex(item);
}

void Combo::setPolicyMarkers() {
  markers_ = true;
  setIconSize(scaled({16, 16}));
  for (int i = 0; i < count(); ++i) {
    QPixmap pixmap(scaled({32, 32}));
    pixmap.setDevicePixelRatio(2);
    pixmap.fill(Qt::transparent);
    ScaledPainter p(&pixmap);
    const Theme& t = themeOf(*this);
    drawMarker(p, {8, 8}, policyLook(itemData(i).toString().toStdString(), t), true);
    p.end();
    setItemIcon(i, pixmap);
  }
}

void Combo::changeEvent(QEvent* event) {
  QComboBox::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && markers_) setPolicyMarkers();
}

// A wheel that scrolls the form must not change a choice on its way.
void Combo::wheelEvent(QWheelEvent* event) {
  event->ignore();
}

}  // namespace surefoot

#include "moc_combo.cpp"
