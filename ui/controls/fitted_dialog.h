// SPDX-License-Identifier: GPL-3.0-or-later
// Dialogs that fit every screen.
#pragma once

class QDialog;
class QWidget;

namespace surefoot {

/// Fills a dialog: as large as `body` and `foot` ask for where the screen has the room, else `body` scrolls. `foot`, a
/// row of buttons or nullptr, always stands below it.
void fillDialog(QDialog& dialog, QWidget* body, QWidget* foot = nullptr);

}  // namespace surefoot
