// SPDX-License-Identifier: GPL-3.0-or-later
// Every page, in every task, at the sizes that people have: no text is cut, none lies over another.
#include <fmt/format.h>

#include <QApplication>
#include <QLabel>
#include <QPainter>
#include <QTemporaryDir>
#include <map>

#include "core/environment_library.h"
#include "core/files/whole_file.h"
#include "tests/ui/window/size_setup.h"
#include "tests/ui/window/text_recorder.h"
#include "ui/controls/message_bar.h"
#include "ui/experiment/experiment_page.h"
#include "ui/lessons/lessons_page.h"
#include "ui/lessons/taking/lesson_view.h"
#include "ui/live/live_page.h"
#include "ui/robot/robot_page.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"

namespace surefoot {

namespace {

void use(Window& w, const Screen& screen) {
  applyTextSize(screen.text);
  w.window->resize(screen.size);
  w.window->livePage().resetLayout();
  QTest::qWait(30);
}

class ReadableTask : public testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(ReadableTask, TheLivePageAtEverySize) {
  const UsualLook usual;
  Window w;
  ASSERT_NO_FATAL_FAILURE(live(w, GetParam()));
  atEverySize(kScreens, [&](const Screen& screen, const QString& where) {
    const QString text = QStringLiteral("%1, %2").arg(GetParam(), where);
    use(w, screen);
    expectReadable(*w.window, text);
    for (const auto layout : {LivePage::Layout::Teaching, LivePage::Layout::Falls, LivePage::Layout::Maps}) {
      w.window->livePage().useLayout(layout);
      QTest::qWait(30);
      expectReadable(*w.window, text + QStringLiteral(", layout %1").arg(static_cast<int>(layout)));
    }
    use(w, screen);
    w.window->livePage().setComparing(true);
    w.window->messages().say("Something could not be done; this sentence says what, why, and what is allowed instead.");
    QTest::qWait(30);
    expectReadable(*w.window, text + ", comparing");
    w.window->livePage().setComparing(false);
    w.window->messages().dismiss();
  });
}

INSTANTIATE_TEST_SUITE_P(Tasks, ReadableTask, testing::Values("pendulum", "leo", "compass", "cliff"));

constexpr const char* kHead = "lives = 3\n[base]\nenvironment = \"cliff\"\nfeatures = \"table\"\nepisodes = 50\n";

/// Two conditions, of which one has a long name.
std::string twoWalks() {
  return std::string("title = \"Two walks\"\nreference = \"one\"\n") + kHead +
         "[[condition]]\nname = \"one\"\n[[condition]]\nname = \"a name of more words than there is room for\"\n"
         "policy = \"softmax\"\n";
}

/// As many as the longest recipe of the thesis has, in groups.
std::string manyWalks() {
  std::string text = "title = \"TRL after pre-learning on scenarios 2 to 6\"\n";
  text += kHead;
  const auto condition = [&](const std::string& name, const std::string& rest) {
    text += "[[condition]]\nname = \"" + name + "\"\n" + rest;
  };
  for (int group = 2; group <= 6; ++group) {
    const std::string pre = "pre(" + std::to_string(group) + "): ", reference = pre + "ε-greedy";
    const std::string length = "episodes = 5" + std::to_string(group) + "\n";
    condition(reference, length);
    condition(pre + "TRL {policy.threshold}", length +
                                                  "policy = \"trl\"\nset.policy.threshold = [-50, 0, 50, 100, 150]\n"
                                                  "reference = \"" +
                                                  reference + "\"\n");
  }
  return text;
}

/// A plan on the Experiment page.
void openPlan(Window& w, const QTemporaryDir& folder, const std::string& text) {
  const std::string path = folder.filePath("plan%1.toml").arg(text.size()).toStdString();
  ASSERT_TRUE(writeWhole("plan", path, text));
  w.window->setPage(1);
  ExperimentPage& page = w.window->experimentPage();
  page.open(QString::fromStdString(path));
  ASSERT_TRUE(w.waitFor([&] { return !page.experiment().isOpening(); }));
  ASSERT_EQ(page.experiment().path(), path) << w.window->messages().accessibleName().toStdString();
  w.window->messages().dismiss();
}

void runToItsEnd(Window& w) {
  ExperimentPage& page = w.window->experimentPage();
  page.runOrPause();
  ASSERT_TRUE(w.waitFor([&] { return page.experiment().state() == Experiment::State::Complete; }, 60'000));
  QTest::qWait(200);
}

TEST(Readable, TheOtherPagesAtEverySize) {
  const UsualLook usual;
  Window w;
  const QTemporaryDir folder;
  ASSERT_NO_FATAL_FAILURE(openPlan(w, folder, twoWalks()));
  const auto check = [&](const char* state) {
    atEverySize(kScreens, [&](const Screen& screen, const QString& text) {
      use(w, screen);
      expectReadable(*w.window, text + ", " + state);
    });
  };
  check("not run");
  ASSERT_NO_FATAL_FAILURE(runToItsEnd(w));
  check("complete");
  ASSERT_NO_FATAL_FAILURE(openPlan(w, folder, manyWalks()));
  ASSERT_NO_FATAL_FAILURE(runToItsEnd(w));
  w.window->experimentPage().experiment().choose("pre(3): TRL 100");
  QTest::qWait(300);
  check("many conditions");
  ASSERT_NO_FATAL_FAILURE(openPlan(w, folder, twoWalks()));
  w.window->experimentPage().showPlan(true);
  check("plan editor");
  w.window->setPage(2);
  check("lessons");
  w.registry.files->setShelf(std::string(SUREFOOT_SOURCE) + "/resources/robots");
  w.window->setPage(3);
  w.window->robotPage().beginLike("biped");
  QTest::qWait(500);
  check("robot");
}

/// The Lessons page with its lessons: the list, and steps of several kinds.
TEST(Readable, LessonsAtEverySize) {
  const UsualLook usual;
  const QTemporaryDir folder;
  const Registry registry = fullRegistry();
  Session session(registry, pendulumConfiguration(registry, "trl"), false);
  WindowSetup setup;
  setup.lessons = QStringLiteral(SUREFOOT_SOURCE) + QStringLiteral("/resources/lessons");
  setup.folder = folder.path();
  setup.asksOnQuit = false;
  MainWindow window(session, std::move(setup));
  window.show();
  window.setPage(2);
  const auto check = [&](const QString& state) {
    atEverySize(kScreens, [&](const Screen& screen, const QString& text) {
      applyTextSize(screen.text);
      window.resize(screen.size);
      QTest::qWait(30);
      expectReadable(window, text + ", " + state);
    });
  };
  check("list");
  ASSERT_TRUE(window.lessonsPage().start("exploring-costs-falls"));
  LessonDriver& driver = window.lessonsPage().view()->driver();
  const auto opens = [&](std::size_t number) {
    return QTest::qWaitFor([&] { return driver.number() == number && driver.phase() == LessonDriver::Phase::Open; },
                           20'000);
  };
  ASSERT_TRUE(opens(0));
  driver.next();
  ASSERT_TRUE(opens(1));
  check("a prediction");
  driver.say(40);
  ASSERT_TRUE(opens(2));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !driver.lives().empty(); }, 20'000));
  check("what came out");
  driver.choose(0, "because");
  driver.choose(1, "because");
  driver.next();
  ASSERT_TRUE(opens(3));
  check("a task");
}

/// Where every widget that is shown lies in the window.
std::map<QString, QRect> places(const QWidget& window) {
  std::map<QString, QRect> all;
  for (const auto* widget : window.findChildren<QWidget*>())
    if (widget->isVisible())
      all[QStringLiteral("%1 %2").arg(nameOf(*widget)).arg(all.size())] = {widget->mapTo(&window, QPoint()),
                                                                           widget->size()};
  return all;
}

std::string wordsOf(const QRect& r) {
  return fmt::format("{} × {} at ({}, {})", r.width(), r.height(), r.x(), r.y());
}

TEST(Readable, ASizeAndBackLeavesEverythingWhereItWas) {
  const UsualLook usual;
  Window w;
  w.window->resize(1280, 720);
  const QTemporaryDir folder;
  ASSERT_NO_FATAL_FAILURE(openPlan(w, folder, twoWalks()));
  ASSERT_NO_FATAL_FAILURE(runToItsEnd(w));
  for (const int page : {1, 2, 3}) {  // on the first, panels give way to each other
    w.window->setPage(page);
    QTest::qWait(100);
    ASSERT_TRUE(w.waitFor([&] { return !w.window->findChild<RobotPage*>()->isChecking(); }));
    QTest::qWait(30);
    const auto before = places(*w.window);
    for (const double size : {kProjectorText, 1.0, kLargestText, kSmallestText, 1.0}) {
      applyTextSize(size);
      QTest::qWait(100);
    }
    const auto after = places(*w.window);
    ASSERT_EQ(before.size(), after.size());
    for (const auto& [name, place] : before)
      EXPECT_TRUE(place == after.at(name))
          << page << " " << name.toStdString() << ": " << wordsOf(place) << ", then " << wordsOf(after.at(name));
  }
}

TEST(Readable, WhatCannotBeReadIsFound) {
  class Bad final : public QWidget {
   public:
    void paintEvent(QPaintEvent*) override {
      QPainter p(this);
      p.setFont(textFont(13));
      p.drawText(QPointF(10, 20), "one text");
      if (bad == 1) p.drawText(QPointF(30, 22), "another over it");
      if (bad == 2) p.drawText(QPointF(180, 60), "one that leaves");
      if (bad == 3) p.setClipRect(0, 0, 30, 80), p.drawText(QPointF(10, 60), "one that is cut");
    }
    int bad = 0;
  } w;
  w.resize(200, 80);
  EXPECT_EQ(drawnTexts(w).size(), 1u);
  EXPECT_TRUE(cutOrOverlapping(w, false).empty());
  for (w.bad = 1; w.bad <= 3; ++w.bad) EXPECT_EQ(cutOrOverlapping(w, false).size(), 1u) << w.bad;
  QWidget window;
  auto* label = new QLabel("a sentence of many words that needs more room than this", &window);
  label->setGeometry(0, 0, 60, 20);
  window.show();
  EXPECT_FALSE(unreadable(window).empty());
}

}  // namespace surefoot
