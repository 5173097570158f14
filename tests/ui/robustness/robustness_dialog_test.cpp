// SPDX-License-Identifier: GPL-3.0-or-later
// Run › Robustness: the same numbers as without a window, and a map that can be read by keys.
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>

#include "core/files/read_file.h"
#include "tests/ui/window/size_setup.h"
#include "ui/live/signals/signals_bar.h"
#include "ui/robustness/robustness_dialog.h"
#include "ui/robustness/robustness_form.h"
#include "ui/robustness/robustness_map.h"

namespace surefoot {

namespace {

/// The dialog over a life that has learned for a while and stands still.
struct Asked : Window {
  Asked() : Window("epsilon-greedy") {
    session->life().setTurbo(true);
    session->life().setRunning(true);
    EXPECT_TRUE(waitFor([&] { return session->life().snapshot().totals.episodes > 300; }, 30'000));
    session->life().setRunning(false);
    for (QAction* action : window->findChildren<QAction*>())
      if (action->text() == QString::fromUtf8("Rob&ustness …")) action->trigger();
    dialog = window->findChild<RobustnessDialog*>();
    EXPECT_TRUE(dialog);
    map = dialog->findChild<RobustnessMap*>();
  }
  template <class W>
  W* in(const QString& name) {
    for (W* w : dialog->findChildren<W*>())
      if (w->accessibleName() == name) return w;
    ADD_FAILURE() << name.toStdString();
    return nullptr;
  }
  QPushButton* button(const QString& text) {
    for (auto* b : dialog->findChildren<QPushButton*>())
      if (b->text() == text) return b;
    ADD_FAILURE() << text.toStdString();
    return nullptr;
  }
  void ask(const QString& pushes, const QString& starts) {
    in<QLineEdit>("Pushes in newton seconds")->setText(pushes);
    in<QLineEdit>("Starts of every cell")->setText(starts);
    button("Try")->click();
  }
  bool answered() {
    return waitFor([&] { return !map->asCsv().empty() && button("Try"); }, 60'000);
  }
  /// What the life has learned, as a file.
  std::string saved(const QTemporaryDir& folder, const QString& name) {
    const QString path = folder.filePath(name);
    bool written = false;
    session->files().save(SavedAs::QFunction, path.toStdString(), [&](const Status& s) { written = bool(s); });
    EXPECT_TRUE(waitFor([&] { return written; }));
    return path.toStdString();
  }

  RobustnessDialog* dialog = nullptr;
  RobustnessMap* map = nullptr;
};

/// A table without its first column, the name of the file.
std::string withoutNames(const std::string& csv) {
  std::string rest;
  for (const QString& line : QString::fromStdString(csv).split('\n'))
    rest += line.mid(line.indexOf(',') + 1).toStdString() + "\n";
  return rest;
}

}  // namespace

TEST(RobustnessDialog, HasTheNumbersOfTheCommand) {
  Asked a;
  const QTemporaryDir folder;
  const std::string q = a.saved(folder, "q.safetensors"), csv = folder.filePath("r.csv").toStdString();
  a.dialog->findChild<RobustnessForm*>()->setSecond(QString::fromStdString(q));
  a.in<QLineEdit>("Parameters of the models")->setText("environment.friction=0;0.05");
  a.ask("0..0.1:3", "20");
  ASSERT_TRUE(a.answered());
  const std::string command = std::string(SUREFOOT_PROGRAM) + " robustness " + q + " " + q +
                              " --push 0..0.1:3 --scenario all --set 'environment.friction=0;0.05' --starts 20 --csv " +
                              csv + " >/dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const auto text = readText(csv);
  ASSERT_TRUE(text);
  EXPECT_EQ(withoutNames(a.map->asCsv()), withoutNames(*text));
}

TEST(RobustnessDialog, ShowsACommandForWhatIsAsked) {
  Asked a;
  a.in<QLineEdit>("Starts of every cell")->setText("7");
  QTest::keyClick(a.in<QLineEdit>("Pushes in newton seconds"), Qt::Key_Backspace);
  const QString command = a.in<QLabel>("The command that gives the same numbers")->text();
  EXPECT_TRUE(command.contains("surefoot robustness learned.safetensors --push")) << command.toStdString();
  EXPECT_TRUE(command.contains("--starts 7")) << command.toStdString();
}

TEST(RobustnessDialog, TheArrowKeysReadTheMap) {
  Asked a;
  a.ask("0;5", "10");
  ASSERT_TRUE(a.answered());
  a.map->setFocus(Qt::TabFocusReason);
  QTest::keyClick(a.map, Qt::Key_Right);
  QTest::keyClick(a.map, Qt::Key_Down);
  ASSERT_EQ(a.map->spoken().size(), 1);
  const QString spoken = a.map->spoken().front();
  EXPECT_TRUE(spoken.startsWith(QString::fromUtf8("1 Realistic, push 5 N s: 10 of 10 fell, 100 % (95 %: 72 … 100 %)")))
      << spoken.toStdString();
  EXPECT_EQ(a.map->accessibleDescription(), spoken);
}

TEST(RobustnessDialog, TellsWhatCannotBeAskedAndStops) {
  Asked a;
  a.ask("0..2", "10");
  const auto says = [&](const QString& words) {
    return a.waitFor([&] {
      for (const auto* label : a.dialog->findChildren<QLabel*>())
        if (label->text().contains(words)) return true;
      return false;
    });
  };
  EXPECT_TRUE(says("how many values"));
  EXPECT_TRUE(a.map->asCsv().empty());
  a.ask("0..0.2:50", "100000");
  EXPECT_TRUE(says("is done"));
  a.button("Stop")->click();
  EXPECT_TRUE(says("Stopped"));
  EXPECT_TRUE(a.waitFor([&] { return a.button("Try") != nullptr; }));
  EXPECT_TRUE(a.map->asCsv().empty());
}

// With a result: two maps of the most common size, and many rows.
TEST(RobustnessDialog, IsReadableAtEverySize) {
  const UsualLook usual;
  Asked a;
  const QTemporaryDir folder;
  a.dialog->findChild<RobustnessForm*>()->setSecond(QString::fromStdString(a.saved(folder, "other.safetensors")));
  a.ask("0..0.2:9", "10");
  ASSERT_TRUE(a.answered());
  const auto check = [&](const QString& what) {
    atEverySize({kScreens[3], kScreens[0], kScreens[2]}, [&](const Screen& screen, const QString& text) {
      applyTextSize(screen.text);
      a.dialog->resize(screen.size - QSize(16, 40));
      a.map->setFocus(Qt::TabFocusReason);
      QTest::keyClick(a.map, Qt::Key_Right);
      QTest::qWait(60);  // texts that wrap are laid out twice
      expectReadable(*a.dialog, "robustness " + what + ", " + text);
    });
  };
  check("of two");
  a.dialog->findChild<RobustnessForm*>()->setSecond({});
  a.in<QLineEdit>("Parameters of the models")->setText("environment.friction=0..0.1:4");
  const std::string before = a.map->asCsv();
  a.ask("0..0.2:30", "2");
  ASSERT_TRUE(a.waitFor([&] { return a.map->asCsv() != before; }, 60'000));
  check("of many models");
}

// A second Q-function is chosen once: in a roll-out or here.
TEST(RobustnessDialog, TheSecondIsThatOfTheSignalsAndTheOtherWay) {
  Asked w;
  const QTemporaryDir folder;
  const QString one = QString::fromStdString(w.saved(folder, "one.safetensors")),
                other = QString::fromStdString(w.saved(folder, "other.safetensors"));
  EXPECT_TRUE(w.dialog->findChild<RobustnessForm*>()->second().empty());
  Q_EMIT w.dialog->findChild<RobustnessForm*>()->secondChosen(one);
  ASSERT_TRUE(w.waitFor([&] { return w.session->looking().secondPath() == one; }));
  EXPECT_FALSE(w.session->looking().playback()) << "nothing is rolled out for it";
  w.dialog->close();
  w.window->findChild<SignalsBar*>()->setSecond(other);
  ASSERT_TRUE(w.waitFor([&] { return w.session->looking().secondPath() == other; }));
  for (QAction* action : w.window->findChildren<QAction*>())
    if (action->text() == QString::fromUtf8("Rob&ustness …")) action->trigger();
  const auto dialogs = w.window->findChildren<RobustnessDialog*>();
  const auto open = std::find_if(dialogs.begin(), dialogs.end(), [](const auto* d) { return d->isVisible(); });
  ASSERT_NE(open, dialogs.end());
  EXPECT_EQ((*open)->findChild<RobustnessForm*>()->second(), other.toStdString());
}

}  // namespace surefoot
