// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parameter_form.h"

#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

#include "tests/ui/window_setup.h"
#include "ui/message_bar.h"
#include "ui/parameter_row.h"
#include "ui/slider.h"

namespace surefoot {

TEST(ParameterForm, HasARowForEveryParameterThatHasAnEffect) {
  Window w;
  w.window->findChild<ParameterForm*>()->setShowAll(true);
  for (const char* schedule : {"policy.epsilon_schedule", "policy.threshold_schedule", "policy.temperature_schedule"})
    ASSERT_TRUE(w.session->setParameter(schedule, 1));
  std::set<std::string> shown;
  for (const ParameterRow* row : w.window->findChildren<ParameterRow*>())
    if (!row->isHidden()) shown.insert(row->key());
  const Parameters& parameters = w.session->configuration().parameters;
  for (const auto& entry : parameters.all()) {
    const std::string& needs = entry.parameter.needs;
    EXPECT_EQ(shown.contains(entry.parameter.key), needs.empty() || parameters.get(needs) != 0.0)
        << entry.parameter.key;
  }
}

// Rows that were asked for later stand between those that were there before.
TEST(ParameterForm, TabGoesDownTheForm) {
  Window w;
  auto* form = w.window->findChild<ParameterForm*>();
  form->setShowAll(true);
  QTest::qWait(50);
  const auto fields = form->findChildren<QLineEdit*>();
  ASSERT_GT(fields.size(), 20);
  QWidget* at = w.named<QLineEdit>("Exploration, number");
  int y = 0, count = 0;
  for (at = at->nextInFocusChain(); form->isAncestorOf(at); at = at->nextInFocusChain()) {
    if (!qobject_cast<QLineEdit*>(at) || !at->isVisible()) continue;
    const int here = at->mapTo(form->widget(), QPoint()).y();
    EXPECT_GT(here, y) << at->accessibleName().toStdString();
    y = here;
    ++count;
  }
  EXPECT_GT(count, 20);
}

// What a schedule needs is shown as soon as there is one.
TEST(ParameterForm, WhatHasNoEffectIsNotShown) {
  Window w;
  w.window->findChild<ParameterForm*>()->setShowAll(true);
  const auto shown = [&](const std::string& key) {
    for (const ParameterRow* row : w.window->findChildren<ParameterRow*>())
      if (row->key() == key) return !row->isHidden();
    return false;
  };
  EXPECT_TRUE(shown("policy.epsilon_schedule"));
  EXPECT_FALSE(shown("policy.epsilon_end"));
  EXPECT_FALSE(shown("shaping.discount"));
  ASSERT_TRUE(w.session->setParameter("policy.epsilon_schedule", 1));
  EXPECT_TRUE(shown("policy.epsilon_end"));
  EXPECT_TRUE(shown("policy.epsilon_per"));
  EXPECT_FALSE(shown("policy.threshold_end"));
}

TEST(ParameterForm, TheSliderReachesBothEndsExactly) {
  Window w;
  auto* slider = w.named<Slider>("Step size");
  slider->setValue(slider->maximum());
  EXPECT_EQ(w.session->configuration().parameters.get("agent.step_size"), 1.0);
  slider->setValue(slider->minimum());
  EXPECT_EQ(w.session->configuration().parameters.get("agent.step_size"), 0.0);
}

TEST(ParameterForm, ANumberCanBeTyped) {
  Window w;
  auto* number = w.named<QLineEdit>("Threshold, number");
  number->setFocus();
  number->selectAll();
  QTest::keyClicks(number, "-12.5");
  QTest::keyClick(number, Qt::Key_Return);
  EXPECT_EQ(w.session->configuration().parameters.get("policy.threshold"), -12.5);
}

TEST(ParameterForm, ATypedNumberOutOfRangeIsRefusedInASentence) {
  Window w;
  auto* number = w.named<QLineEdit>("Exploration, number");
  number->setFocus();
  number->selectAll();
  QTest::keyClicks(number, "7");
  QTest::keyClick(number, Qt::Key_Return);
  EXPECT_EQ(w.session->configuration().parameters.get("policy.epsilon"), 0.05);
  EXPECT_TRUE(w.window->messages().isVisible());
  EXPECT_TRUE(w.window->messages().accessibleName().contains("Exploration"));
  EXPECT_EQ(number->text(), "0.05");
}

TEST(ParameterForm, AChangedRowOffersResetAndSaysSinceWhen) {
  Window w;
  auto* slider = w.named<Slider>("Discount");
  slider->setValue(0);
  auto* reset = w.named<QToolButton>("Reset Discount to its default");
  EXPECT_TRUE(reset->isVisible());
  QTest::mouseClick(reset, Qt::LeftButton);
  EXPECT_EQ(w.session->configuration().parameters.get("agent.discount"), 0.98);
  EXPECT_FALSE(reset->isVisible());
}

TEST(ParameterForm, ANewTableIsAskedForBeforeItIsMade) {
  Window w;
  auto* number = w.named<QLineEdit>("Tilings, number");
  number->setFocus();
  number->selectAll();
  QTest::keyClicks(number, "8");
  QTest::keyClick(number, Qt::Key_Return);
  ASSERT_TRUE(w.window->messages().isVisible());
  EXPECT_EQ(number->text(), "16") << "nothing has changed yet";
  for (auto* button : w.window->messages().findChildren<QPushButton*>())
    if (button->text() == "Start again") QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(w.session->configuration().parameters.get("features.tilings"), 8);
  EXPECT_FALSE(w.window->messages().isVisible());
}

}  // namespace surefoot
