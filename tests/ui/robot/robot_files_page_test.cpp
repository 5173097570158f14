// SPDX-License-Identifier: GPL-3.0-or-later
// Files on the Robot page: what is shown first, saved, and under which name.
#include <QAction>
#include <QFileDialog>
#include <QLineEdit>
#include <QTemporaryDir>

#include "core/environment_library.h"
#include "core/files/read_file.h"
#include "core/files/whole_file.h"
#include "tests/ui/window_setup.h"
#include "ui/robot/robot_page.h"
#include "ui/robot/robot_text.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

const QString kShelf = QStringLiteral(SUREFOOT_SOURCE) + QStringLiteral("/resources/robots/");

}  // namespace

TEST(RobotPage, SaveSavesTheRobotHereAndUndoEndsAtItsText) {
  Window w;
  w.registry.files->setShelf(kShelf.toStdString());
  const QTemporaryDir folder;
  const QString path = folder.filePath("mine.toml");
  ASSERT_TRUE(writeWhole("robot", path.toStdString(), *readText((kShelf + "segway.toml").toStdString())));
  w.window->openFile(path);
  auto& text = *w.window->robotPage().findChild<RobotText*>();
  const QString before = text.toPlainText();
  QTest::keyClicks(&text, "# mine");
  QTest::keyClick(&text, Qt::Key_Return);
  QTest::keyClick(w.window.get(), Qt::Key_S, Qt::ControlModifier);
  EXPECT_FALSE(w.window->robotPage().isEdited());
  EXPECT_TRUE(toText(*readText(path.toStdString())).startsWith("# mine"));
  for (QAction* action : w.window->findChildren<QAction*>())
    for (int i = 0; i < 20 && action->text().startsWith("&Undo"); ++i) action->trigger();
  EXPECT_EQ(text.toPlainText(), before);
  EXPECT_TRUE(w.window->robotPage().save());  // no draft is left for the next window
}

TEST(RobotPage, EscapeEndsTheSearchWhereItFoundSomething) {
  Window w;
  w.registry.files->setShelf(kShelf.toStdString());
  const QTemporaryDir folder;
  const QString path = folder.filePath("mine.toml");
  ASSERT_TRUE(writeWhole("robot", path.toStdString(), *readText((kShelf + "segway.toml").toStdString())));
  w.window->openFile(path);
  auto& text = *w.window->robotPage().findChild<RobotText*>();
  text.setFocus();
  QTest::keyClick(&text, Qt::Key_F, Qt::ControlModifier);
  auto* find = w.named<QLineEdit>("Find in the description");
  ASSERT_TRUE(w.waitFor([&] { return find->hasFocus(); }));
  QTest::keyClicks(find, "mass");
  QTest::keyClick(find, Qt::Key_Escape);
  EXPECT_TRUE(find->isHidden());
  EXPECT_TRUE(text.hasFocus());
  EXPECT_EQ(text.textCursor().selectedText(), "mass");
  EXPECT_FALSE(w.window->robotPage().isEdited());
}

TEST(RobotPage, ShowsTheRobotOfTheLifeUntilAnotherIsChosen) {
  Window w;
  w.registry.files->setShelf(kShelf.toStdString());
  const QTemporaryDir folder;
  const std::string mine = folder.filePath("mine.toml").toStdString();
  ASSERT_TRUE(writeWhole("robot", mine, *readText((kShelf + "acrobot.toml").toStdString())));
  RobotPage& page = w.window->robotPage();
  const auto& text = *page.findChild<RobotText*>();
  const auto begin = [&](const std::string& robot) {
    w.window->setPage(0);
    const auto before = w.session->life().configuration().environmentFile;
    EXPECT_TRUE(w.session->newLives().beginEnvironment(robot));
    EXPECT_TRUE(w.waitFor([&] { return w.session->life().configuration().environmentFile != before; }));
    w.window->setPage(3);
  };
  begin(mine);
  EXPECT_EQ(page.fileName(), "mine.toml");
  begin("hopper");
  EXPECT_TRUE(text.toPlainText().contains("name = \"hopper\""));
  EXPECT_EQ(page.fileName(), "a new robot") << "what comes with the program is not written to";
  page.beginLike("biped");
  begin(mine);
  EXPECT_TRUE(text.toPlainText().contains("name = \"biped\"")) << "it was chosen";
}

TEST(RobotPage, ANewRobotGetsTheNameOfItsFile) {
  Window w;
  w.registry.files->setShelf(kShelf.toStdString());
  const QTemporaryDir folder;
  RobotPage& page = w.window->robotPage();
  w.window->setPage(3);
  page.beginLike("segway");
  ASSERT_TRUE(w.waitFor([&] { return !page.isChecking(); }));
  page.saveAs();
  auto* dialog = page.findChild<QFileDialog*>();
  ASSERT_TRUE(dialog);
  const QString path = folder.filePath("My Wobbly.toml");
  Q_EMIT dialog->fileSelected(path);
  dialog->close();
  const QString saved = toText(*readText(path.toStdString()));
  EXPECT_TRUE(saved.contains("\nname = \"my-wobbly\"")) << saved.left(300).toStdString();
  EXPECT_TRUE(saved.contains("\ntitle = \"My wobbly\""));
  EXPECT_FALSE(page.isEdited());
}

}  // namespace surefoot
