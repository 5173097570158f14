// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/combo.h"

#include <QWheelEvent>

#include "ui/plain_text.h"

namespace surefoot {

Combo::Combo(const QString& name, QWidget* parent) : QComboBox(parent) {
  setAccessibleName(name);
  setToolTip(tipText(name));
  setFocusPolicy(Qt::TabFocus);  // one that is chosen by mouse leaves the keys to the page
}

// A wheel that scrolls the form must not change a choice on its way.
void Combo::wheelEvent(QWheelEvent* event) {
  event->ignore();
}

}  // namespace surefoot
