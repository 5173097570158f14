// SPDX-License-Identifier: GPL-3.0-or-later
// A crash leaves a report on this computer, and the next start offers it beside the session. Real processes crash here.
#include <signal.h>

#include <QClipboard>
#include <QDialog>
#include <QDir>
#include <QPlainTextEdit>
#include <QProcess>
#include <QTemporaryDir>
#include <QTemporaryFile>

#include "tests/ui/session/learn_and_answer.h"
#include "ui/crash/crash_notes.h"
#include "ui/crash/crash_reports.h"
#include "ui/crash/life_notes.h"

namespace surefoot {

namespace {

QString contentOf(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
  return QString::fromUtf8(file.readAll());
}

QString reportNow(int signal) {
  QTemporaryFile file;
  EXPECT_TRUE(file.open());
  writeCrashReport(file.handle(), signal);
  return contentOf(file.fileName());
}

/// A home of its own, in which the program's window is started and ended by a signal.
struct Home {
  Home() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("HOME", folder.path());
    for (const char* name : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_RUNTIME_DIR"})
      environment.insert(name, folder.path());
    environment.insert("QT_QPA_PLATFORM", "offscreen");
    program.setProcessEnvironment(environment);
  }
  QDir data() const { return QDir(folder.filePath("Surefoot/Surefoot")); }
  QStringList files(const char* pattern) const { return data().entryList({pattern}, QDir::Files); }
  /// Starts a window; once it is there, the signal comes.
  void endBy(int signal, const QStringList& arguments) {
    program.start(SUREFOOT_PROGRAM, QStringList{"window"} + arguments);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !files("autosave-*.lock").isEmpty(); }, 30'000));
    QTest::qWait(1500);
    ASSERT_EQ(program.state(), QProcess::Running) << program.readAllStandardError().toStdString();
    ASSERT_EQ(::kill(static_cast<pid_t>(program.processId()), signal), 0);
    ASSERT_TRUE(program.waitForFinished(30'000));
  }
  QTemporaryDir folder;
  QProcess program;
};

/// A window on the data that is there.
struct NextStart : Window {
  explicit NextStart(const QDir& data)
      : data_(data),
        session(registry, configuration, false),
        window(session, {.plans = {}, .folder = data_.path()}) {
    window.resize(1280, 800);
    window.show();
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
  }
  QDialog* dialog() {
    for (auto* one : window.findChildren<QDialog*>())
      if (one->isVisible()) return one;
    return nullptr;
  }
  QDir data_;
  Session session;
  MainWindow window;
};

}  // namespace

TEST(CrashNotes, TheReportHasTheLastThirtyCommandsAndTheLife) {
  noteLife("  environment = cliff\n");
  for (int i = 1; i <= 45; ++i) noteCommand("Command " + std::to_string(i) + ".");
  noteCommand(std::string(1000, 'x'));
  const QString report = reportNow(SIGABRT);
  EXPECT_TRUE(report.startsWith("Surefoot was ended by SIGABRT after ")) << report.toStdString();
  EXPECT_TRUE(report.contains("\nThe life\n  environment = cliff\n"));
  EXPECT_FALSE(report.contains("Command 16."));
  EXPECT_LT(report.indexOf("Command 17."), report.indexOf("Command 45."));
  EXPECT_GT(report.indexOf("Command 17."), 0);
  EXPECT_TRUE(report.contains("xxx")) << "cut off";
  EXPECT_LT(report.size(), 4000);
}

TEST(CrashNotes, ARobotFromAFileIsNotNamed) {
  Registry registry = fullRegistry();
  const std::string file = std::string(SUREFOOT_SOURCE) + "/resources/robots/hopper.toml";
  const auto c = configure(registry, {.environment = file}, {});
  ASSERT_TRUE(c) << c.error().message;
  const std::string lines = lifeLines(*c);
  EXPECT_NE(lines.find("environment = a robot from a file\n"), std::string::npos) << lines;
  EXPECT_NE(lines.find("policy.epsilon = "), std::string::npos);
  EXPECT_EQ(lines.find("hopper"), std::string::npos);
  EXPECT_EQ(lines.find("environment."), std::string::npos) << "names that its author chose";
}

TEST(CrashNotes, CommandsOfTheWindowAreNamed) {
  Window w("trl", {}, {{"policy.threshold", "70"}});
  w.window->setPage(3);
  w.window->setPage(0);
  w.key(Qt::Key_T);
  ASSERT_TRUE(w.session->editing().setParameter("policy.threshold", 60.0));
  const QString report = reportNow(SIGSEGV);
  EXPECT_TRUE(report.contains("  Turbo\n")) << report.toStdString();
  EXPECT_TRUE(report.contains("  page Robot\n"));
  EXPECT_TRUE(report.contains("  policy.threshold\n"));
  EXPECT_TRUE(report.contains("  policy.threshold = 60\n")) << "as it is now";
  EXPECT_TRUE(report.contains("  scenario = actual\n"));
}

TEST(Crash, LeavesAReportAndTheNextStartOffersItAndTheSession) {
  Home home;
  home.endBy(SIGTERM, {"--turbo"});  // leaves a session
  ASSERT_EQ(home.files("autosave-*.surefoot").size(), 1);
  EXPECT_TRUE(home.files("crash-*").isEmpty()) << "an end from outside is none";
  home.endBy(SIGSEGV, {"--page", "lessons", "--seed", "77"});
  EXPECT_EQ(home.program.exitStatus(), QProcess::CrashExit) << "it ends as it would have";
  ASSERT_EQ(home.files("crash-*.txt").size(), 1);
  const QString report = contentOf(home.data().filePath(home.files("crash-*.txt").front()));
  for (const char* words : {"SIGSEGV", "\nVersions\n  Surefoot ", "  Qt ", "  seed = 77\n", "  page Lessons\n"})
    EXPECT_TRUE(report.contains(words)) << words << " in\n" << report.toStdString();
  EXPECT_FALSE(report.contains(home.folder.path())) << "no names of files";
  EXPECT_FALSE(report.contains(".surefoot"));
  home.endBy(SIGABRT, {});
  EXPECT_EQ(home.files("crash-*.txt").size(), 1) << "the newest; the one before was taken by this start";
  EXPECT_EQ(home.files("last-crash.txt").size(), 1);

  {
    NextStart w(home.data());
    EXPECT_TRUE(home.files("crash-*.txt").isEmpty());
    EXPECT_TRUE(contentOf(lastCrash(home.data().path())).contains("SIGABRT"));
    for (const char* text : {"Restore it", "Not now", "Forget it", "Show the report", "Leave it there"})
      EXPECT_TRUE(answersOf(w.window).contains(text)) << text;
    answer(w.window, "Not now");
    EXPECT_EQ(home.files("autosave-*.surefoot").size(), 1) << "no is no loss";
    EXPECT_TRUE(answersOf(w.window).contains("Show the report")) << "another question";
    answer(w.window, "Leave it there");
    EXPECT_TRUE(answersOf(w.window).isEmpty());
    EXPECT_EQ(home.files("last-crash.txt").size(), 1);
  }
  NextStart again(home.data());
  EXPECT_TRUE(answersOf(again.window).contains("Restore it")) << "it is offered again";
  EXPECT_FALSE(answersOf(again.window).contains("Show the report")) << "one crash is told once";
  answer(again.window, "Restore it");
  EXPECT_TRUE(again.waitFor([&] { return again.session.life().progress().episodes > 10; }, 30'000));
}

TEST(Crash, TheReportIsReadCopiedAndDeletedByKeysAlone) {
  QTemporaryDir folder;
  QFile file(folder.filePath("crash-1-x.txt"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("Surefoot was ended by SIGSEGV after 5 s.\n");
  file.close();
  NextStart w(QDir(folder.path()));
  const auto* show = [&]() -> QPushButton* {
    for (auto* button : w.window.messages().findChildren<QPushButton*>())
      if (button->text() == "Show the report") return button;
    return nullptr;
  }();
  ASSERT_TRUE(show);
  ASSERT_FALSE(show->shortcut().isEmpty());
  QTest::keyClick(&w.window, show->shortcut()[0].key(), Qt::AltModifier);
  ASSERT_TRUE(w.waitFor([&] { return w.dialog(); }));
  QDialog* dialog = w.dialog();
  EXPECT_TRUE(dialog->findChild<QPlainTextEdit*>()->toPlainText().contains("SIGSEGV"));
  const auto press = [&](const QString& text) {
    const auto focused = [&] { return qobject_cast<QAbstractButton*>(dialog->focusWidget()); };
    for (int i = 0; i < 10 && !(focused() && focused()->text() == text); ++i) QTest::keyClick(dialog, Qt::Key_Tab);
    ASSERT_TRUE(focused());
    ASSERT_EQ(focused()->text(), text);
    QTest::keyClick(focused(), Qt::Key_Space);
  };
  press("Copy");
  EXPECT_TRUE(QApplication::clipboard()->text().contains("SIGSEGV"));
  press("Delete it");
  EXPECT_TRUE(w.waitFor([&] { return !w.dialog(); }));
  EXPECT_TRUE(lastCrash(folder.path()).isEmpty());
}

TEST(Crash, OfSeveralReportsTheNewestIsKeptAndOneStartIsTold) {
  QTemporaryDir folder;
  for (const char* name : {"crash-1-a.txt", "crash-2-b.txt", "crash-3-c.txt"}) {
    QFile file(folder.filePath(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(name);
    file.close();
    QTest::qWait(20);
  }
  EXPECT_TRUE(takeNewCrash(folder.path()));
  EXPECT_EQ(contentOf(lastCrash(folder.path())), "crash-3-c.txt");
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files), QStringList{"last-crash.txt"});
  EXPECT_FALSE(takeNewCrash(folder.path()));
  EXPECT_FALSE(takeNewCrash("/nowhere"));
  EXPECT_TRUE(lastCrash("/nowhere").isEmpty());
}

}  // namespace surefoot
