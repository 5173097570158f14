// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAccessible>
#include <QWidget>

namespace surefoot {

/// Says a sentence to a screen reader, at once.
inline void announce(QWidget& about, const QString& text) {
  about.setAccessibleDescription(text);
  QAccessibleEvent event(&about, QAccessible::Alert);
  QAccessible::updateAccessibility(&event);
}

}  // namespace surefoot
