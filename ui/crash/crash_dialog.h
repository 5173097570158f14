// SPDX-License-Identifier: GPL-3.0-or-later
// The report of the last crash: read, copied, deleted. Nothing is sent from here.
#pragma once

#include <QDialog>

namespace surefoot {

class CrashDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `file`: the report. The dialog deletes itself when it is closed.
  explicit CrashDialog(const QString& file, QWidget* parent = nullptr);
};

}  // namespace surefoot
