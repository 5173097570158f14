// SPDX-License-Identifier: GPL-3.0-or-later
// Which page of the handbook tells of a widget, and how one asks for it. By Qt's own event for links of help, so that
// a panel need not know who shows the handbook. Window's thread.
#pragma once

#include <QString>

class QWidget;

namespace surefoot {

/// The page of a widget and of all that is in it and has no other: "panel-maps".
void setHelpPage(QWidget& widget, const QString& page);

/// The page of the widget or of the nearest one around it; empty: there is none.
QString helpPageOf(const QWidget* widget);

/// Sends a QWhatsThisClickedEvent with the page's name to the widget and those around it, until one accepts it.
void askForHelp(QWidget& widget);

}  // namespace surefoot
