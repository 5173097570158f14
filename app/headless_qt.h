// SPDX-License-Identifier: GPL-3.0-or-later
// Qt for commands that paint and show nothing: it needs no display.
#pragma once

#include <QApplication>

#include "ui/language/language.h"
#include "ui/style/theme.h"

namespace surefoot {

/// One at a time.
class HeadlessQt {
 public:
  /// Pictures are in English, whatever the system's language.
  HeadlessQt() {
    useLanguage(qt_, QStringLiteral("en"));
    applyAppearance(qt_, Appearance::Light);
  }

 private:
  /// Before the application is made.
  static int& prepared(int& arguments) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});  // no remarks on the platform
    return arguments;
  }

  int argc_ = 1;
  char name_[9] = "surefoot";
  char* argv_[2] = {name_, nullptr};
  QApplication qt_{prepared(argc_), argv_};
};

}  // namespace surefoot
