// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a window's texts can be read: none is cut, none lies over another.
#pragma once

#include <QString>
#include <vector>

class QWidget;

namespace surefoot {

/// Name of a widget for a message: its class and what it says of itself.
QString nameOf(const QWidget& widget);

/// Everything that cannot be read among all that is shown in a window; a sentence each.
std::vector<QString> unreadable(QWidget& window);

/// Makes a failure of every one of them. Where SUREFOOT_PICTURES names a folder, a picture is put there.
void expectReadable(QWidget& window, const QString& where);

}  // namespace surefoot
