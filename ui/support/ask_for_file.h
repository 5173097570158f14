// SPDX-License-Identifier: GPL-3.0-or-later
// File dialogs that do not stop the program. They begin in the folder that was chosen last.
#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace surefoot {

using WithPath = std::function<void(const QString& path)>;

void askForFile(QWidget* parent, const QString& title, const QString& filter, WithPath then);
/// The name gets the ending if it has none; a file that is there is asked for.
void askForNewFile(QWidget* parent, const QString& title, const QString& suggested, const QString& filter,
                   const QString& ending, WithPath then);
void askForFolder(QWidget* parent, const QString& title, WithPath then);

}  // namespace surefoot
