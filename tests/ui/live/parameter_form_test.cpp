// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/form/parameter_form.h"

#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTextDocument>
#include <QToolButton>

#include "core/formulas.h"
#include "tests/ui/window_setup.h"
#include "ui/controls/message_bar.h"
#include "ui/controls/slider.h"
#include "ui/live/form/parameter_row.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

TEST(ParameterForm, HasARowForEveryParameterThatHasAnEffect) {
  Window w;
  w.window->findChild<ParameterForm*>()->setShowAll(true);
  for (const char* schedule : {"policy.epsilon_schedule", "policy.threshold_schedule", "policy.temperature_schedule"})
    ASSERT_TRUE(w.session->editing().setParameter(schedule, 1));
  std::set<std::string> shown;
  for (const ParameterRow* row : w.window->findChildren<ParameterRow*>())
    if (!row->isHidden()) shown.insert(row->key());
  const Parameters& parameters = w.session->life().configuration().parameters;
  for (const auto& entry : parameters.all()) {
    EXPECT_EQ(shown.contains(entry.parameter.key), !parameters.idleBecauseOf(entry.parameter)) << entry.parameter.key;
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
  ASSERT_TRUE(w.session->editing().setParameter("policy.epsilon_schedule", 1));
  EXPECT_TRUE(shown("policy.epsilon_end"));
  EXPECT_TRUE(shown("policy.epsilon_per"));
  EXPECT_FALSE(shown("policy.threshold_end"));
}

TEST(ParameterForm, TheSliderReachesBothEndsExactly) {
  Window w;
  auto* slider = w.named<Slider>("Step size");
  slider->setValue(slider->maximum());
  EXPECT_EQ(w.session->life().configuration().parameters.get("agent.step_size"), 1.0);
  slider->setValue(slider->minimum());
  EXPECT_EQ(w.session->life().configuration().parameters.get("agent.step_size"), 0.0);
}

// From nothing to where a robot becomes too cautious to learn, in steps that are fine where falls are cheap.
TEST(ParameterForm, ThePriceOfAFallIsSetOnASensibleScale) {
  Window w;
  auto* slider = w.named<Slider>("Fall");
  const auto price = [&] { return w.session->life().configuration().parameters.get("environment.fall_reward"); };
  EXPECT_EQ(price(), -100);
  slider->setValue(slider->minimum());
  EXPECT_EQ(price(), -25'600);
  slider->setValue(slider->maximum());
  EXPECT_EQ(price(), 0);
  for (const double wanted : {-25.0, -100.0, -400.0, -1600.0, -6400.0}) {  // each about as far from the next
    ASSERT_TRUE(w.session->editing().setParameter("environment.fall_reward", wanted));
    QApplication::processEvents();
    const int at = slider->value();
    slider->setValue(at + 10), slider->setValue(at);
    EXPECT_NEAR(price() / wanted, 1, 0.05) << wanted << " can be set on the slider";
  }
  const auto placeOf = [&](double value) {
    EXPECT_TRUE(w.session->editing().setParameter("environment.fall_reward", value));
    QApplication::processEvents();
    return slider->value();
  };
  EXPECT_NEAR(placeOf(-400) - placeOf(-1600), placeOf(-1600) - placeOf(-6400), 0.02 * slider->maximum());
}

TEST(ParameterForm, ANumberCanBeTyped) {
  Window w;
  auto* number = w.named<QLineEdit>("Threshold, number");
  number->setFocus();
  number->selectAll();
  QTest::keyClicks(number, "-12.5");
  QTest::keyClick(number, Qt::Key_Return);
  EXPECT_EQ(w.session->life().configuration().parameters.get("policy.threshold"), -12.5);
}

TEST(ParameterForm, ATypedNumberOutOfRangeIsRefusedInASentence) {
  Window w;
  auto* number = w.named<QLineEdit>("Exploration, number");
  number->setFocus();
  number->selectAll();
  QTest::keyClicks(number, "7");
  QTest::keyClick(number, Qt::Key_Return);
  EXPECT_EQ(w.session->life().configuration().parameters.get("policy.epsilon"), 0.05);
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
  EXPECT_EQ(w.session->life().configuration().parameters.get("agent.discount"), 0.98);
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
  EXPECT_EQ(w.session->life().configuration().parameters.get("features.tilings"), 8);
  EXPECT_FALSE(w.window->messages().isVisible());
}

// What is below a row stays where it is: nobody hits the wrong one because of a change.
TEST(ParameterForm, AChangeMovesNothing) {
  Window w;
  std::map<std::string, QRect> before;
  for (const ParameterRow* row : w.window->findChildren<ParameterRow*>())
    if (row->isVisible()) before[row->key()] = row->geometry();
  ASSERT_GT(before.size(), 10u);
  w.named<Slider>("Discount")->setValue(0);
  w.named<Slider>("Exploration")->setValue(300);
  auto* number = w.named<QLineEdit>("Threshold, number");
  number->setFocus();
  QTest::keyClicks(number, "x");
  QTest::keyClick(number, Qt::Key_Return);
  QTest::qWait(20);
  for (const ParameterRow* row : w.window->findChildren<ParameterRow*>())
    if (row->isVisible()) {
      EXPECT_EQ(row->geometry(), before[row->key()]) << row->key();
    }
  EXPECT_TRUE(w.named<QToolButton>("Reset Discount to its default")->isVisible());
  EXPECT_TRUE(w.named<QToolButton>("Reset Discount to its default")->toolTip().contains("0.98"));
}

TEST(ParameterForm, ARefusedNumberIsToldAtItsRow) {
  Window w;
  const auto rowOf = [&](const char* name) {
    return qobject_cast<ParameterRow*>(w.named<QLineEdit>(name)->parentWidget());
  };
  const auto type = [&](const char* name, const char* text) {
    auto* number = w.named<QLineEdit>(name);
    number->setFocus();
    number->selectAll();
    number->insert(QString::fromUtf8(text));  // as from the clipboard
    QTest::keyClick(number, Qt::Key_Return);
  };
  type("Exploration, number", "7");
  EXPECT_EQ(rowOf("Exploration, number")->refusal(), "0 to 1");
  EXPECT_TRUE(w.named<QLineEdit>("Exploration, number")->accessibleDescription().contains("0 to 1"));
  type("Threshold, number", "1,5");
  EXPECT_EQ(rowOf("Threshold, number")->refusal(), "1.5 or 15?");
  type("Tilings, number", "2.5");
  EXPECT_EQ(rowOf("Tilings, number")->refusal(), "a whole number");
  type("Threshold, number", "1,000");
  EXPECT_EQ(w.session->life().configuration().parameters.get("policy.threshold"), 1000);
  EXPECT_EQ(rowOf("Threshold, number")->refusal(), "");
  type("Threshold, number", "\u22121,234.5");
  EXPECT_EQ(w.session->life().configuration().parameters.get("policy.threshold"), -1234.5);
}

// What a row shows can be typed into it again.
TEST(ParameterForm, WhatARowShowsItReads) {
  Window w;
  auto* number = w.named<QLineEdit>("Threshold, number");
  for (const double value : {-0.5, 12345.0, -99999.0, 1e6, 0.001, -0.00012, 123.456}) {
    ASSERT_TRUE(w.session->editing().setParameter("policy.threshold", value));
    const Result<double> read = parseNumber("shown", number->text().toStdString());
    ASSERT_TRUE(read) << number->text().toStdString();
    EXPECT_NEAR(*read, value, 0.05 * std::abs(value)) << number->text().toStdString();
  }
}

TEST(ParameterForm, TheNumberIsDraggedFinerThanTheSlider) {
  Window w;
  auto* slider = w.named<Slider>("Step size");
  EXPECT_GE(slider->width() - 14, 42) << "as long as it is drawn";
  auto* number = w.named<QLineEdit>("Step size, number");
  const auto value = [&] { return w.session->life().configuration().parameters.get("agent.step_size"); };
  ASSERT_EQ(value(), 0.4);
  const QPoint from(10, 8);
  QTest::mousePress(number, Qt::LeftButton, {}, from);
  QTest::mouseMove(number, from + QPoint(10, 0));
  EXPECT_NEAR(value(), 0.44, 1e-9) << "10 of 250 px";
  QTest::mouseMove(number, from + QPoint(400, 0));
  EXPECT_EQ(value(), 1.0);
  QTest::mouseRelease(number, Qt::LeftButton, {}, from + QPoint(400, 0));
  EXPECT_FALSE(number->hasFocus()) << "a drag is no click";
  QTest::mouseClick(number, Qt::LeftButton, {}, from);
  EXPECT_TRUE(number->hasFocus());
}

// Name, symbol, unit, range, formula and a sentence, for people: no "1e-06".
TEST(ParameterForm, EveryRowSaysWhatItIs) {
  Window w;
  w.window->findChild<ParameterForm*>()->setShowAll(true);
  for (const ParameterRow* row : w.window->findChildren<ParameterRow*>()) {
    const Parameter& p = w.session->life().configuration().parameters.find(row->key())->parameter;
    QTextDocument tip;
    tip.setHtml(row->toolTip());
    const QString text = tip.toPlainText();
    for (const std::string& part : {p.title, p.symbol, p.unit, p.help, p.origin, formulaOf(p)})
      EXPECT_TRUE(text.contains(toText(part))) << row->key() << ": " << text.toStdString();
    EXPECT_FALSE(text.contains(QRegularExpression("\\de[+-]\\d"))) << text.toStdString();
  }
}

}  // namespace surefoot
