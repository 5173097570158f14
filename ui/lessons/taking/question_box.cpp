// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/question_box.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QButtonGroup>
#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/lessons/taking/prediction_box.h"
#include "ui/lessons/taking/question_boxes.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

QLabel* makeHead(const QString& text, QWidget* parent) {
  auto* head = new QLabel(text.toUpper(), parent);
  head->setForegroundRole(QPalette::PlaceholderText);
  head->setAccessibleName(text);
  whenScaled(head, [head] {
    QFont font = scaledFont(11, 500);
    font.setLetterSpacing(QFont::PercentageSpacing, 106);
    head->setFont(font);
  });
  return head;
}

QuestionBox::QuestionBox(LessonDriver& driver, const QString& heading, QWidget* parent)
    : QWidget(parent),
      driver_(driver),
      column_(new QVBoxLayout(this)),
      verdict_(new QLabel(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
  whenScaled(this, [this] { column_->setSpacing(scaled(8)); });
  column_->addWidget(makeHead(heading, this));
  verdict_->setWordWrap(true);
  verdict_->setVisible(false);
  verdict_->setTextFormat(Qt::PlainText);
  whenScaled(verdict_, [this] { verdict_->setFont(scaledFont(13)); });
  connect(&driver_, &LessonDriver::judged, this, &QuestionBox::tell);
}

QLabel* QuestionBox::addQuestion(const QString& text) {
  auto* label = new QLabel(text, this);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  whenScaled(label, [label] { label->setFont(scaledFont(13, 500)); });
  column_->addWidget(label);
  return label;
}

QLabel* QuestionBox::addNote(const QString& text) {
  auto* label = new QLabel(text, this);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setForegroundRole(QPalette::PlaceholderText);
  whenScaled(label, [label] { label->setFont(scaledFont(11)); });
  column_->addWidget(label);
  return label;
}

void QuestionBox::tell(const LessonVerdict& verdict) {
  const QString remark = toText(verdict.remark);
  const QString text = verdict.right ? (remark.isEmpty() ? tr("✓ Right.") : tr("✓ Right. %1").arg(remark))
                                     : tr("Not yet. %1").arg(remark);
  verdict_->setText(text);
  verdict_->setVisible(true);
  Q_EMIT told(verdict_);
  QAccessibleEvent announced(verdict_, QAccessible::Alert);
  QAccessible::updateAccessibility(&announced);
}

bool QuestionBox::takeKey(QKeyEvent& event, const QButtonGroup& options) {
  if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) return check(), true;
  const int option = event.key() - Qt::Key_1;
  if (option < 0 || option >= options.buttons().size()) return false;
  options.button(option)->setChecked(true);
  options.button(option)->setFocus(Qt::ShortcutFocusReason);
  return true;
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
