// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/lesson_end.h"

#include <QTimer>
#include <QVBoxLayout>

#include "ui/controls/hairline.h"
#include "ui/controls/labels.h"
#include "ui/controls/text_button.h"
#include "ui/lessons/driver/lesson_driver.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

LessonEnd::LessonEnd(const LessonDriver& driver, const QString& name, const QString& title, QWidget* parent)
    : QWidget(parent),
      column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
  whenScaled(this, [this] { column_->setSpacing(scaled(8)); });
  const Lesson& lesson = driver.lesson();
  add(tr("You know now"), lesson.goal);
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const auto* asked = lesson.steps[i].ask ? std::get_if<WordsQuestion>(&*lesson.steps[i].ask) : nullptr;
    const LessonMark* words = driver.handIn().last(LessonMark::Kind::Words, i);
    if (!asked || !words || words->text.empty()) continue;
    addLine();
    add(tr("In your words"), words->text);
    add(tr("One answer"), asked->model);
  }
  addLine();
  if (!name.isEmpty()) {
    auto* on = new TextButton(tr("Next: %1").arg(title), TextButton::Look::Main, this);
    connect(on, &QAbstractButton::clicked, this, [this, name] { Q_EMIT lessonAsked(name); });
    column_->addWidget(on);
  }
  auto* all =
      new TextButton(tr("All lessons"), name.isEmpty() ? TextButton::Look::Main : TextButton::Look::Framed, this);
  whenScaled(all, [all] { all->setFixedHeight(scaled(32)); });
  connect(all, &QAbstractButton::clicked, this, &LessonEnd::allLessonsAsked);
  column_->addWidget(all);
  QTimer::singleShot(0, all, [all] { all->setFocus(Qt::OtherFocusReason); });
}

void LessonEnd::add(const QString& head, const std::string& text) {
  column_->addWidget(makeHead(head, this));
  QLabel* label = makeText(toText(text), 13, 400, false, this);
  label->setWordWrap(true);
  column_->addWidget(label);
}

void LessonEnd::addLine() {
  column_->addWidget(new Hairline(Qt::Horizontal, this));
}

}  // namespace surefoot

#include "moc_lesson_end.cpp"
