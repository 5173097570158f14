// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/support/help.h"

#include <QCoreApplication>
#include <QVariant>
#include <QWhatsThisClickedEvent>
#include <QWidget>

namespace surefoot {

namespace {
constexpr const char* kHelpPage = "helpPage";
}

void setHelpPage(QWidget& widget, const QString& page) {
  widget.setProperty(kHelpPage, page);
}

QString helpPageOf(const QWidget* widget) {
  for (; widget; widget = widget->parentWidget())
    if (const QString page = widget->property(kHelpPage).toString(); !page.isEmpty()) return page;
  return {};
}

void askForHelp(QWidget& widget) {
  const QString page = helpPageOf(&widget);
  for (QWidget* w = &widget; w && !page.isEmpty(); w = w->parentWidget()) {
    QWhatsThisClickedEvent asked(page);
    asked.ignore();
    QCoreApplication::sendEvent(w, &asked);
    if (asked.isAccepted()) return;
  }
}

}  // namespace surefoot
