// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QSettings>
#include <QTemporaryDir>

#include "ui/language/language.h"
#include "ui/style/theme.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const QTemporaryDir settings, data;  // never the settings, results and autosaves of whoever runs the tests
  const QByteArray platform = qgetenv("QT_QPA_PLATFORM");
  if (platform.isEmpty() || platform == "offscreen") {  // a screen as people have, not 800 × 800
    QFile screen(data.filePath("screen.json"));
    if (!screen.open(QIODevice::WriteOnly)) return 1;
    screen.write(R"({"screens": [{"name": "one", "x": 0, "y": 0, "width": 1920, "height": 1080,
                      "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1}]})");
    screen.close();
    qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + screen.fileName().toUtf8());
  }
  qputenv("XDG_DATA_HOME", data.path().toUtf8());
  QApplication application(argc, argv);
  QApplication::setApplicationName("Surefoot");
  QApplication::setOrganizationName("Surefoot");
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  // The tests are in English; with this, those of sizes (Readable) can be tried in another language.
  surefoot::useLanguage(application, qEnvironmentVariable("SUREFOOT_LANGUAGE", QStringLiteral("en")));
  surefoot::applyAppearance(application, surefoot::Appearance::Light);
  if (QFontDatabase::families().isEmpty()) {
    std::fprintf(stderr, "no font is installed: every text would be empty boxes\n");
    return 1;
  }
  return RUN_ALL_TESTS();
}
