// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/lesson_column.h"

#include <QAbstractSpinBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "ui/controls/hairline.h"
#include "ui/controls/labels.h"
#include "ui/controls/link_button.h"
#include "ui/controls/text_button.h"
#include "ui/language/from_core.h"
#include "ui/lessons/questions/question_box.h"
#include "ui/lessons/taking/knob_rows.h"
#include "ui/lessons/taking/lesson_end.h"
#include "ui/lessons/taking/lesson_text.h"
#include "ui/lessons/taking/prediction_result.h"
#include "ui/lessons/taking/step_dots.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/support/announce.h"

namespace surefoot {

namespace {

constexpr int kProgressEvery = 100;  // [ms]

}  // namespace

LessonColumn::LessonColumn(LessonDriver& driver, QWidget* parent)
    : QWidget(parent),
      driver_(driver),
      title_(makeText(toText(driver.lesson().title), 13, 500, false, this)),
      number_(makeText({}, 11, 400, true, this)),
      dots_(new StepDots(this)),
      scroll_(new QScrollArea(this)) {
  auto* column = new QVBoxLayout(this);
  whenScaled(this, [this, column] {
    column->setContentsMargins(scaled({12, 8, 12, 8}));
    column->setSpacing(scaled(8));
  });
  title_->setWordWrap(true);
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

QLabel* LessonColumn::addText(const QString& text, int pixels, bool quiet) {
  QLabel* label = makeText(text, pixels, 400, quiet, content_);
  label->setWordWrap(true);
  column_->addWidget(label);
  return label;
}

void LessonColumn::addLine() {
  column_->addWidget(new Hairline(Qt::Horizontal, content_));
}

void LessonColumn::showStep() {
  if (driver_.phase() == LessonDriver::Phase::Finished) return showEnd();
  const Lesson& lesson = driver_.lesson();
  const LessonStep& step = driver_.step();
  number_->setText(tr("step %1 of %2").arg(driver_.number() + 1).arg(lesson.steps.size()));
  dots_->show(driver_.number(), lesson.steps.size());
  anew();
  if (PredictionResult::there(driver_)) column_->addWidget(new PredictionResult(driver_, content_));
  QLabel* heading = makeText(toText(step.title), 13, 500, false, content_);
  heading->setWordWrap(true);
  column_->addWidget(heading);
  text_ = new MarkdownView(content_);
  text_->show(driver_.text());
  connect(text_, &MarkdownView::lessonAsked, this, &LessonColumn::lessonAsked);
  column_->addWidget(text_);
  progress_ = addText({}, 11, true);
  question_ = makeQuestion(driver_, content_);
  if (question_) {
    addLine();
    column_->addWidget(question_);
    connect(question_, &QuestionBox::predictionMoved, this, &LessonColumn::predictionMoved);
    connect(question_, &QuestionBox::told, this, [this](QWidget* verdict) {
      // When it has its place: what was said about the answer is always in sight.
      for (const int later : {0, 60})
        QTimer::singleShot(later, verdict, [this, verdict] { scroll_->ensureWidgetVisible(verdict, 0, scaled(16)); });
      if (driver_.answered() && next_->isVisible()) next_->setFocus(Qt::OtherFocusReason);
    });
  }
  hint_ = addText(toText(step.hint), 13, false);
  hint_->hide();
  auto* knobs = new KnobRows(driver_.session(), step.show, lesson.ranges, content_);
  knobs_ = knobs;
  knobs->setEnabled(!step.predict);  // who predicts does not try it first
  connect(knobs, &KnobRows::refused, this, &LessonColumn::refused);
  if (!knobs->empty()) {
    addLine();
    column_->addWidget(makeHead(knobs->count() == 1 ? tr("Knob") : tr("Knobs"), content_));
  }
  column_->addWidget(knobs);
  if (const QString words = willMove(); !words.isEmpty() && !driver_.predicted(driver_.number()))
    addText(words, 11, true);
  knobs->setVisible(!knobs->empty());
  column_->addStretch(1);
  orderTabs();
  announce(*this, tr("Step %1 of %2: %3").arg(driver_.number() + 1).arg(lesson.steps.size()).arg(toText(step.title)));
  refresh();
}

/// Tab goes from the question to what gives the answer, and then to what is at hand besides.
void LessonColumn::orderTabs() {
  QWidget* before = nullptr;
  const auto add = [&before](QWidget* next) {
    if (before) setTabOrder(before, next);
    before = next;
  };
  for (QWidget* part : content_->findChildren<QWidget*>())
    if (part->focusPolicy() & Qt::TabFocus) add(part);
  for (QWidget* part : {static_cast<QWidget*>(next_), static_cast<QWidget*>(back_), static_cast<QWidget*>(hintLink_),
                        static_cast<QWidget*>(reset_), static_cast<QWidget*>(explore_)})
    add(part);
}

/// "ε becomes 0.25 when you commit": what a prediction does to the knobs.
QString LessonColumn::willMove() const {
  if (!driver_.step().predict) return {};
  const Parameters& now = driver_.session().life().configuration().parameters;
  std::map<std::string, std::string> last;  // what a key comes to in the end
  for (const LessonAction& action : driver_.step().predict->then)
    if (action.kind == LessonAction::Kind::Set) last[action.key] = action.value;
  QStringList words;
  for (const auto& [key, value] : last) {
    const auto* entry = now.find(key);
    const auto& show = driver_.step().show;
    if (!entry || std::find(show.begin(), show.end(), key) == show.end() ||
        toText(formatValue(entry->parameter, entry->value)) == toText(value))
      continue;
    const std::string& symbol = entry->parameter.symbol;
    words << tr("%1 becomes %2").arg(fromCore(symbol.empty() ? entry->parameter.title : symbol), toText(value));
  }
  return words.isEmpty() ? QString() : tr("%1 when you commit").arg(words.join(QStringLiteral(", ")));
}

void LessonColumn::showEnd() {
  const std::size_t steps = driver_.lesson().steps.size();
  number_->setText(tr("done"));
  dots_->show(steps, steps);
  anew();
  auto* end = new LessonEnd(driver_, nextName_, nextTitle_, content_);
  column_->addWidget(end);
  column_->addStretch(1);
  connect(end, &LessonEnd::lessonAsked, this, &LessonColumn::lessonAsked);
  connect(end, &LessonEnd::allLessonsAsked, this, &LessonColumn::nextLessonAsked);
  announce(*this, tr("The lesson is done. You know now: %1").arg(toText(driver_.lesson().goal)));
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
  // What is disabled loses the focus; it waits here, where no key leads away.
  QWidget* focus = window()->focusWidget();
  if (driver_.phase() == Phase::Running && focus && isAncestorOf(focus)) setFocus(Qt::OtherFocusReason);
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

/// Page Up and Page Down read on, wherever the focus is in the column.
void LessonColumn::keyPressEvent(QKeyEvent* event) {
  const int pages = event->key() == Qt::Key_PageDown ? 1 : event->key() == Qt::Key_PageUp ? -1 : 0;
  if (pages == 0) return QWidget::keyPressEvent(event);
  QScrollBar* bar = scroll_->verticalScrollBar();
  bar->setValue(bar->value() + pages * bar->pageStep());
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
  announce(*hint_, hint_->text());
}

}  // namespace surefoot

#include "moc_lesson_column.cpp"
