// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robot/robot_page.h"

#include <QAbstractButton>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QToolTip>

#include "core/environment_library.h"
#include "core/files/read_file.h"
#include "core/files/whole_file.h"
#include "tests/ui/window_setup.h"
#include "ui/robot/random_life.h"
#include "ui/robot/robot_help.h"
#include "ui/robot/robot_picture.h"
#include "ui/robot/robot_text.h"
#include "ui/robot/state_table.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

const QString kRobots = QStringLiteral(SUREFOOT_SOURCE) + QStringLiteral("/resources/robots/");

/// The Robot page with a copy of the hopper, and a folder of its own for drafts.
struct RobotWindow : Window {
  explicit RobotWindow(const QString& change = {}, const QString& to = {})
      : page((registry.files->setShelf(kRobots.toStdString()), registry), folder.path()) {
    path = folder.filePath("mine.toml");
    QString text = toText(*readText((kRobots + "hopper.toml").toStdString()));
    if (!change.isEmpty()) text.replace(change, to);
    EXPECT_TRUE(writeWhole("robot", path.toStdString(), text.toStdString()));
    page.resize(1280, 720);
    page.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&page));
    page.open(path);
    EXPECT_TRUE(settled());
  }
  RobotText& text() { return *page.findChild<RobotText*>(); }
  bool settled() {
    return waitFor([&] { return !page.isChecking(); });
  }
  bool has(const QString& words) { return find(words) != nullptr; }
  QAbstractButton* button(const QString& words) {
    EXPECT_TRUE(has(words)) << words.toStdString();
    return find(words);
  }
  QAbstractButton* find(const QString& words) {
    for (auto* b : page.findChildren<QAbstractButton*>())
      if (b->text() == words) return b;
    return nullptr;
  }

  QTemporaryDir folder;
  QString path;
  RobotPage page;
};

void press(QWidget& widget, int key, Qt::KeyboardModifiers with = Qt::NoModifier) {
  QTest::keyClick(&widget, static_cast<Qt::Key>(key), with);
}

}  // namespace

TEST(RobotPage, AMistakeIsToldUnderItsLineAndMendedByAKey) {
  RobotWindow w("\"thigh\", \"foot\"", "\"thigh\", \"foott\"");
  ASSERT_EQ(w.text().complaints().size(), 1u);
  const int line = w.text().complaints()[0].at.line;
  EXPECT_FALSE(w.button("Let it learn")->isEnabled());
  press(w.text(), Qt::Key_F8);
  EXPECT_EQ(w.text().textCursor().blockNumber() + 1, line);
  press(w.text(), Qt::Key_Return, Qt::AltModifier);
  ASSERT_TRUE(w.settled());
  EXPECT_TRUE(w.text().complaints().empty());
  EXPECT_TRUE(w.text().toPlainText().contains("[\"thigh\", \"foot\"]"));
  EXPECT_TRUE(w.button("Let it learn")->isEnabled());
  EXPECT_TRUE(w.page.isEdited());
  w.text().undo();
  EXPECT_FALSE(w.page.isEdited()) << "it is one step";
}

TEST(RobotPage, WhileTheTextIsWrongTheLastRobotIsShown) {
  RobotWindow w;
  auto* table = w.page.findChild<StateTable*>();
  const int height = table->sizeHint().height();
  w.text().moveCursor(QTextCursor::End);
  w.text().insertPlainText("\nwhat = 1\n");
  ASSERT_TRUE(w.settled());
  EXPECT_FALSE(w.text().complaints().empty());
  EXPECT_EQ(table->sizeHint().height(), height);
  EXPECT_TRUE(w.button("Try")->isEnabled());
}

TEST(RobotPage, AProposedRangeWritesItselfIntoItsLine) {
  RobotWindow w("range = [-0.8, 0.8]\nwidth = 0.3", "range = [-0.2, 0.2]\nwidth = 0.3");
  auto* table = w.page.findChild<StateTable*>();
  press(*table, Qt::Key_Down), press(*table, Qt::Key_Down), press(*table, Qt::Key_Down);  // the leg's angle
  const int line = w.text().textCursor().blockNumber();
  EXPECT_TRUE(w.text().document()->findBlockByNumber(line).text().contains("range = [-0.2, 0.2]"));
  press(*table, Qt::Key_Return);
  ASSERT_TRUE(w.settled());
  EXPECT_TRUE(w.text().document()->findBlockByNumber(line).text().contains("range = [-0.6, 0.6]"))
      << w.text().document()->findBlockByNumber(line).text().toStdString();
  EXPECT_TRUE(w.text().complaints().empty());
}

TEST(RobotPage, ALimitIsMovedByKeysAndWrittenIntoItsLine) {
  RobotWindow w;
  auto* picture = w.page.findChild<RobotPicture*>();
  picture->setFocus();
  press(*picture, Qt::Key_Tab);  // the lower limit of the hip
  press(*picture, Qt::Key_Up, Qt::ShiftModifier);
  ASSERT_TRUE(w.settled());
  EXPECT_TRUE(w.text().toPlainText().contains("limits = [-0.6283, 0.8]")) << "−46° and 10° more are −36°";
  EXPECT_TRUE(w.text().complaints().empty());
}

TEST(RobotPage, WhatAnotherEditorSavesIsShown) {
  RobotWindow w;
  std::string text = w.text().toPlainText().toStdString();
  text.replace(text.find("mass = 3"), 8, "mass = 4");
  ASSERT_TRUE(writeWhole("robot", w.path.toStdString(), text));
  EXPECT_TRUE(w.waitFor([&] { return w.text().toPlainText().contains("mass = 4"); }));
  EXPECT_FALSE(w.page.isEdited());
  w.text().undo();
  EXPECT_TRUE(w.text().toPlainText().contains("mass = 3"));
}

TEST(RobotPage, WhatIsNotSavedIsThereAtTheNextStart) {
  RobotWindow w;
  w.text().moveCursor(QTextCursor::End);
  w.text().insertPlainText("# mine\n");
  w.page.hide();
  RobotPage next(w.registry, w.folder.path());
  next.show();
  EXPECT_TRUE(next.findChild<RobotText*>()->toPlainText().endsWith("# mine\n"));
  EXPECT_EQ(next.fileName(), "mine.toml");
  EXPECT_TRUE(next.isEdited());
  EXPECT_TRUE(next.save());
  EXPECT_TRUE(readText(w.path.toStdString())->ends_with("# mine\n"));
  next.hide();
  RobotPage later(w.registry, w.folder.path());
  later.show();
  EXPECT_FALSE(later.findChild<RobotText*>()->toPlainText().contains("# mine")) << "it is in its file";
}

TEST(RobotPage, AnotherRobotDoesNotDestroyWhatIsNotSaved) {
  RobotWindow w;
  w.text().moveCursor(QTextCursor::End);
  w.text().insertPlainText("# mine\n");
  w.page.beginLike("segway");
  ASSERT_TRUE(w.settled());
  EXPECT_FALSE(w.text().toPlainText().contains("# mine"));
  const auto kept = readText(w.folder.filePath("robot-unsaved-1.toml").toStdString());
  ASSERT_TRUE(kept);
  EXPECT_TRUE(kept->ends_with("# mine\n"));
  w.text().undo();
  EXPECT_TRUE(w.text().toPlainText().endsWith("# mine\n"));
}

TEST(RobotPage, ItMovesWhenItIsTried) {
  RobotWindow w;
  const QImage before = w.page.findChild<RobotPicture*>()->grab().toImage();
  QTest::mouseClick(w.button("Try"), Qt::LeftButton);
  EXPECT_TRUE(w.waitFor([&] { return w.page.findChild<RobotPicture*>()->grab().toImage() != before; }));
  QTest::mouseClick(w.button("Stop"), Qt::LeftButton);
  EXPECT_TRUE(w.has("Try"));
  auto* life = w.page.findChild<RandomLife*>();
  for (int x = 60; x < life->width() - 230 && !w.has("Stop"); x += 4)  // somewhere there is a fall
    QTest::mouseClick(life, Qt::LeftButton, {}, QPoint(x, 60));
  EXPECT_TRUE(w.has("Stop")) << "it is shown again";
}

TEST(RobotHelp, FindsTheKeyAtTheCaretAndExplainsIt) {
  const RobotHelp help(toText(*readText((kRobots + "format.md").toStdString())));
  const QStringList before = {"name = \"a\"", "[body.trunk]", "mass = 2"};
  const auto at = [&](const QString& line, int column) {
    const RobotTextPlace place = placeInRobot(before, line, column);
    return help.of(place.section, place.key);
  };
  EXPECT_TRUE(at("inertia = 0.5", 3).startsWith("inertia: about the centre of mass"));
  EXPECT_TRUE(at("shape = [{ rod = 0.1, to = [0, 1] }]", 2).startsWith("shape: a list"));
  EXPECT_TRUE(at("shape = [{ rod = 0.1, to = [0, 1] }]", 12).startsWith("rod: radius of its round ends"));
  EXPECT_TRUE(at("shape = [{ rod = 0.1, to = [0, 1] }]", 29).startsWith("to: the rod's end"));
  EXPECT_TRUE(at("[[memory]]", 4).startsWith("A number that is carried on"));
  EXPECT_TRUE(placeInRobot({}, "step_time = 0.02", 0).section.isEmpty());
  EXPECT_TRUE(help.of({}, "step_time").startsWith("step_time: how long an action holds"));
  EXPECT_TRUE(help.of("scenario", "set").startsWith("set: {"));
  EXPECT_TRUE(help.of("actuator", "levels").endsWith("by `effort`.")) << "over two lines";
  EXPECT_EQ(help.of("body", "nonsense"), QString());
}

TEST(RobotPage, F1SaysWhatAWordMeansAndWhatItsExpressionIsWorth) {
  RobotWindow w;
  const auto block = [&](const QString& words) {
    QTextBlock b = w.text().document()->begin();
    while (b.isValid() && !b.text().startsWith(words)) b = b.next();
    EXPECT_TRUE(b.isValid()) << words.toStdString();
    return b;
  };
  QTextCursor caret(block("when = "));
  w.text().setTextCursor(caret);
  press(w.text(), Qt::Key_F1);
  EXPECT_TRUE(QToolTip::text().contains("a condition.")) << QToolTip::text().toStdString();
  EXPECT_TRUE(QToolTip::text().contains("comes to 0 at the start of an episode")) << QToolTip::text().toStdString();
  QToolTip::hideText();
}

TEST(RobotPage, IsLeftToItselfAndDropped) {
  RobotWindow w;
  for (const char* mode : {"Passive", "Drop"}) {
    QTest::mouseClick(w.button(mode), Qt::LeftButton);
    EXPECT_TRUE(w.has("Stop")) << mode;
    QTest::qWait(100);
    QTest::mouseClick(w.button("Stop"), Qt::LeftButton);
  }
  // From 20 cm above its drawing it falls, and lands.
  const auto robot = (*w.registry.files->open(w.path.toStdString()))->dropped();
  Random random(1);
  robot->reset(random);
  const double begins = robot->pose().at(1);
  for (int step = 0; step < 10; ++step) robot->step(0);
  EXPECT_LT(robot->pose().at(1), begins - 0.1);
}

TEST(RobotPage, FindsWordsAroundTheEnd) {
  RobotWindow w;
  w.text().setFocus();
  press(w.text(), Qt::Key_F, Qt::ControlModifier);
  auto* find = w.page.findChild<QLineEdit*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return find->isVisible(); }));
  QTest::keyClicks(find, "[body.");
  EXPECT_EQ(w.text().textCursor().selectedText(), "[body.");
  const int first = w.text().textCursor().position();
  int places = 0;
  do {
    press(*find, Qt::Key_Return);
    ++places;
  } while (w.text().textCursor().position() != first && places < 20);
  EXPECT_EQ(places, 3) << "the hopper has three bodies";
  press(*find, Qt::Key_Escape);
  EXPECT_FALSE(find->isVisible());
}

TEST(RobotPage, LetItLearnBeginsALifeOfThisRobot) {
  Window w;
  w.registry.files->setShelf(kRobots.toStdString());
  const QTemporaryDir folder;
  const QString path = folder.filePath("mine.toml");
  ASSERT_TRUE(writeWhole("robot", path.toStdString(), *readText((kRobots + "segway.toml").toStdString())));
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().progress().episodes > 3; }));
  w.window->openFile(path);
  QAbstractButton* learn = nullptr;
  for (auto* b : w.window->robotPage().findChildren<QAbstractButton*>())
    if (b->text() == "Let it learn") learn = b;
  ASSERT_TRUE(learn);
  ASSERT_TRUE(w.waitFor([&] { return !w.window->robotPage().isChecking() && learn->isEnabled(); }, 30'000));
  QTest::mouseClick(learn, Qt::LeftButton);
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().configuration().names.environment.starts_with("segway@"); }));
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().running() && w.session->life().progress().steps > 10; }));
  EXPECT_TRUE(w.session->history().undo().canUndo()) << "the life before is kept";
}

}  // namespace surefoot
