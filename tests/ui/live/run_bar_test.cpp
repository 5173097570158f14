// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/run_bar.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QPushButton>
#include <set>

#include "tests/ui/window_setup.h"
#include "ui/controls/message_bar.h"
#include "ui/controls/slider.h"
#include "ui/live/form/parameter_row.h"

namespace surefoot {

TEST(RunBar, TheToolbarsButtonsDoWhatTheShortcutsDo) {
  Window w;
  QTest::mouseClick(w.named<QAbstractButton>("Run"), Qt::LeftButton);
  EXPECT_TRUE(w.session->life().running());
  QTest::mouseClick(w.named<QAbstractButton>("Pause"), Qt::LeftButton);
  EXPECT_FALSE(w.session->life().running());
  QTest::mouseClick(w.named<QAbstractButton>("Step"), Qt::LeftButton);
  QTest::mouseClick(w.named<QAbstractButton>("Restart"), Qt::LeftButton);
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().snapshot().life == 2; }));
  QTest::mouseClick(w.named<QAbstractButton>("Turbo"), Qt::LeftButton);
  EXPECT_TRUE(w.session->life().turbo());
  w.named<Slider>("Pace")->setValue(Slider::kSteps);
  EXPECT_NEAR(w.session->life().pace(), 8.0, 1e-9);
}

TEST(RunBar, PolicyAndScenarioAreChosenInTheToolbar) {
  Window w;
  auto* policy = w.named<QComboBox>("Policy");
  const int softmax = policy->findData("softmax");
  ASSERT_GE(softmax, 0);
  Q_EMIT policy->activated(softmax);
  EXPECT_EQ(w.session->life().configuration().names.policy, "softmax");
  auto* scenario = w.named<QComboBox>("Task");
  Q_EMIT scenario->activated(scenario->findData("3"));
  EXPECT_EQ(w.session->life().configuration().parameters.get("environment.friction"), 0.05);
  EXPECT_EQ(w.session->life().configuration().names.scenario, "3");
}

TEST(RunBar, AnotherLearningRuleStartsAgainAndShowsItsParts) {
  Window w;
  auto* agent = w.named<QComboBox>("Learning rule");
  Q_EMIT agent->activated(agent->findData("sarsa-2q"));
  EXPECT_EQ(w.session->life().configuration().names.agent, "sarsa") << "not before it is agreed to";
  ASSERT_TRUE(w.window->messages().isVisible());
  for (auto* button : w.window->messages().findChildren<QPushButton*>())
    if (button->text() == "Start again") QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(w.session->life().configuration().names.agent, "sarsa-2q");
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(
      w.waitFor([&] { return w.session->life().values() && w.session->looking().shown().qNegative.size() == 5; }));
  for (std::size_t a = 0; a < 5; ++a)
    EXPECT_NEAR(w.session->looking().shown().q[a],
                w.session->looking().shown().qPositive[a] + w.session->looking().shown().qNegative[a], 1e-9);
  std::set<std::string> rows;
  for (const ParameterRow* row : w.window->findChildren<ParameterRow*>()) rows.insert(row->key());
  EXPECT_TRUE(rows.contains("negative.scale"));
  EXPECT_FALSE(rows.contains("agent.step_size"));
}

TEST(RunBar, TheToolbarFollowsTheTask) {
  Window w;
  auto* task = w.named<QComboBox>("Task");
  auto* agent = w.named<QComboBox>("Learning rule");
  EXPECT_EQ(task->currentText(), "Pendulum, actual system");
  EXPECT_EQ(agent->findData("scripted"), -1) << "the pendulum has no hand-made controller";
  ASSERT_TRUE(w.session->editing().setParameter("environment.damping", 0.05));
  EXPECT_EQ(task->currentIndex(), -1) << "a model that was changed is no scenario";
  Q_EMIT task->activated(task->findData("leo"));
  EXPECT_EQ(w.session->life().configuration().names.environment, "leo");
  EXPECT_EQ(task->currentText(), "LEO walker");
  EXPECT_GE(agent->findData("scripted"), 0);
  EXPECT_EQ(agent->currentText(), "Sarsa");
}

}  // namespace surefoot
