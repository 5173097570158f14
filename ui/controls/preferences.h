// SPDX-License-Identifier: GPL-3.0-or-later
// A person's preferences, kept from one start to the next, and the dialog that sets them. All changes but that of
// the language apply at once.
#pragma once

#include <QDialog>
#include <functional>

#include "ui/style/theme.h"

namespace surefoot {

struct Preferences {
  Appearance appearance = Appearance::System;
  bool reduceMotion = false;  ///< no trail, no flash, no gliding camera, replays stand still
  bool beginRunning = true;   ///< the window learns as soon as it is open
  int autosaveMinutes = 1;    ///< 1 … 60, between two copies on the disk
  double textSize = 1.0;      ///< 0.8 … 2.0, of everything (ui/scale.h)
  QString language;           ///< "nl"; empty: the system's. From the next start on
};

Preferences readPreferences();
void writePreferences(const Preferences& preferences);

/// The preference for reduced motion, without reading the disk.
bool reducedMotion();

class PreferencesDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit PreferencesDialog(QWidget* parent);

 Q_SIGNALS:
  void changed(const surefoot::Preferences& preferences);

 private:
  void change(const std::function<void(Preferences&)>& how);
};

}  // namespace surefoot
