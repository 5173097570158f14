// SPDX-License-Identifier: GPL-3.0-or-later
// Settings that were damaged, written by another version or by hand: the window opens, on the screen, and works.
// SUREFOOT_SETTINGS is the number of tries, SUREFOOT_SETTINGS_SEED which ones.
#include <QComboBox>
#include <QFile>
#include <QScreen>
#include <QSettings>

#include "core/basics/random.h"
#include "tests/ui/window/size_setup.h"
#include "ui/controls/preferences.h"

namespace surefoot {

namespace {

class Damage {
 public:
  explicit Damage(std::uint64_t seed) : random_(seed) {}
  int below(int n) { return static_cast<int>(random_.uniform() * n); }

  /// Some bytes are others, are missing, or stand there twice; or a value is another one altogether.
  QByteArray done(QByteArray text) {
    for (int i = below(6); i >= 0 && !text.isEmpty(); --i) {
      const int at = below(static_cast<int>(text.size()));
      switch (below(5)) {
        case 0:
          text[at] = static_cast<char>(below(256));
          break;
        case 1:
          text.remove(at, below(40));
          break;
        case 2:
          text.insert(at, text.mid(below(static_cast<int>(text.size())), below(200)));
          break;
        case 3:
          text = replaced(std::move(text));
          break;
        default:
          text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
      }
    }
    return text;
  }

 private:
  QByteArray replaced(QByteArray text) {
    static const char* const kValues[] = {"",
                                          "-1",
                                          "1e308",
                                          "nan",
                                          "99999999999999999999",
                                          "@ByteArray()",
                                          "@ByteArray(\\x1\\xd9\\xd0\\xcb)",
                                          "@Invalid()",
                                          "@Size(1 1)",
                                          "a, b, c",
                                          "@Rect(0 0 -5 2147483647)",
                                          "@Variant(\\0\\0\\0\\x7f)"};
    QList<QByteArray> lines = text.split('\n');
    QByteArray& line = lines[below(static_cast<int>(lines.size()))];
    if (const auto equals = line.indexOf('='); equals > 0) line = line.left(equals + 1) + kValues[below(12)];
    return lines.join('\n');
  }

  Random random_;
};

int number(const char* name, int otherwise) {
  return qEnvironmentVariableIsSet(name) ? qEnvironmentVariableIntValue(name) : otherwise;
}

}  // namespace

TEST(Settings, WhateverStandsThereTheWindowOpensOnTheScreen) {
  const UsualLook usual;
  QByteArray good;
  const QString path = QSettings().fileName();
  {
    Window w;
    writePreferences({});
    QSettings().setValue("recent", QStringList{"/nowhere/a.surefoot", "/nowhere/b.surefoot"});
    QSettings().setValue("layouts/mine", QByteArray("\x01\x02"));
    w.window->close();
    QSettings().sync();
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    good = file.readAll();
    ASSERT_TRUE(good.contains("geometry") && good.contains("layout"));
  }
  Damage damage(static_cast<std::uint64_t>(number("SUREFOOT_SETTINGS_SEED", 1)));
  const Registry registry = fullRegistry();
  for (int i = number("SUREFOOT_SETTINGS", 20); i > 0; --i) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    file.write(damage.done(good));
    file.close();
    QSettings().sync();
    Session session(registry, pendulumConfiguration(registry, "trl"), false);
    MainWindow window(session);
    window.show();
    QTest::qWait(5);
    EXPECT_TRUE(window.screen()->availableGeometry().intersects(window.geometry()));
    EXPECT_LE(window.width(), window.screen()->availableGeometry().width());
    EXPECT_TRUE(textSize() >= kSmallestText && textSize() <= kLargestText);
    window.close();
  }
  QSettings().clear();
}

TEST(Preferences, TheLanguageIsKeptForTheNextStart) {
  const UsualLook usual;
  PreferencesDialog dialog(nullptr);
  auto* language = dialog.findChild<QComboBox*>();
  for (auto* combo : dialog.findChildren<QComboBox*>())
    if (combo->accessibleName() == "Language") language = combo;
  ASSERT_EQ(language->count(), 4);
  EXPECT_EQ(language->currentIndex(), 0) << "that of the system";
  language->setCurrentIndex(language->findText("Deutsch"));
  Q_EMIT language->activated(language->currentIndex());
  EXPECT_EQ(readPreferences().language.toStdString(), "de");
  EXPECT_EQ(dialog.windowTitle().toStdString(), "Preferences") << "what is shown does not change";
  QSettings().remove("language");
}

}  // namespace surefoot
