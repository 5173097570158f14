// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the Lessons page with the list: its bar, the chosen lesson beside it, and what is told of the progress.
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
#include "ui/controls/header_button.h"
#include "ui/controls/labels.h"
#include "ui/controls/text_button.h"
#include "ui/language/numbers.h"
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

}  // namespace

QWidget* LessonsPage::makeBar() {
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  continue_ = new TextButton(tr("Continue"), TextButton::Look::Main);
  continue_->setStarts(true);
  next_ = makeText({}, 13, 500, false, nullptr);
  asked_ = makeText({}, 11, 400, true, nullptr);
  left_ = makeText({}, 11, 400, true, nullptr);
  count_ = makeText({}, 13, 500, false, nullptr);
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
  auto* title = makeText({}, 13, 500, false, nullptr);
  title->setText(tr("Lessons"));
  auto* note = makeText({}, 11, 400, true, nullptr);
  note->setText(tr("thirteen, a good two hours in all; a double lesson of 90 minutes is 1, 2, 3, 5, 6, 7, 11, 13"));
  note_ = note;
  head->addWidget(title);
  head->addWidget(note, 1);
  head->addWidget(new HelpButton(tr("Lessons")));
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
  left_->setText(minutes >= 90   ? tr("about %1 hours left").arg(fixedNumber(std::round(minutes / 30) / 2, 1))
                 : minutes > 0.5 ? tr("about %1 min left").arg(countNumber(minutes))
                                 : QString());
  count_->setText(tr("%1 of %2 lessons").arg(done).arg(numbered));
  static_cast<DoneBar*>(progress_)->show(numbered ? static_cast<double>(done) / numbered : 0.0);
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

}  // namespace surefoot
