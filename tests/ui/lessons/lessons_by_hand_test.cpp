// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons taken from the list to the end as a person does it: by mouse, and by keys alone.
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QScrollArea>

#include "tests/ui/lessons/lessons_setup.h"
#include "ui/controls/text_button.h"
#include "ui/lessons/lesson_details.h"
#include "ui/lessons/questions/option_button.h"
#include "ui/style/scale.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

/// What a hand needs to know of a step: what it asks, and the place of a right answer.
class Hand {
 public:
  explicit Hand(const QSize& size) { lessons_.window->resize(size); }
  virtual ~Hand() = default;

  /// From the list to the end, and back to the list.
  void take(const std::string& name) {
    SCOPED_TRACE(name);
    begin(name);
    ASSERT_TRUE(lessons_.page().view());
    const std::size_t steps = driver().lesson().steps.size();
    for (std::size_t step = 0; step < steps; ++step) {
      SCOPED_TRACE(step + 1);
      ASSERT_TRUE(lessons_.opens(step));
      const bool lives = driver().step().lives.has_value();
      ASSERT_TRUE(QTest::qWaitFor([&] { return !lives || !driver().lives().empty(); }, 60'000));
      QTest::qWait(60);  // for the layout, and the focus
      if (driver().step().predict)
        predict();
      else
        answerAndGoOn();
      if (testing::Test::HasFailure()) return;
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return driver().phase() == LessonDriver::Phase::Finished; }, 30'000));
    QTest::qWait(60);
    end();
    EXPECT_TRUE(QTest::qWaitFor([&] { return lessons_.page().view() == nullptr; }, 5'000)) << "back to the list";
    EXPECT_TRUE(handIn(name).finished());
  }
  HandIn handIn(const std::string& name) {
    const auto text = readText(lessons_.folder.filePath("lessons/%1.jsonl").arg(name.c_str()).toStdString());
    auto read = text ? parseHandIn(*text) : Result<HandIn>(text.error());
    return read ? std::move(*read) : HandIn{};
  }

 protected:
  virtual void begin(const std::string& name) = 0;
  virtual void predict() = 0;
  virtual void chooseRight() = 0;
  virtual void writeWords() = 0;
  virtual void writeNumber() = 0;
  virtual void press() = 0;  ///< what stands in the corner: Check, Keep it, Skip, Next
  virtual void end() = 0;

  LessonDriver& driver() { return lessons_.driver(); }
  template <class Widget>
  Widget* find(const std::function<bool(Widget&)>& is = [](Widget&) { return true; }) {
    for (Widget* one : lessons_.page().findChildren<Widget*>())
      if (one->isVisible() && is(*one)) return one;
    ADD_FAILURE() << "there is none on the page";
    return nullptr;
  }
  TextButton* button(const QString& words) {
    return find<TextButton>([&](TextButton& b) { return b.text().startsWith(words); });
  }
  Lessons lessons_;

 private:
  void answerAndGoOn() {
    const std::size_t step = driver().number();
    const auto& ask = driver().step().ask;
    if (ask && (std::holds_alternative<ChoiceQuestion>(*ask) || std::holds_alternative<CompareQuestion>(*ask)))
      chooseRight();
    if (ask && std::holds_alternative<WordsQuestion>(*ask)) writeWords();
    for (int tries = 0; tries < 4 && driver().number() == step && driver().phase() == LessonDriver::Phase::Open;
         ++tries) {
      if (ask && std::holds_alternative<NumberQuestion>(*ask) && !driver().answered()) writeNumber();
      press();
      QTest::qWait(60);
    }
    const bool leads = driver().number() > step || driver().phase() != LessonDriver::Phase::Open;
    EXPECT_TRUE(leads) << "the lesson goes on";
  }
};

class ByMouse : public Hand {
 public:
  using Hand::Hand;

 protected:
  /// A click where the widget is; whatever lies over it would take it.
  void click(QWidget* widget) {
    ASSERT_TRUE(widget);
    for (QWidget* up = widget->parentWidget(); up; up = up->parentWidget())
      if (auto* scroll = qobject_cast<QScrollArea*>(up)) scroll->ensureWidgetVisible(widget);
    QTest::qWait(20);
    const QPoint at = widget->mapTo(lessons_.window.get(), widget->rect().center());
    QWidget* hit = lessons_.window->childAt(at);
    ASSERT_TRUE(hit == widget || widget->isAncestorOf(hit)) << "something lies over it, or it is out of sight";
    QTest::mouseClick(widget, Qt::LeftButton);
  }
  void begin(const std::string& name) override {
    const auto& all = lessons_.page().lessons();
    int row = -1;
    for (int r = 0; r < lessons_.page().list().model()->rowCount(); ++r)
      for (const ShelvedLesson& one : all)
        if (one.lesson && one.lesson->name == name &&
            lessons_.page()
                .list()
                .model()
                ->index(r, 0)
                .data(Qt::AccessibleTextRole)
                .toString()
                .contains(QString::fromStdString(one.lesson->title)))
          row = r;
    ASSERT_GE(row, 0);
    LessonList& list = lessons_.page().list();
    const QModelIndex index = list.model()->index(row, 0);
    for (QWidget* up = list.parentWidget(); up; up = up->parentWidget())
      if (auto* scroll = qobject_cast<QScrollArea*>(up)) {
        const QPoint at = list.viewport()->mapTo(scroll->widget(), list.visualRect(index).center());
        scroll->ensureVisible(at.x(), at.y());
      }
    list.scrollTo(index);
    QTest::qWait(30);
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(index).center());
    QTest::qWait(30);
    ASSERT_EQ(all[static_cast<std::size_t>(list.chosen())].lesson->name, name) << "a click on the row chooses it";
    auto* details = find<LessonDetails>();
    for (TextButton* b : details->findChildren<TextButton*>())
      if (b->text() == "Start") return click(b);
    FAIL() << "nothing starts it";
  }
  void predict() override { click(button("Commit")); }
  void chooseRight() override {
    const auto& ask = *driver().step().ask;
    const auto* choice = std::get_if<ChoiceQuestion>(&ask);
    const Compared compared = choice ? Compared::CannotTell : compare(driver().lives()[0], driver().lives()[1]).answer;
    const int right = choice ? static_cast<int>(choice->answer) : static_cast<int>(compared);
    int at = 0;
    click(find<OptionButton>([&](OptionButton&) { return at++ == right; }));
  }
  void writeWords() override {
    auto* words = find<QPlainTextEdit>();
    click(words);
    QTest::keyClicks(words, "it depends");
  }
  void writeNumber() override {
    auto* number = find<QLineEdit>([](QLineEdit& e) { return e.height() >= scaled(30); });
    click(number);
    number->selectAll();
    QTest::keyClicks(number, "3");
  }
  void press() override {
    for (const char* words : {"Check", "Keep it", "Skip", "Finish", "Next"})
      for (TextButton* b : lessons_.page().findChildren<TextButton*>())
        if (b->isVisible() && b->isEnabled() && b->text() == words) return click(b);
    ADD_FAILURE() << "no button leads on";
  }
  void end() override { click(button("All lessons")); }
};

class ByKeys final : public Hand {
 public:
  using Hand::Hand;

 private:
  void begin(const std::string& name) override {
    const auto& all = lessons_.page().lessons();
    lessons_.page().list().setFocus();
    lessons_.key(Qt::Key_Home);
    for (const ShelvedLesson& one : all) {
      if (one.lesson && one.lesson->name == name) break;
      lessons_.key(Qt::Key_Down);
    }
    lessons_.key(Qt::Key_Return);
  }
  void predict() override {
    QTest::keyClicks(lessons_.window->focusWidget(), "12");
    lessons_.key(Qt::Key_Return);
  }
  void chooseRight() override {
    const auto* choice = std::get_if<ChoiceQuestion>(&*driver().step().ask);
    const Compared compared = choice ? Compared::CannotTell : compare(driver().lives()[0], driver().lives()[1]).answer;
    lessons_.key(Qt::Key_1 + (choice ? static_cast<int>(choice->answer) : static_cast<int>(compared)));
  }
  void writeWords() override { QTest::keyClicks(lessons_.window->focusWidget(), "it depends"); }
  void writeNumber() override {
    auto* number = qobject_cast<QLineEdit*>(lessons_.window->focusWidget());
    ASSERT_TRUE(number) << "the focus is where one types";
    lessons_.key(Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(number, "3");
  }
  void press() override { lessons_.key(Qt::Key_Right, Qt::AltModifier); }
  void end() override {
    // The focus is on the last button, "All lessons".
    lessons_.key(Qt::Key_Space);
  }
};

}  // namespace

TEST(LessonsByHand, OfAChainByMouse) {
  ByMouse({1366, 768}).take("what-is-a-state-worth");
}

TEST(LessonsByHand, OfThePendulumByMouseAt720Lines) {
  ByMouse({1280, 720}).take("temperature");
}

TEST(LessonsByHand, InTheDarkWithTextsTwiceAsLarge) {
  applyAppearance(*qApp, Appearance::Dark);
  applyTextSize(2);
  ByMouse({1280, 720}).take("exploring-costs-falls");
  applyTextSize(1);
  applyAppearance(*qApp, Appearance::Light);
}

TEST(LessonsByHand, ByKeysAlone) {
  ByKeys hand({1280, 800});
  hand.take("exploring-costs-falls");
  const HandIn done = hand.handIn("exploring-costs-falls");
  ASSERT_TRUE(done.last(LessonMark::Kind::Words, 5));
  EXPECT_EQ(done.last(LessonMark::Kind::Words, 5)->text, "it depends");
  EXPECT_TRUE(done.last(LessonMark::Kind::Answered, 2)->right);
}

}  // namespace surefoot
