// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/plan_editor.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>

#include "tests/ui/experiment/experiment_window.h"
#include "tests/ui/language/spoken.h"
#include "ui/experiment/plans/condition_form.h"

namespace surefoot {

TEST(PlanEditor, EditsThatAreNotUsedYetAreNotLost) {
  ExperimentWindow p(kPlan);
  auto* editor = p.page.findChild<PlanEditor*>();
  auto* edit = editor->findChild<QPlainTextEdit*>();
  p.page.showPlan(true);
  const QString before = editor->text();
  edit->appendPlainText("# mine");
  p.page.startAgain();
  EXPECT_TRUE(editor->text().contains("# mine"));
  auto* lives = p.named<QSpinBox>("Lives a condition");
  ASSERT_TRUE(lives);
  lives->setValue(5);
  Q_EMIT lives->editingFinished();
  EXPECT_TRUE(editor->text().contains("# mine"));
  EXPECT_TRUE(editor->text().contains("lives = 5")) << editor->text().toStdString();
  const QString other = p.folder.filePath("other.toml");
  ASSERT_TRUE(writeWhole("plan", other.toStdString(), "title = \"Other\"\n" + kPlan.substr(kPlan.find("lives"))));
  p.page.open(other);
  ASSERT_TRUE(p.waitFor([&] { return !p.experiment().isOpening(); }));
  EXPECT_FALSE(editor->text().contains("# mine"));
  edit->undo();
  EXPECT_TRUE(editor->text().contains("# mine")) << "undo brings them back";
}

TEST(PlanEditor, TheLivesOfAPlanThatGrowsAreNoNumberToType) {
  ExperimentWindow p(kPlan);
  auto* lives = p.named<QSpinBox>("Lives a condition");
  ASSERT_TRUE(lives);
  EXPECT_TRUE(lives->isEnabled());
  EXPECT_EQ(lives->text(), QString("%1 lives").arg(p.experiment().plan()->lives));
  std::string grows = kPlan;
  const auto at = grows.find("lives = "), end = grows.find('\n', at);
  grows.replace(at, end - at, "lives = \"decided\"");
  const QString other = p.folder.filePath("grows.toml");
  ASSERT_TRUE(writeWhole("plan", other.toStdString(), grows));
  p.page.open(other);
  ASSERT_TRUE(p.waitFor([&] { return !p.experiment().isOpening() && !lives->isEnabled(); }));
  EXPECT_EQ(lives->text(), "until decided");
}

TEST(PlanEditor, ThePlanIsEditedAsTextAndChecked) {
  ExperimentWindow p;
  p.page.showPlan(true);
  auto* edit = p.named<QPlainTextEdit>("Plan");
  auto* editor = p.window->findChild<PlanEditor*>();
  EXPECT_TRUE(edit->toPlainText().contains("Two walks"));
  editor->setText(edit->toPlainText() + "[[condition]]\nname = \"three\"\npolicy = \"nobody\"\n");
  QPushButton* use = nullptr;
  for (auto* button : editor->findChildren<QPushButton*>())
    if (button->text() == "Use this plan") use = button;
  ASSERT_TRUE(use);
  EXPECT_FALSE(use->isEnabled()) << "there is no such policy";
  editor->setText(QString::fromStdString(kPlan));
  Q_EMIT editor->liveConditionAsked();
  EXPECT_TRUE(p.waitFor([&] { return edit->toPlainText().contains("live: trl"); }));
  ASSERT_TRUE(p.waitFor([&] { return use->isEnabled(); }));
  QTest::mouseClick(use, Qt::LeftButton);
  EXPECT_EQ(p.experiment().storedPlan().conditions.size(), 3u);
}

TEST(PlanEditor, AFormWritesConditionsIntoThePlan) {
  ExperimentWindow p;
  p.page.showPlan(true);
  auto* editor = p.window->findChild<PlanEditor*>();
  auto* form = p.window->findChild<ConditionForm*>();
  const auto choose = [&](const char* name, const char* value) {
    auto* combo = p.named<QComboBox>(name);
    combo->setCurrentIndex(combo->findData(value));
    Q_EMIT combo->activated(combo->currentIndex());
  };
  choose("Environment of the condition", "pendulum");
  choose("Policy of the condition", "trl");
  choose("Scenario of the condition", "3");
  choose("Parameter 1 to set", "policy.threshold");
  p.named<QLineEdit>("Values of parameter 1")->setText("0, 50 ,much");
  EXPECT_NE(form->toml().error().message.find("much"), std::string::npos);
  p.named<QLineEdit>("Values of parameter 1")->setText("0, 50");
  choose("Pre-learning of the condition", "2");
  for (auto* button : editor->findChildren<QPushButton*>())
    if (button->text() == "Add the condition") QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_TRUE(p.waitFor([&] { return editor->text().contains("pre(2)"); }));
  const auto plan = p.experiment().parse(editor->text().toStdString());
  ASSERT_TRUE(plan) << plan.error().message;
  ASSERT_EQ(plan->conditions.size(), 4u);
  EXPECT_EQ(plan->conditions[3].name, "pre(2): TRL, threshold 50");
  EXPECT_EQ(plan->conditions[3].configuration.parameters.get("policy.threshold"), 50);
  EXPECT_EQ(plan->conditions[3].preLearning->pool, 5);
  choose("Environment of the condition", "cliff");
  p.named<QLineEdit>("Length of a life")->setText("2.5");
  EXPECT_FALSE(form->toml()) << "episodes are whole";
}

TEST(PlanEditor, APlanIsTheSameInEveryLanguage) {
  const auto written = [](const char* code, const char* values) {
    const Spoken spoken(code);
    ExperimentWindow p;
    p.page.showPlan(true);
    const auto of = [](const char* name) { return QCoreApplication::translate("surefoot::ConditionForm", name); };
    const auto choose = [&](const QString& name, const char* value) {
      auto* combo = p.named<QComboBox>(name);
      combo->setCurrentIndex(combo->findData(value));
      Q_EMIT combo->activated(combo->currentIndex());
    };
    choose(of("Policy of the condition"), "softmax");
    choose(of("Parameter %1 to set").arg(1), "policy.temperature");
    p.named<QLineEdit>(of("Values of parameter %1").arg(1))->setText(values);
    const auto toml = p.window->findChild<ConditionForm*>()->toml();
    return toml ? *toml : toml.error().message;
  };
  const std::string english = written("en", "0.5; 1000.25");
  EXPECT_NE(english.find("set.policy.temperature = [0.5, 1000.25]"), std::string::npos) << english;
  EXPECT_EQ(written("de", "0,5; 1000,25"), english);
  EXPECT_EQ(written("nl", "0.5 1000,25"), english);
}

TEST(PlanEditor, TheFormBeginsAsTheFirstConditionUntilItIsFilledIn) {
  ExperimentWindow p;
  p.page.showPlan(true);
  const auto shows = [&](const char* name) { return p.named<QComboBox>(name)->currentData().toString().toStdString(); };
  auto* length = p.named<QLineEdit>("Length of a life");
  EXPECT_EQ(shows("Environment of the condition"), "cliff");
  EXPECT_EQ(shows("Representation of the condition"), "table");
  EXPECT_EQ(length->text(), "200");
  const auto label = [&] {
    for (const auto* l : p.window->findChild<ConditionForm*>()->findChildren<QLabel*>())
      if (l->text().startsWith("A life [")) return l->text().toStdString();
    return std::string();
  };
  EXPECT_EQ(label(), "A life [episodes]");
  auto* editor = p.page.findChild<PlanEditor*>();
  editor->setText(QString::fromStdString(
      "lives = 3\n[base]\nscenario = 3\npolicy = \"softmax\"\nminutes = 4.5\n[base.pre-learning]\nscenario = 2\n"
      "until = 150\npool = 7\n[[condition]]\nname = \"one\"\n"));
  ASSERT_TRUE(p.waitFor([&] { return shows("Environment of the condition") == "pendulum"; })) << "when it is checked";
  EXPECT_EQ(shows("Scenario of the condition"), "3");
  EXPECT_EQ(shows("Policy of the condition"), "softmax");
  EXPECT_EQ(shows("Pre-learning of the condition"), "2");
  EXPECT_EQ(length->text(), "4.5");
  EXPECT_EQ(label(), "A life [min]");
  EXPECT_EQ(p.named<QLineEdit>("Average reward that ends the pre-learning")->text(), "150");
  EXPECT_EQ(p.named<QLineEdit>("Q-functions in the pool")->text(), "7");

  length->clear();
  QTest::keyClicks(length, "8");
  editor->setText(QString::fromStdString(kPlan));
  EXPECT_EQ(length->text(), "8") << "what a person wrote stays";
  EXPECT_EQ(shows("Environment of the condition"), "pendulum");

  const QString other = p.folder.filePath("other.toml");
  ASSERT_TRUE(writeWhole("plan", other.toStdString(), "title = \"Other\"\n" + kPlan.substr(kPlan.find("lives"))));
  p.page.open(other);
  ASSERT_TRUE(p.waitFor([&] { return !p.experiment().isOpening(); }));
  EXPECT_EQ(shows("Environment of the condition"), "cliff") << "another plan: it begins anew";
}

}  // namespace surefoot
