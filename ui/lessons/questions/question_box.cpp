// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/questions/question_box.h"

#include <QLabel>
#include <QPlainTextEdit>
#include <QVBoxLayout>

#include "ui/controls/labels.h"
#include "ui/lessons/questions/option_boxes.h"
#include "ui/lessons/questions/prediction_box.h"
#include "ui/lessons/questions/question_boxes.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/support/announce.h"

namespace surefoot {

QuestionBox::QuestionBox(LessonDriver& driver, const QString& heading, QWidget* parent)
    : QWidget(parent),
      driver_(driver),
      column_(new QVBoxLayout(this)),
      verdict_(makeText({}, 13, 400, false, this)) {
  column_->setContentsMargins(0, 0, 0, 0);
  whenScaled(this, [this] { column_->setSpacing(scaled(8)); });
  column_->addWidget(makeHead(heading, this));
  verdict_->setWordWrap(true);
  verdict_->setVisible(false);
  connect(&driver_, &LessonDriver::judged, this, &QuestionBox::tell);
}

QLabel* QuestionBox::addQuestion(const QString& text) {
  return addText(text, 13, 500, false);
}

QLabel* QuestionBox::addNote(const QString& text) {
  return addText(text, 11, 400, true);
}

QLabel* QuestionBox::addText(const QString& text, int pixels, int weight, bool quiet) {
  QLabel* label = makeText(unbroken(text), pixels, weight, quiet, this);
  label->setWordWrap(true);
  column_->addWidget(label);
  return label;
}

QPlainTextEdit* QuestionBox::addWords(int lines, const QString& name) {
  auto* edit = new QPlainTextEdit(this);
  edit->setTabChangesFocus(true);
  edit->setAccessibleName(name);
  whenScaled(edit, [edit, lines] {
    edit->setFont(scaledFont(13));
    edit->setFixedHeight(scaled(16 + 20 * lines));
  });
  column_->addWidget(edit);
  return edit;
}

void QuestionBox::tell(const LessonVerdict& verdict) {
  const QString remark = toText(verdict.remark);
  const QString text = verdict.right ? (remark.isEmpty() ? tr("✓ Right.") : tr("✓ Right. %1").arg(remark))
                                     : tr("Not yet. %1").arg(remark);
  verdict_->setText(unbroken(text));
  verdict_->setVisible(true);
  Q_EMIT told(verdict_);
  announce(*verdict_, text);
}

QuestionBox* makeQuestion(LessonDriver& driver, QWidget* parent) {
  const LessonStep& step = driver.step();
  if (step.predict) return new PredictionBox(driver, parent);
  if (step.done) return new TaskBox(driver, parent);
  if (!step.ask) return nullptr;
  struct Make {
    LessonDriver& driver;
    QWidget* parent;
    QuestionBox* operator()(const NumberQuestion& q) const { return new NumberBox(driver, q, parent); }
    QuestionBox* operator()(const ChoiceQuestion& q) const { return new ChoiceBox(driver, q, parent); }
    QuestionBox* operator()(const OrderQuestion& q) const { return new OrderBox(driver, q, parent); }
    QuestionBox* operator()(const PointQuestion& q) const { return new PointBox(driver, q, parent); }
    QuestionBox* operator()(const WordsQuestion& q) const { return new WordsBox(driver, q, parent); }
    QuestionBox* operator()(const CompareQuestion& q) const { return new CompareBox(driver, q, parent); }
  };
  return std::visit(Make{driver, parent}, *step.ask);
}

}  // namespace surefoot

#include "moc_question_box.cpp"
