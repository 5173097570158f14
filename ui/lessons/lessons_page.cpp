// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lessons_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/lessons/reading/lesson_reading.h"
#include "ui/controls/hairline.h"
#include "ui/controls/text_button.h"
#include "ui/language/speech.h"
#include "ui/lessons/lesson_details.h"
#include "ui/lessons/taking/lesson_view.h"
#include "ui/session/session.h"
#include "ui/style/painted.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

LessonsPage::LessonsPage(const Registry& registry, QString lessons, QString store, QWidget* parent)
    : QStackedWidget(parent),
      registry_(registry),
      folder_(std::move(lessons)),
      store_(std::move(store)) {
  constexpr int kTyping = 500;  // [ms] without a key, and what was typed is written
  drafting_.setSingleShot(true);
  drafting_.setInterval(kTyping);
  connect(&drafting_, &QTimer::timeout, this, &LessonsPage::keepDrafts);
  addWidget(makeListPage());
}

LessonsPage::~LessonsPage() {
  keepDrafts();
  disconnect();  // whoever listens is being destroyed
  delete view_;  // its panels know what belongs to it
}

const Lesson* LessonsPage::chosenLesson() const {
  const int lesson = list_->chosen();
  if (lesson < 0 || lesson >= static_cast<int>(lessons_.size())) return nullptr;
  const auto& own = lessons_[static_cast<std::size_t>(lesson)].lesson;
  return own ? &*own : nullptr;
}

const std::vector<ShelvedLesson>& LessonsPage::lessons() {
  read();
  return lessons_;
}

void LessonsPage::read() {
  if (std::exchange(read_, true)) return;
  lessons_ = lessonsIn(registry_, folder_.toStdString(), lessonInLanguage);
  refresh();
  list_->choose(std::max(nextLesson_, 0));
}

void LessonsPage::showEvent(QShowEvent* event) {
  QStackedWidget::showEvent(event);
  read();
  refreshStatus();
}

void LessonsPage::resizeEvent(QResizeEvent* event) {
  QStackedWidget::resizeEvent(event);
  fit();
}

Status LessonsPage::open(const QString& path) {
  const auto index = addFile(path);
  if (!index) return index.error();
  showList();
  list_->choose(*index);
  return Done{};
}

/// The place of a lesson's file in the list, which it is added to.
Result<int> LessonsPage::addFile(const QString& path) {
  read();
  auto one = readLessonFile(registry_, path.toStdString(), lessonInLanguage);
  if (!one) return one.error();
  const auto same = std::find_if(lessons_.begin(), lessons_.end(), [&](const auto& l) { return l.path == one->path; });
  const auto index = static_cast<int>(same - lessons_.begin());
  if (same == lessons_.end())
    lessons_.push_back(std::move(*one));
  else
    *same = std::move(*one);
  return index;
}

Status LessonsPage::setClass(const QString& folder, const QString& student) {
  if (const Status s = store_.setClass(folder, student); !s) return s;
  if (read_) refresh();
  refreshStatus();
  return Done{};
}

bool LessonsPage::start(const std::string& name) {
  read();
  for (const ShelvedLesson& one : lessons_)
    if (one.lesson && one.lesson->name == name) return startLesson(*one.lesson, false), true;
  return false;
}

Status LessonsPage::startChosen() {
  const int chosen = list_->chosen();
  const ShelvedLesson& one = lessons_[static_cast<std::size_t>(std::max(chosen, 0))];
  if (!one.lesson) return Error{complaintText(one.path, one.complaints.at(0))};
  startLesson(*one.lesson, false);
  return Done{};
}

void LessonsPage::startLesson(const Lesson& lesson, bool again) {
  if (again)
    if (const Status s = store_.forget(lesson); !s) Q_EMIT refused(toText(s.error().message));
  HandIn handIn = store_.handIn(lesson);
  const bool seen = handIn.finished();  // it is seen again; what was said stays as it was
  if (seen) handIn.marks.clear();
  keepDrafts();
  if (view_) removeWidget(view_), delete std::exchange(view_, nullptr);
  view_ = new LessonView(registry_, lesson, handIn);
  if (!seen) view_->driver().setDrafts(store_.drafts(lesson));
  addWidget(view_);
  setCurrentWidget(view_);
  connect(view_, &LessonView::refused, this, &LessonsPage::refused);
  connect(view_, &LessonView::allLessonsAsked, this, &LessonsPage::showList);
  connect(view_, &LessonView::lessonAsked, this, [this](const QString& name) { start(name.toStdString()); });
  connect(view_, &LessonView::exploreAsked, this, [this] {
    view_->driver().copyLife([this](Configuration began, std::unique_ptr<Life> life) {
      if (explore_) explore_(std::move(began), std::move(life));
    });
  });
  connect(&view_->driver(), &LessonDriver::marked, this, [this, seen](const LessonMark& mark) {
    if (seen) return;
    if (const Status s = store_.add(view_->driver().lesson(), mark); !s)
      Q_EMIT refused(tr("What you do cannot be kept: %1").arg(toText(s.error().message)));
  });
  connect(&view_->driver(), &LessonDriver::drafted, this, [this, seen] {
    if (seen) return;
    isDrafted_ = true;
    drafting_.start();
  });
  connect(view_, &LessonView::teacherAsked, this, &LessonsPage::showTeacher);
  connect(&view_->driver(), &LessonDriver::stepChanged, this, [this] {
    if (teacher_) teacher_->follow(view_->driver().number(), 0);
  });
  delete teacher_;
  for (std::size_t i = 0; i + 1 < lessons_.size(); ++i)
    if (lessons_[i].lesson && lessons_[i].lesson->name == lesson.name && lessons_[i + 1].lesson)
      view_->setNext(toText(lessons_[i + 1].lesson->name), toText(lessons_[i + 1].lesson->title));
  view_->begin(handIn.marks.empty() ? 0 : handIn.reached(lesson));
  refreshStatus();
}

/// What is typed and was not written yet.
void LessonsPage::keepDrafts() {
  if (view_ && std::exchange(isDrafted_, false)) store_.keepDrafts(view_->driver().lesson(), view_->driver().drafts());
}

void LessonsPage::exploreStart(const Lesson& lesson) {
  auto life = LessonLife::begin(registry_, lesson, seedOf(lesson, store_.student().toStdString()));
  if (!life) return Q_EMIT refused(toText(life.error().message));
  if (const Status s = life->act(lesson.steps[0].begin); !s) return Q_EMIT refused(toText(s.error().message));
  LifeInHand hand = life->take();
  if (explore_) explore_(std::move(hand.began), std::move(hand.life));
}

void LessonsPage::showList() {
  keepDrafts();
  if (view_) {
    view_->driver().session().life().setRunning(false);
    removeWidget(view_);
    view_->deleteLater();
    view_ = nullptr;
  }
  setCurrentIndex(0);
  read();
  refresh();
  list_->setFocus(Qt::OtherFocusReason);
  refreshStatus();
}

void LessonsPage::showHint() {
  if (view_) view_->showHint();
}

void LessonsPage::focusHome() {
  if (currentIndex() != 0 && currentWidget() == view_) return view_->focusHome();
  currentIndex() == 0 ? list_->setFocus(Qt::OtherFocusReason) : currentWidget()->setFocus(Qt::OtherFocusReason);
}

void LessonsPage::refreshStatus() {
  QStringList left;
  if (view_) {
    const Configuration& c = view_->driver().session().life().configuration();
    left << tr("seed %1").arg(c.seed);
  }
  Q_EMIT statusChanged(left.join(QStringLiteral("  ")),
                       store_.classFolder().isEmpty()
                           ? tr("answers are kept on this computer only")
                           : tr("answers of %1 are kept in %2").arg(store_.student(), store_.classFolder()));
}

}  // namespace surefoot

#include "moc_lessons_page.cpp"
