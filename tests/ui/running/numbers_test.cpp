// SPDX-License-Identifier: GPL-3.0-or-later
// What several places of the window say of one thing is one number, of one moment.
#include <QPushButton>
#include <QTabBar>

#include "core/text/text.h"
#include "tests/ui/window_setup.h"
#include "ui/controls/panel.h"
#include "ui/live/charts/learning_charts.h"
#include "ui/live/falls_list.h"
#include "ui/live/live_page.h"
#include "ui/live/rule_view.h"
#include "ui/live/run_bar.h"
#include "ui/window/status_line.h"

namespace surefoot {

namespace {

struct Places : Window {
  explicit Places(const std::string& policy = "epsilon-greedy") : Window(policy) {
    window->livePage().useLayout(LivePage::Layout::Falls);
    bar = window->findChild<RunBar*>();
    status = window->findChild<StatusLine*>();
    list = window->findChild<FallsList*>();
    rule = window->findChild<RuleView*>();
    for (auto* chart : window->findChildren<LearningChart*>())
      if (chart->accessibleName() == "Falls") falls = chart;
    for (auto* header : window->livePage().centralWidget()->findChildren<PanelHeader*>()) world = header;
    window->findChild<ChartSpan*>()->showWholeLife();
  }
  QString statusWith(const char* word) const {
    for (const QString& text : status->texts())
      if (text.contains(word)) return text;
    return {};
  }
  RunBar* bar = nullptr;
  StatusLine* status = nullptr;
  FallsList* list = nullptr;
  RuleView* rule = nullptr;
  LearningChart* falls = nullptr;
  PanelHeader* world = nullptr;
};

QString listed(const FallsList& list, int column) {
  return list.model()->index(0, column).data().toString();
}

}  // namespace

TEST(Numbers, AreTheSameEverywhereWhileItRunsAndWhenItIsPaused) {
  Places w;
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    if (i == 150) w.session->life().setRunning(false);
    QTest::qWait(7);
    if (w.session->life().numbers().falls == 0) continue;
    ++compared;
    const RunBar::Texts& bar = w.bar->texts();
    ASSERT_EQ(w.bar->accessibleDescription(), bar.falls + " falls in " + bar.episodes + " episodes");
    ASSERT_EQ(w.falls->items().back().text, bar.falls) << "the number at the curve";
    ASSERT_EQ(listed(*w.list, 0), bar.falls) << "the newest of the list";
    const Numbers& n = w.session->life().numbers();
    ASSERT_EQ(n.falls, w.session->life().latest().falls);
    ASSERT_EQ(n.episodes, w.session->life().latest().episode);
    ASSERT_EQ(w.statusWith(" steps").section(' ', 0, 0).remove(','), QString::number(n.steps));
    ASSERT_EQ(w.statusWith("simulated").section(' ', 0, 0),
              QString::fromStdString(n.simulatedSeconds < 6e4 ? fixedText(n.simulatedSeconds / 60, 2)
                                                              : countText(n.simulatedSeconds / 60)));
    ASSERT_NEAR(static_cast<double>(n.steps) * 0.005, n.simulatedSeconds, 1e-6);
    ASSERT_TRUE(bar.factor.isEmpty() || w.world->note().endsWith(bar.factor)) << w.world->note().toStdString();
  }
  EXPECT_GT(compared, 100);
}

TEST(Numbers, TheSpeedOfTurboDoesNotOutliveIt) {
  Places w;
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.bar->texts().factor.size() >= 4; }));
  w.session->life().setTurbo(false);
  const auto factor = [&] { return w.bar->texts().factor.mid(1).remove(',').toDouble(); };
  for (int i = 0; i < 150; ++i) {
    ASSERT_LT(factor(), 1.5) << "after " << 10 * i << " ms";
    ASSERT_FALSE(w.world->note().contains("×1,") || w.world->note().contains("00")) << w.world->note().toStdString();
    QTest::qWait(10);
  }
  EXPECT_GT(factor(), 0.5);
}

TEST(Numbers, TheRuleOfThumbIsOneEverywhereAndItsButtonSetsIt) {
  Places w("softmax");
  w.window->livePage().useLayout(LivePage::Layout::Teaching);
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().values() && w.session->life().values()->rule; }, 30'000));
  w.session->life().setRunning(false);
  QTest::qWait(250);
  const RuleText text = textOf(*w.session->life().values()->rule);
  const QStringList lines = w.rule->lines();
  EXPECT_EQ(lines[0], QString::fromStdString(text.threshold));
  EXPECT_TRUE(lines[1].contains(QString::fromStdString(text.formula))) << lines[1].toStdString();
  EXPECT_TRUE(lines[1].endsWith(lines[0])) << lines[1].toStdString();
  EXPECT_EQ(w.statusWith("n*"),
            QString::fromStdString("n* " + text.transitions + " → rule-of-thumb threshold " + text.threshold));
  EXPECT_TRUE(lines.back().contains("not in force")) << lines.back().toStdString();
  auto* button = w.rule->findChild<QPushButton*>();
  EXPECT_EQ(button->accessibleName(), button->text());
  EXPECT_TRUE(button->text().startsWith("Set the threshold to "));
  button->setFocus();
  QTest::keyClick(button, Qt::Key_Space);
  EXPECT_EQ(w.session->life().threshold(), std::round(w.session->life().values()->rule->threshold));
  w.session->editing().setPolicy("trl");
  EXPECT_TRUE(w.rule->lines().back().contains("in force: ")) << w.rule->lines().back().toStdString();
}

TEST(Numbers, WhereThereIsNoRuleOfThumbItIsSaidWhy) {
  Places w;
  ASSERT_TRUE(w.session->newLives().beginEnvironment("mountain-car"));
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().configuration().names.environment == "mountain-car"; }));
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().values() && w.session->life().values()->totals.successes > 3; },
                        30'000));
  EXPECT_TRUE(w.rule->lines()[0].contains("not defined for this task")) << w.rule->lines()[0].toStdString();
  EXPECT_FALSE(w.rule->findChild<QPushButton*>()->isVisible());
  EXPECT_TRUE(w.statusWith("not defined").contains("threshold"));
}

TEST(Numbers, FallsByHandAreToldApart) {
  Places w;
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 1; }));
  const auto& task = w.session->life().task();
  std::vector<double> leaning(task.state.size(), 0.0);
  leaning[0] = 1.3;
  leaning[1] = 3.0;
  ASSERT_TRUE(w.session->life().place(leaning));
  w.session->life().setTurbo(true);
  for (int i = 0; i < 400 && w.session->life().numbers().falls == 0; ++i) {
    w.session->looking().stepOnce();
    QTest::qWait(5);
  }
  ASSERT_GE(w.session->life().numbers().falls, 1);
  EXPECT_EQ(w.session->life().numbers().fallsByHand, 1);
  EXPECT_TRUE(listed(*w.list, 4).contains("placed by hand")) << listed(*w.list, 4).toStdString();
  EXPECT_NE(w.list->asCsv().find(",placed\n"), std::string::npos);
  EXPECT_TRUE(w.window->livePage().findChild<Panel*>("falls")->header().note().contains("by hand"));
}

}  // namespace surefoot
