// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lessons_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/lessons/lesson_reading.h"
#include "ui/controls/hairline.h"
#include "ui/controls/text_button.h"
#include "ui/lessons/lesson_details.h"
#include "ui/lessons/taking/lesson_view.h"
#include "ui/session/session.h"
#include "ui/style/painted.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

/// The share of the lessons that are done, as a thin bar.
class DoneBar final : public Painted<> {
 public:
  DoneBar() {
    whenScaled(this, [this] { setFixedSize(scaled(QSize(240, 4))); });
  }
  void show(double share) {
    share_ = share;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Theme& t = themeOf(*this);
    ScaledPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(Qt::NoPen);
    p.setBrush(t.track);
    p.drawRoundedRect(rect(), 2, 2);
    p.setBrush(t.ink);
    if (share_ > 0) p.drawRoundedRect(QRectF(0, 0, share_ * width(), height()), 2, 2);
  }

 private:
  double share_ = 0;
};

QLabel* makeWords(int pixels, int weight, bool quiet) {
  auto* label = new QLabel;
  label->setTextFormat(Qt::PlainText);
  if (quiet) label->setForegroundRole(QPalette::PlaceholderText);
  whenScaled(label, [label, pixels, weight] { label->setFont(scaledFont(pixels, weight)); });
  return label;
}

}  // namespace

LessonsPage::LessonsPage(const Registry& registry, QString lessons, QString store, QWidget* parent)
    : QStackedWidget(parent),
      registry_(registry),
      folder_(std::move(lessons)),
      store_(std::move(store)) {
  addWidget(makeListPage());
}

LessonsPage::~LessonsPage() {
  disconnect();  // whoever listens is being destroyed
  delete view_;  // its panels know what belongs to it
}

QWidget* LessonsPage::makeBar() {
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  continue_ = new TextButton(tr("Continue"), TextButton::Look::Main);
  continue_->setStarts(true);
  next_ = makeWords(13, 500, false);
  asked_ = makeWords(11, 400, true);
  left_ = makeWords(11, 400, true);
  count_ = makeWords(13, 500, false);
  auto* bars = new DoneBar;
  progress_ = bars;
  auto* words = new QVBoxLayout;
  words->setSpacing(0);
  words->addStretch(1);
  words->addWidget(next_);
  words->addWidget(asked_);
  words->addStretch(1);
  auto* counts = new QHBoxLayout;
  counts->addWidget(left_);
  counts->addStretch(1);
  counts->addWidget(count_);
  auto* right = new QVBoxLayout;
  right->addStretch(1);
  right->addLayout(counts);
  right->addWidget(bars);
  right->addStretch(1);
  row->addWidget(continue_);
  row->addLayout(words, 1);
  row->addLayout(right);
  whenScaled(bar, [bar, row, right] {
    bar->setFixedHeight(scaled(48));
    row->setContentsMargins(scaled({12, 0, 12, 0}));
    row->setSpacing(scaled(16));
    right->setSpacing(scaled(4));
  });
  connect(continue_, &QAbstractButton::clicked, this, [this] {
    if (nextLesson_ >= 0) startLesson(*lessons_[static_cast<std::size_t>(nextLesson_)].lesson, false);
  });
  return bar;
}

QWidget* LessonsPage::makeListPage() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeBar());
  column->addWidget(new Hairline(Qt::Horizontal));
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* parts = new QWidget;
  auto* row = parts_ = new QBoxLayout(QBoxLayout::LeftToRight, parts);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  scroll->setWidget(parts);
  auto* left = new QVBoxLayout;
  left->setSpacing(0);
  auto* head = new QHBoxLayout;
  auto* title = makeWords(13, 500, false);
  title->setText(tr("Lessons"));
  auto* note = makeWords(11, 400, true);
  note->setText(tr("twelve, about two hours in all; a double lesson of 90 minutes is 1, 2, 3, 5, 6, 7, 8, 11, 12"));
  note_ = note;
  head->addWidget(title);
  head->addWidget(note, 1);
  whenScaled(page, [head] {
    head->setContentsMargins(scaled({12, 8, 12, 6}));
    head->setSpacing(scaled(8));
  });
  left->addLayout(head);
  list_ = new LessonList(registry_);
  left->addWidget(list_, 1);
  left->addWidget(makeFoot());
  details_ = new LessonDetails(registry_);
  whenScaled(details_, [this] { fit(); });
  row->addLayout(left, 1);
  row->addWidget(new Hairline(Qt::Vertical));
  row->addWidget(details_);
  column->addWidget(scroll, 1);
  connect(list_, &LessonList::chosenChanged, this, [this](int lesson) {
    const auto all = listed();
    if (lesson < static_cast<int>(all.size())) details_->show(all[static_cast<std::size_t>(lesson)], all);
  });
  connect(list_, &LessonList::startAsked, this, [this] {
    if (const Lesson* lesson = chosenLesson()) startLesson(*lesson, false);
  });
  connect(details_, &LessonDetails::startAsked, this, [this] {
    if (const Lesson* lesson = chosenLesson()) startLesson(*lesson, false);
  });
  connect(details_, &LessonDetails::beginAgainAsked, this, [this] {
    const Lesson* lesson = chosenLesson();
    if (!lesson) return;
    Q_EMIT beginAgainAsked(
        tr("What was said and done in “%1” is forgotten when it begins again.").arg(toText(lesson->title)),
        [this, name = lesson->name] {
          for (const ShelvedLesson& one : lessons_)
            if (one.lesson && one.lesson->name == name) return startLesson(*one.lesson, true);
        });
  });
  connect(details_, &LessonDetails::exploreAsked, this, [this] {
    if (const Lesson* lesson = chosenLesson()) exploreStart(*lesson);
  });
  return page;
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
  lessons_ = lessonsIn(registry_, folder_.toStdString());
  refresh();
  list_->choose(std::max(nextLesson_, 0));
}

std::vector<ListedLesson> LessonsPage::listed() {
  std::vector<ListedLesson> all;
  for (const ShelvedLesson& one : lessons_) {
    ListedLesson listed{&one};
    if (one.lesson) {
      const HandIn handIn = store_.handIn(*one.lesson);
      listed.reached = handIn.marks.empty() ? 0 : handIn.reached(*one.lesson);
      const auto steps = static_cast<double>(one.lesson->steps.size());
      listed.done = handIn.finished()      ? 1.0
                    : handIn.marks.empty() ? 0.0
                                           : (static_cast<double>(listed.reached) + 0.5) / (steps + 0.5);
    }
    all.push_back(listed);
  }
  return all;
}

/// Continue: the lesson that was begun last in the list's order, or the first that is not done.
void LessonsPage::refresh() {
  const auto all = listed();
  list_->show(all);
  nextLesson_ = -1;
  int done = 0, numbered = 0;
  double minutes = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].shelved->lesson) continue;
    const Lesson& lesson = *all[i].shelved->lesson;
    const bool counts = !lesson.number.empty();
    numbered += counts;
    done += counts && all[i].done >= 1;
    if (counts) minutes += (1 - all[i].done) * lesson.minutes;
    const bool begun = all[i].done > 0 && all[i].done < 1;
    const bool betterThanNone = nextLesson_ < 0 && all[i].done < 1;
    if (betterThanNone || (begun && all[static_cast<std::size_t>(nextLesson_)].done <= 0))
      nextLesson_ = static_cast<int>(i);
  }
  const bool none = nextLesson_ < 0;
  continue_->setEnabled(!none);
  if (none) {
    next_->setText(all.empty() ? tr("No lessons") : tr("All are done"));
    asked_->setText(all.empty() ? tr("Lessons come with the program; none were found in %1.").arg(folder_) : QString());
  } else {
    const ListedLesson& next = all[static_cast<std::size_t>(nextLesson_)];
    const Lesson& lesson = *next.shelved->lesson;
    const bool begun = next.done > 0;
    continue_->setText(begun ? tr("Continue") : done == 0 ? tr("Start with the first") : tr("Start"));
    const QString left = tr("about %1 min left").arg(std::max(1.0, std::round((1 - next.done) * lesson.minutes)));
    next_->setText(begun ? tr("%1   step %2 of %3, %4")
                               .arg(toText(lesson.title))
                               .arg(next.reached + 1)
                               .arg(lesson.steps.size())
                               .arg(left)
                         : tr("%1   %2 min").arg(toText(lesson.title)).arg(lesson.minutes));
    const std::string question = begun ? questionOf(lesson.steps[next.reached]) : lesson.line;
    asked_->setText(begun && !question.empty() ? tr("You were asked: %1").arg(toText(question)) : toText(lesson.line));
  }
  continue_->updateGeometry();
  left_->setText(minutes >= 90   ? tr("about %1 hours left").arg(std::round(minutes / 30) / 2)
                 : minutes > 0.5 ? tr("about %1 min left").arg(std::round(minutes))
                                 : QString());
  count_->setText(tr("%1 of %2 lessons").arg(done).arg(numbered));
  static_cast<DoneBar*>(progress_)->show(numbered ? static_cast<double>(done) / numbered : 0.0);
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

/// The chosen lesson stands beside the list where there is room for both, else below it, and the page scrolls.
void LessonsPage::fit() {
  if (!details_) return;
  const bool beside = width() >= scaled(960), wide = width() >= scaled(1180);
  parts_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  details_->setMinimumWidth(beside ? scaled(wide ? 424 : 340) : 0);
  details_->setMaximumWidth(beside ? scaled(wide ? 424 : 340) : QWIDGETSIZE_MAX);
  list_->setMinimumHeight(beside ? scaled(120) : scaled(320));
  details_->setMinimumHeight(beside ? scaled(120) : scaled(480));
  const int list = beside ? width() - details_->maximumWidth() : width();
  drop_->setVisible(list >= scaled(700));
  note_->setVisible(list >= scaled(640));
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
  auto one = readLessonFile(registry_, path.toStdString());
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
  if (view_) removeWidget(view_), delete std::exchange(view_, nullptr);
  view_ = new LessonView(registry_, lesson, handIn);
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

void LessonsPage::exploreStart(const Lesson& lesson) {
  auto life = LessonLife::begin(registry_, lesson, seedOf(lesson, store_.student().toStdString()));
  if (!life) return Q_EMIT refused(toText(life.error().message));
  if (const Status s = life->act(lesson.steps[0].begin); !s) return Q_EMIT refused(toText(s.error().message));
  LifeInHand hand = life->take();
  if (explore_) explore_(std::move(hand.began), std::move(hand.life));
}

void LessonsPage::showList() {
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
