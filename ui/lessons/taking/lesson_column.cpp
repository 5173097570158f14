// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/lesson_column.h"

#include <QAbstractSpinBox>
#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>
#include <cmath>

#include "core/text/text.h"
#include "ui/controls/hairline.h"
#include "ui/controls/link_button.h"
#include "ui/controls/text_button.h"
#include "ui/lessons/taking/knob_rows.h"
#include "ui/lessons/taking/lesson_text.h"
#include "ui/lessons/taking/question_box.h"
#include "ui/lessons/taking/step_dots.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr int kProgressEvery = 100;  // [ms]

void announce(QWidget* about, const QString& text) {
  about->setAccessibleDescription(text);
  QAccessibleEvent event(about, QAccessible::Alert);
  QAccessible::updateAccessibility(&event);
}

QString numberText(double value) {
  return toText(lessonNumber(value));
}

}  // namespace

LessonColumn::LessonColumn(LessonDriver& driver, QWidget* parent)
    : QWidget(parent),
      driver_(driver),
      title_(new QLabel(toText(driver.lesson().title), this)),
      number_(new QLabel(this)),
      dots_(new StepDots(this)),
      scroll_(new QScrollArea(this)) {
  auto* column = new QVBoxLayout(this);
  whenScaled(this, [this, column] {
    column->setContentsMargins(scaled({12, 8, 12, 8}));
    column->setSpacing(scaled(8));
    title_->setFont(scaledFont(13, 500));
    number_->setFont(scaledFont(11));
  });
  number_->setForegroundRole(QPalette::PlaceholderText);
  title_->setWordWrap(true);
  title_->setTextFormat(Qt::PlainText);
  auto* head = new QHBoxLayout;
  head->addWidget(title_, 1);
  head->addWidget(number_);
  column->addLayout(head);
  column->addWidget(dots_);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(scroll_, 1);
  makeFoot(*column);
  connect(&driver_, &LessonDriver::stepChanged, this, &LessonColumn::showStep);
  connect(&driver_, &LessonDriver::phaseChanged, this, &LessonColumn::refresh);
  connect(&driver_, &LessonDriver::judged, this, &LessonColumn::refresh);
  connect(&driver_, &LessonDriver::taskChanged, this, &LessonColumn::refresh);
  connect(&driver_, &LessonDriver::livesChanged, this, &LessonColumn::refresh);
  connect(&driver_, &LessonDriver::textChanged, this, [this] {
    if (!text_) return;
    text_->show(driver_.text());
    focusFirst();
  });
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, [this] {
    if (progress_ && driver_.phase() == LessonDriver::Phase::Running && driver_.progress() > 0)
      progress_->setText(tr("%1 % lived").arg(static_cast<int>(100 * std::min(driver_.progress(), 1.0))));
  });
  timer->start(kProgressEvery);
}

void LessonColumn::makeFoot(QVBoxLayout& column) {
  auto* links = new QHBoxLayout;
  hintLink_ = new LinkButton(tr("Hint"), this);
  reset_ = new LinkButton(tr("Reset step"), this);
  explore_ = new LinkButton(tr("Explore freely"), this);
  hintLink_->setToolTip(tr("A hint, if the step has one (F1)"));
  reset_->setToolTip(tr("The step begins again, as it was"));
  explore_->setToolTip(tr("The Live page with this robot as it is now; the lesson waits here"));
  links->addWidget(hintLink_);
  links->addStretch(1);
  links->addWidget(reset_);
  links->addStretch(1);
  links->addWidget(explore_);
  column.addLayout(links);
  auto* buttons = new QHBoxLayout;
  back_ = new TextButton(tr("Back"), TextButton::Look::Framed, this);
  next_ = new TextButton(tr("Next"), TextButton::Look::Main, this);
  back_->setToolTip(tr("The step before (Alt+←)"));
  next_->setToolTip(tr("Go on (Alt+→)"));
  buttons->addWidget(back_);
  buttons->addStretch(1);
  buttons->addWidget(next_);
  column.addLayout(buttons);
  connect(hintLink_, &QToolButton::clicked, this, &LessonColumn::showHint);
  connect(reset_, &QToolButton::clicked, &driver_, &LessonDriver::resetStep);
  connect(explore_, &QToolButton::clicked, this, &LessonColumn::exploreAsked);
  connect(back_, &QAbstractButton::clicked, this, &LessonColumn::goBack);
  connect(next_, &QAbstractButton::clicked, this, &LessonColumn::goOn);
}

QVBoxLayout& LessonColumn::anew() {
  auto* content = new QWidget;
  column_ = new QVBoxLayout(content);
  column_->setContentsMargins(0, 0, 0, 0);
  whenScaled(content, [column = column_] { column->setSpacing(scaled(8)); });
  scroll_->setWidget(content);  // deletes the one before
  content_ = content;
  return *column_;
}

QLabel* LessonColumn::addText(const QString& text, int pixels, int weight) {
  auto* label = new QLabel(text, content_);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  whenScaled(label, [label, pixels, weight] { label->setFont(scaledFont(pixels, weight)); });
  column_->addWidget(label);
  return label;
}

void LessonColumn::addLine() {
  column_->addWidget(new Hairline(Qt::Horizontal, content_));
}

/// "You said 40, it fell 71 times": what the step before predicted, and what came out.
void LessonColumn::showResult() {
  const std::size_t before = driver_.number() - 1;
  const auto said = driver_.predicted(before), came = driver_.observed(before);
  const LessonStep& step = driver_.lesson().steps[before];
  if (!step.predict || !said || !came) return;
  const QString unit = toText(step.predict->unit);
  const double difference = std::abs(*came - *said), range = step.predict->high - step.predict->low;
  auto* row = new QHBoxLayout;
  const auto word = [&](const QString& text, bool large, bool fall) {
    auto* label = new QLabel(text, content_);
    label->setTextFormat(Qt::PlainText);
    whenScaled(label, [label, large] { label->setFont(scaledFont(large ? 24 : 13, large ? 500 : 400)); });
    if (fall) {
      QPalette palette = label->palette();
      palette.setColor(QPalette::WindowText, themeOf(*this).fallText);
      label->setPalette(palette);
    }
    row->addWidget(label, 0, Qt::AlignBottom);
  };
  word(tr("You said"), false, false);
  word(numberText(*said), true, false);
  word(tr("it came to"), false, false);
  word(numberText(*came), true, step.predict->of.text == "falls");
  if (!unit.isEmpty()) word(unit + '.', false, false);
  row->addStretch(1);
  column_->addLayout(row);
  const QString sentence = difference <= 0.02 * range ? tr("Very close.")
                           : *came > *said            ? tr("%1 more than you said.").arg(numberText(difference))
                                                      : tr("%1 fewer than you said.").arg(numberText(difference));
  auto* label = addText(sentence, 11, 400);
  label->setForegroundRole(QPalette::PlaceholderText);
  announce(label, tr("You said %1. It came to %2 %3. %4").arg(numberText(*said), numberText(*came), unit, sentence));
}

void LessonColumn::showStep() {
  if (driver_.phase() == LessonDriver::Phase::Finished) return showEnd();
  const Lesson& lesson = driver_.lesson();
  const LessonStep& step = driver_.step();
  number_->setText(tr("step %1 of %2").arg(driver_.number() + 1).arg(lesson.steps.size()));
  dots_->show(driver_.number(), lesson.steps.size());
  anew();
  if (driver_.number() > 0) showResult();
  text_ = new MarkdownView(content_);
  text_->show(driver_.text());
  connect(text_, &MarkdownView::lessonAsked, this, &LessonColumn::lessonAsked);
  column_->addWidget(text_);
  progress_ = addText({}, 11, 400);
  progress_->setForegroundRole(QPalette::PlaceholderText);
  question_ = makeQuestion(driver_, content_);
  if (question_) {
    addLine();
    column_->addWidget(question_);
    connect(question_, &QuestionBox::predictionMoved, this, &LessonColumn::predictionMoved);
    connect(question_, &QuestionBox::told, this, [this](QWidget* verdict) {
      // When it has its place: what was said about the answer is always in sight.
      QTimer::singleShot(0, verdict, [this, verdict] { scroll_->ensureWidgetVisible(verdict, 0, scaled(16)); });
      if (driver_.answered() && next_->isVisible()) next_->setFocus(Qt::OtherFocusReason);
    });
  }
  hint_ = addText(toText(step.hint), 13, 400);
  hint_->hide();
  auto* knobs = new KnobRows(driver_.session(), step.show, content_);
  knobs_ = knobs;
  connect(knobs, &KnobRows::refused, this, &LessonColumn::refused);
  if (!knobs->empty()) {
    addLine();
    column_->addWidget(makeHead(knobs->count() == 1 ? tr("Knob") : tr("Knobs"), content_));
  }
  column_->addWidget(knobs);
  if (const QString words = willMove(); !words.isEmpty() && !driver_.predicted(driver_.number()))
    addText(words, 11, 400)->setForegroundRole(QPalette::PlaceholderText);
  knobs->setVisible(!knobs->empty());
  column_->addStretch(1);
  announce(this, tr("Step %1 of %2: %3").arg(driver_.number() + 1).arg(lesson.steps.size()).arg(toText(step.title)));
  refresh();
}

/// "ε becomes 0.25 when you commit": what a prediction does to the knobs.
QString LessonColumn::willMove() const {
  QStringList words;
  if (!driver_.step().predict) return {};
  for (const LessonAction& action : driver_.step().predict->then) {
    const auto* entry = driver_.session().life().configuration().parameters.find(action.key);
    if (action.kind != LessonAction::Kind::Set || !entry) continue;
    const std::string& symbol = entry->parameter.symbol;
    words << tr("%1 becomes %2").arg(toText(symbol.empty() ? entry->parameter.title : symbol), toText(action.value));
  }
  return words.isEmpty() ? QString() : tr("%1 when you commit").arg(words.join(QStringLiteral(", ")));
}

/// All steps are done: what one knows now, own words beside the model answers, and where to go on.
void LessonColumn::showEnd() {
  const Lesson& lesson = driver_.lesson();
  number_->setText(tr("done"));
  dots_->show(lesson.steps.size(), lesson.steps.size());
  anew();
  column_->addWidget(makeHead(tr("You know now"), content_));
  addText(toText(lesson.goal), 13, 400);
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const auto* asked = lesson.steps[i].ask ? std::get_if<WordsQuestion>(&*lesson.steps[i].ask) : nullptr;
    const LessonMark* words = driver_.handIn().last(LessonMark::Kind::Words, i);
    if (!asked || !words || words->text.empty()) continue;
    addLine();
    column_->addWidget(makeHead(tr("In your words"), content_));
    addText(toText(words->text), 13, 400);
    column_->addWidget(makeHead(tr("One answer"), content_));
    addText(toText(asked->model), 13, 400);
  }
  addLine();
  if (!nextName_.isEmpty()) {
    auto* on = new TextButton(tr("Next: %1").arg(nextTitle_), TextButton::Look::Main, content_);
    connect(on, &QAbstractButton::clicked, this, [this] { Q_EMIT lessonAsked(nextName_); });
    column_->addWidget(on);
  }
  auto* next = new TextButton(tr("All lessons"),
                              nextName_.isEmpty() ? TextButton::Look::Main : TextButton::Look::Framed, content_);
  whenScaled(next, [next] { next->setFixedHeight(scaled(32)); });
  connect(next, &QAbstractButton::clicked, this, &LessonColumn::nextLessonAsked);
  column_->addWidget(next);
  column_->addStretch(1);
  QTimer::singleShot(0, next, [next] { next->setFocus(Qt::OtherFocusReason); });
  announce(this, tr("The lesson is done. You know now: %1").arg(toText(lesson.goal)));
  refresh();
}

void LessonColumn::focusFirst() {
  QWidget* home = question_ ? question_->first() : next_;
  QWidget* now = window()->focusWidget();
  if (now && content_ && content_->isAncestorOf(now) && now != home && driver_.tries() > 0) return;
  if (!isVisible() || driver_.phase() != LessonDriver::Phase::Open) return;
  home->setFocus(Qt::OtherFocusReason);
  if (auto* number = qobject_cast<QAbstractSpinBox*>(home)) number->selectAll();
}

void LessonColumn::refresh() {
  using Phase = LessonDriver::Phase;
  if (knobs_ && driver_.phase() == Phase::Open) knobs_->takeBase();
  if (driver_.phase() == Phase::Finished && number_->text() != tr("done")) return showEnd();
  const bool finished = driver_.phase() == Phase::Finished,
             last = driver_.number() + 1 == driver_.lesson().steps.size();
  const bool asks = question_ && !question_->nextWord().isEmpty() && !driver_.answered();
  const bool pointing = driver_.step().ask && !driver_.answered() && !asks;
  const bool task = (driver_.step().done && !driver_.taskDone()) || pointing;
  back_->setEnabled(driver_.number() > 0 || finished);
  next_->setVisible(!finished && (!driver_.step().predict || driver_.mayGoOn()));
  next_->setText(asks ? question_->nextWord() : task ? tr("Skip") : last ? tr("Finish") : tr("Next"));
  next_->setLook(task ? TextButton::Look::Framed : TextButton::Look::Main);
  next_->updateGeometry();
  next_->setEnabled(driver_.phase() == Phase::Open);
  hintLink_->setVisible(!finished && !driver_.step().hint.empty());
  reset_->setVisible(!finished);
  explore_->setVisible(!finished);
  reset_->setEnabled(driver_.phase() != Phase::Preparing);
  if (progress_) {
    const bool lives = driver_.step().lives && driver_.lives().empty();
    progress_->setText(driver_.phase() == Phase::Preparing ? tr("It is being made ready …")
                       : driver_.phase() == Phase::Running ? tr("It is being lived …")
                       : lives                             ? tr("The lives are being lived …")
                                                           : QString());
    progress_->setVisible(!progress_->text().isEmpty());
  }
}

void LessonColumn::goOn() {
  if (driver_.phase() != LessonDriver::Phase::Open || !next_->isVisible()) return;
  if (question_ && !question_->nextWord().isEmpty() && !driver_.answered()) return question_->check();
  driver_.next();
}

void LessonColumn::goBack() {
  if (back_->isEnabled()) driver_.back();
}

void LessonColumn::showHint() {
  if (!hint_ || driver_.step().hint.empty()) return;
  driver_.takeHint();
  hint_->setVisible(true);
  announce(hint_, hint_->text());
}

}  // namespace surefoot

#include "moc_lesson_column.cpp"
