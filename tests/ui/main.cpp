// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QFontDatabase>
#include <QSettings>
#include <QTemporaryDir>

#include "ui/theme.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QTemporaryDir settings, data;  // never the settings, results and autosaves of whoever runs the tests
  qputenv("XDG_DATA_HOME", data.path().toUtf8());
  QApplication application(argc, argv);
  QApplication::setApplicationName("Surefoot");
  QApplication::setOrganizationName("Surefoot");
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  surefoot::applyAppearance(application, surefoot::Appearance::Light);
  if (QFontDatabase::families().isEmpty()) {
    std::fprintf(stderr, "no font is installed: every text would be empty boxes\n");
    return 1;
  }
  return RUN_ALL_TESTS();
}
