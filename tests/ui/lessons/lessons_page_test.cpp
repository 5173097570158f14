// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lessons_page.h"

#include <QFile>
#include <QLabel>
#include <QPlainTextEdit>

#include "tests/ui/language/spoken.h"
#include "tests/ui/lessons/lessons_setup.h"
#include "ui/lessons/questions/option_button.h"
#include "ui/lessons/writing/lesson_editor.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

TEST(LessonsPage, ListsTheLessonsInTheirChapters) {
  Lessons l;
  EXPECT_EQ(l.page().lessons().size(), 14u);
  EXPECT_EQ(l.page().list().model()->rowCount(), 14 + 3) << "and three heads";
  EXPECT_EQ(l.page().list().chosen(), 0) << "the first that is not done";
  l.page().list().setFocus();
  l.key(Qt::Key_End);
  EXPECT_EQ(l.page().list().chosen(), 13);
  l.key(Qt::Key_Home);
  l.key(Qt::Key_Down);
  EXPECT_EQ(l.page().list().chosen(), 1);
  const QString spoken = l.page().list().currentIndex().data(Qt::AccessibleTextRole).toString();
  EXPECT_EQ(spoken, "Lesson 2 of 13, What is a state worth?, 10 minutes, level 1 of 3, not begun");
}

TEST(LessonsPage, IsInTheLanguageOfTheWindow) {
  const Spoken spoken("nl");
  Lessons l;
  QStringList words;
  for (int i = 0; i < 14; ++i) {
    l.page().list().choose(i);
    for (const QLabel* label : l.page().findChildren<QLabel*>()) words += label->text().split(", ");
  }
  EXPECT_TRUE(words.contains("Waarom valt hij?") || words.contains("1  Waarom valt hij?"));
  EXPECT_TRUE(words.contains("wereld"));
  for (const char* english : {"world", "actions", "list of falls", "the learning rule", "signals"})
    EXPECT_FALSE(words.contains(english)) << english;
}

TEST(LessonsPage, ALessonIsTakenByKeysAlone) {
  Lessons l;
  l.page().list().setFocus();
  for (int i = 0; i < 4; ++i) l.key(Qt::Key_Down);
  l.key(Qt::Key_Return);
  ASSERT_TRUE(l.page().view());
  ASSERT_TRUE(l.opens(0));
  l.key(Qt::Key_Right, Qt::AltModifier);
  ASSERT_TRUE(l.opens(1));
  QTest::qWait(50);
  QTest::keyClicks(l.window->focusWidget(), "40");
  l.key(Qt::Key_Return);
  ASSERT_TRUE(l.opens(2)) << "Enter commits";
  EXPECT_EQ(l.driver().predicted(1), 40.0);
  QTest::qWait(50);
  l.key(Qt::Key_2);
  l.key(Qt::Key_Right, Qt::AltModifier);
  EXPECT_TRUE(l.driver().answered());
  l.key(Qt::Key_Right, Qt::AltModifier);
  ASSERT_TRUE(l.opens(3));
  l.key(Qt::Key_Left, Qt::AltModifier);
  ASSERT_TRUE(l.opens(2));
}

TEST(LessonsPage, WhatWasDoneIsKeptAndGoneOnWith) {
  Lessons l;
  ASSERT_TRUE(l.page().start("the-cliff"));
  ASSERT_TRUE(l.opens(0));
  l.driver().next();
  ASSERT_TRUE(l.opens(1));
  l.page().showList();
  EXPECT_EQ(l.page().view(), nullptr);
  EXPECT_TRUE(QFile::exists(l.folder.filePath("lessons/the-cliff.jsonl")));
  l.window.reset();
  l.open();
  ASSERT_TRUE(l.page().start("the-cliff"));
  ASSERT_TRUE(l.opens(1)) << "at the step where one was";
}

// Back, the list and the program's end keep what was chosen and typed, before it was given and after.
TEST(LessonsPage, WhatIsChosenAndTypedIsKept) {
  Lessons l;
  ASSERT_TRUE(l.page().start("exploring-costs-falls"));
  ASSERT_TRUE(l.opens(0));
  l.driver().next();
  ASSERT_TRUE(l.opens(1));
  l.driver().say(40);
  ASSERT_TRUE(l.opens(2));
  const auto because = [&]() -> QPlainTextEdit& { return *l.page().findChild<QPlainTextEdit*>(); };
  const auto chosen = [&] {
    const auto all = l.page().findChildren<OptionButton*>();
    return std::find_if(all.begin(), all.end(), [](auto* b) { return b->isChecked(); }) - all.begin();
  };
  l.page().findChildren<OptionButton*>()[2]->click();
  because().setPlainText("as it seems");
  l.driver().back();
  ASSERT_TRUE(l.opens(1));
  l.driver().next();
  ASSERT_TRUE(l.opens(2));
  EXPECT_EQ(chosen(), 2);
  EXPECT_EQ(because().toPlainText(), "as it seems");
  l.window.reset();
  l.open();
  ASSERT_TRUE(l.page().start("exploring-costs-falls"));
  ASSERT_TRUE(l.opens(2));
  EXPECT_EQ(chosen(), 2);
  EXPECT_EQ(because().toPlainText(), "as it seems");
  EXPECT_FALSE(l.driver().answered());
  // Given, it is there on the way back, and need not be given again.
  l.driver().choose(1, "so it is");
  l.driver().keepDraft({"2", "so it is"});
  l.driver().back();
  ASSERT_TRUE(l.opens(1));
  l.driver().next();
  ASSERT_TRUE(l.opens(2));
  EXPECT_TRUE(l.driver().answered());
  EXPECT_EQ(because().toPlainText(), "so it is");
  l.driver().resetStep();
  ASSERT_TRUE(l.opens(2));
  EXPECT_FALSE(l.driver().answered());
  EXPECT_EQ(because().toPlainText(), "") << "the step begins again";
}

// The step where one was, also when its lives are still being lived.
TEST(LessonsPage, GoesOnWithTheStepInHandWhateverIsBeingLived) {
  Lessons l;
  ASSERT_TRUE(l.page().start("exploring-costs-falls"));
  for (std::size_t step = 0; step < 4; ++step) {
    ASSERT_TRUE(l.opens(step)) << step;
    l.driver().step().predict ? l.driver().say(40) : l.driver().next();
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return l.driver().number() == 4; }, 20'000));
  ASSERT_TRUE(QTest::qWaitFor([&] { return l.driver().handIn().last(LessonMark::Kind::Arrived, 4); }, 20'000));
  l.window.reset();
  l.open();
  ASSERT_TRUE(l.page().start("exploring-costs-falls"));
  EXPECT_TRUE(l.opens(4));
}

TEST(LessonsPage, TheLessonsRobotGoesToTheLivePageAndTheLessonWaits) {
  Lessons l;
  ASSERT_TRUE(l.page().start("exploring-costs-falls"));
  ASSERT_TRUE(l.opens(0));
  const std::int64_t falls = l.driver().session().life().numbers().falls;
  ASSERT_GT(falls, 0);
  Q_EMIT l.page().view()->exploreAsked();
  ASSERT_TRUE(QTest::qWaitFor([&] { return l.session->life().isShown() && l.session->life().numbers().falls == falls; },
                              10'000));
  EXPECT_EQ(l.session->life().configuration().parameters.get("policy.epsilon"), 0.05);
  l.window->setPage(2);
  ASSERT_TRUE(l.page().view());
  EXPECT_EQ(l.driver().number(), 0u);
}

TEST(LessonsPage, AFileWithAnErrorIsListedWithIt) {
  Lessons l;
  const QString path = l.folder.filePath("mine.toml");
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("title = \"Mine\"\ngoal = \"g\"\n[[step]]\ntitle = \"s\"\nsay = \"![x](http://example.org/x.png)\"\n");
  file.close();
  ASSERT_TRUE(l.page().open(path));
  EXPECT_EQ(l.page().lessons().size(), 15u);
  EXPECT_EQ(l.page().list().chosen(), 14);
  l.page().list().setFocus();
  l.key(Qt::Key_Return);
  EXPECT_EQ(l.page().view(), nullptr) << "it cannot be started";
}

TEST(LessonsPage, AClassHasAFileForEachStudentAndRefusesASecondOfOneName) {
  Lessons l, other;
  QTemporaryDir shared;
  ASSERT_TRUE(l.page().setClass(shared.path(), "Ada"));
  EXPECT_FALSE(other.page().setClass(shared.path(), "Ada")) << "another Ada is there";
  ASSERT_TRUE(other.page().setClass(shared.path(), "Ada 2"));
  ASSERT_TRUE(l.page().start("the-cliff"));
  ASSERT_TRUE(l.opens(0));
  EXPECT_TRUE(QFile::exists(shared.filePath("Ada the-cliff.jsonl")));
  // The folder goes away: it is told, and nothing is lost.
  QString told;
  QObject::connect(&l.page(), &LessonsPage::refused, [&](const QString& sentence) { told = sentence; });
  shared.remove();
  l.driver().next();
  ASSERT_TRUE(l.opens(1));
  EXPECT_TRUE(told.contains("is gone")) << told.toStdString();
  EXPECT_TRUE(QFile::exists(l.folder.filePath("lessons/Ada the-cliff.jsonl")));
}

TEST(LessonsPage, ALessonThatIsDoneCanBeSeenAgainAndStaysDone) {
  Lessons l;
  ASSERT_TRUE(l.page().start("what-is-a-state-worth"));
  ASSERT_TRUE(l.opens(0));
  const std::size_t steps = l.driver().lesson().steps.size();
  for (std::size_t step = 0; step < steps; ++step) {
    ASSERT_TRUE(l.opens(step));
    const auto& predict = l.driver().step().predict;
    predict ? l.driver().say(predict->low) : l.driver().next();
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return l.driver().phase() == LessonDriver::Phase::Finished; }, 20'000));
  l.page().showList();
  ASSERT_TRUE(l.page().start("what-is-a-state-worth"));
  ASSERT_TRUE(l.opens(0)) << "from the beginning";
  l.driver().next();
  l.page().showList();
  l.window.reset();
  l.open();
  const auto again = l.page().list().model()->index(2, 0).data(Qt::AccessibleTextRole).toString();
  EXPECT_TRUE(again.endsWith("done")) << again.toStdString();
}

// Whatever was shown before, another size of texts finds only what is there.
TEST(LessonsPage, TextsGrowAfterALessonWasVisited) {
  Lessons l;
  ASSERT_TRUE(l.page().start("why-does-it-fall"));
  ASSERT_TRUE(l.opens(0));
  l.page().showList();
  for (int lesson = 0; lesson < 13; ++lesson) l.page().list().choose(lesson);
  QTest::qWait(20);
  for (const double size : {1.1, 2.0, 1.0}) {
    applyTextSize(size);
    QTest::qWait(20);
  }
}

TEST(LessonsPage, AnOwnLessonIsOpenedLikeAnyFile) {
  Lessons l;
  l.window->setPage(0);
  l.window->openFile(QStringLiteral(SUREFOOT_SOURCE) + QStringLiteral("/resources/lessons/06-the-cliff.toml"));
  EXPECT_EQ(l.page().lessons().size(), 14u) << "it is in the list already";
  EXPECT_EQ(l.page().list().chosen(), 5);
}

TEST(LessonEditor, TellsWhatIsWrongWhileOneTypesAndKeepsWhatIsNotSaved) {
  Lessons l;
  l.page().editTemplate();
  LessonEditor* editor = l.page().editor();
  ASSERT_TRUE(editor);
  EXPECT_TRUE(editor->complaints().empty()) << editor->complaints()[0].sentence;
  ASSERT_TRUE(editor->lesson());
  auto* text = editor->findChild<QPlainTextEdit*>();
  ASSERT_TRUE(text);
  const QString good = text->toPlainText();
  QString bad = good;
  bad.replace("falls < 90", "fals < 90");
  text->setPlainText(bad);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !editor->complaints().empty(); }, 3'000)) << "a moment after the last key";
  EXPECT_NE(editor->complaints()[0].sentence.find("did you mean falls"), std::string::npos);
  EXPECT_TRUE(editor->lesson()) << "the preview keeps the last good one";
  EXPECT_FALSE(text->extraSelections().isEmpty());
  QTest::keyClick(editor, Qt::Key_F8);
  l.window.reset();
  l.open();
  l.page().editTemplate();
  EXPECT_EQ(l.page().editor()->text(), bad) << "it was not saved, and is back";
}

TEST(LessonEditor, ALessonThatIsWrittenCanBeTakenAtOnce) {
  Lessons l;
  l.page().editTemplate();
  Q_EMIT l.page().editor()->tryAsked();
  ASSERT_TRUE(l.page().view());
  ASSERT_TRUE(l.opens(0));
  EXPECT_EQ(l.driver().lesson().name, "my-lesson");
}

/// Every step of every lesson as a picture, for a person to look at.
TEST(LessonPictures, OfEveryStep) {
  const QString folder = qEnvironmentVariable("SUREFOOT_PICTURES");
  if (folder.isEmpty()) GTEST_SKIP() << "SUREFOOT_PICTURES names no folder";
  Lessons l;
  const QStringList size = qEnvironmentVariable("SUREFOOT_SIZE", QStringLiteral("1280x800")).split('x');
  l.window->resize(size.value(0).toInt(), size.value(1).toInt());
  if (qEnvironmentVariableIsSet("SUREFOOT_DARK")) applyAppearance(*qApp, Appearance::Dark);
  applyTextSize(qEnvironmentVariable("SUREFOOT_TEXT", QStringLiteral("1")).toDouble());
  QTest::qWait(200);
  l.window->grab().save(folder + QStringLiteral("/lessons.png"));
  const QString only = qEnvironmentVariable("SUREFOOT_LESSON");
  for (const ShelvedLesson& one : l.page().lessons()) {
    ASSERT_TRUE(one.lesson);
    const QString name = QString::fromStdString(one.lesson->name);
    if (!only.isEmpty() && name != only) continue;
    ASSERT_TRUE(l.page().start(one.lesson->name));
    for (std::size_t step = 0; step < one.lesson->steps.size(); ++step) {
      ASSERT_TRUE(QTest::qWaitFor(
          [&] { return l.driver().number() == step && l.driver().phase() == LessonDriver::Phase::Open; }, 60'000))
          << one.lesson->name << " " << step + 1;
      QTest::qWait(one.lesson->steps[step].lives ? 4000 : 400);
      l.window->grab().save(QStringLiteral("%1/%2-%3.png").arg(folder, name).arg(step + 1));
      const auto& predict = one.lesson->steps[step].predict;
      predict ? l.driver().say((predict->low + predict->high) / 2) : l.driver().next();
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return l.driver().phase() == LessonDriver::Phase::Finished; }, 20'000));
    QTest::qWait(200);
    l.window->grab().save(QStringLiteral("%1/%2-end.png").arg(folder, name));
  }
  applyTextSize(1);
  applyAppearance(*qApp, Appearance::Light);
}

}  // namespace surefoot
