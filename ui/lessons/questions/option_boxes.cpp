// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/questions/option_boxes.h"

#include <QButtonGroup>
#include <QKeyEvent>
#include <QLabel>
#include <QPlainTextEdit>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/lessons/questions/option_button.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

void OptionsBox::addOptions(const QStringList& options) {
  options_ = new QButtonGroup(this);
  for (const QString& option : options) {
    auto* button = new OptionButton(option, this);
    options_->addButton(button, static_cast<int>(options_->buttons().size()));
    column().addWidget(button);
  }
  setFirst(options_->button(0));
  setNextWord(tr("Check"));
}

int OptionsBox::chosen() const {
  return options_->checkedId();
}

void OptionsBox::choose(int option) {
  if (QAbstractButton* button = options_->button(option)) button->setChecked(true), setFirst(button);
}

void OptionsBox::keepWhenChosen(const std::function<void()>& keep) {
  connect(options_, &QButtonGroup::idToggled, this, [this, keep](int, bool on) {
    if (!on) return;
    verdict_->hide();  // it was about another one
    keep();
  });
}

void OptionsBox::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return check();
  QAbstractButton* button = options_->button(event->key() - Qt::Key_1);
  if (!button) return QuestionBox::keyPressEvent(event);
  button->setChecked(true);
  button->setFocus(Qt::ShortcutFocusReason);
}

ChoiceBox::ChoiceBox(LessonDriver& driver, const ChoiceQuestion& question, QWidget* parent)
    : OptionsBox(driver, question.mistake ? tr("Find the mistake") : tr("Your answer"), parent) {
  addQuestion(toText(question.question));
  QStringList options;
  for (const std::string& option : question.options) options << toText(option);
  addOptions(options);
  const LessonDraft before = driver.draft();
  choose(QString::fromStdString(before.answer).toInt() - 1);
  if (question.because) {
    addNote(tr("because … one sentence, your own words"));
    because_ = addWords(2, tr("Because"));
    because_->setPlainText(toText(before.because));
    connect(because_, &QPlainTextEdit::textChanged, this, [this] { keep(); });
  }
  keepWhenChosen([this] { keep(); });
  column().addWidget(verdict_);
  if (driver.answered() && chosen() >= 0) tell(judge(question, static_cast<std::size_t>(chosen())));
}

void ChoiceBox::keep() {
  driver_.keepDraft({chosen() < 0 ? std::string() : std::to_string(chosen() + 1),
                     because_ ? because_->toPlainText().toStdString() : std::string()});
}

void ChoiceBox::check() {
  if (chosen() < 0) return tell({false, tr("Choose one first.").toStdString()});
  driver_.choose(static_cast<std::size_t>(chosen()), because_ ? because_->toPlainText() : QString());
}

CompareBox::CompareBox(LessonDriver& driver, const CompareQuestion& question, QWidget* parent)
    : OptionsBox(driver, tr("Compare"), parent) {
  addQuestion(toText(question.question));
  const LessonLives& lives = *driver.step().lives;
  addOptions({toText(lives.ways.at(0).title), toText(lives.ways.at(1).title), tr("One cannot tell from these lives")});
  const auto& names = LessonDriver::kComparedNames;
  choose(static_cast<int>(std::find(names.begin(), names.end(), driver.draft().answer) - names.begin()));
  keepWhenChosen([this] {
    driver_.keepDraft({LessonDriver::kComparedNames.at(static_cast<std::size_t>(chosen())), {}});
  });
  column().addWidget(verdict_);
}

void CompareBox::check() {
  if (driver_.lives().empty()) return tell({false, tr("The lives are still being lived.").toStdString()});
  if (chosen() < 0) return tell({false, tr("Choose one first.").toStdString()});
  driver_.compared(static_cast<Compared>(chosen()));
}

}  // namespace surefoot
