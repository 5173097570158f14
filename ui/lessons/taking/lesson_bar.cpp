// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/lesson_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <algorithm>

#include "ui/controls/bar_button.h"
#include "ui/controls/labels.h"
#include "ui/controls/link_button.h"
#include "ui/controls/slider.h"
#include "ui/language/numbers.h"
#include "ui/lessons/driver/lesson_driver.h"
#include "ui/live/run_bar.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

LessonBar::LessonBar(LessonDriver& driver, QWidget* parent) : QWidget(parent), driver_(driver) {
  makeActions();
  auto* row = new QHBoxLayout(this);
  addButtons(*row);
  auto* all = new LinkButton(tr("‹  All lessons"), this);
  all->setToolTip(tr("The list of lessons; this one waits at its step"));
  connect(all, &QToolButton::clicked, this, &LessonBar::allLessonsAsked);
  row->addWidget(all);
  addPace(*row);
  auto* teacher = new LinkButton(tr("Teacher"), this);
  teacher->setToolTip(tr("Notes, answers and the class, in a window for the teacher's own screen"));
  connect(teacher, &QToolButton::clicked, this, &LessonBar::teacherAsked);
  row->addWidget(teacher);
  row->addStretch(1);
  addCounts(*row);
  whenScaled(this, [this, row] {
    setFixedHeight(scaled(48));
    row->setContentsMargins(scaled({8, 8, 12, 8}));
    row->setSpacing(scaled(8));
  });
}

void LessonBar::makeActions() {
  RunningLife& life = driver_.session().life();
  const auto act = [this](const QString& text, const QString& tip, Qt::Key key, const std::function<void()>& what) {
    auto* action = new QAction(text, this);
    action->setToolTip(tip);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(action, &QAction::triggered, this, what);
    return action;
  };
  run_ = act(tr("Run"), tr("Run or pause"), Qt::Key_Space, [this] { driver_.run(); });
  restart_ = act(tr("Restart"), tr("Start the life again with the same seed"), Qt::Key_R, [this] {
    if (const Status s = driver_.session().newLives().restart(); !s) Q_EMIT refused(toText(s.error().message));
  });
  turbo_ = act(tr("Turbo"), tr("Learn flat out"), Qt::Key_T, [this, &life] {
    life.setTurbo(!life.turbo());
    if (life.turbo() && !life.running()) driver_.run();
  });
  turbo_->setCheckable(true);
}

void LessonBar::addButtons(QHBoxLayout& row) {
  runButton_ = new BarButton(run_, Icon::Run, BarButton::Look::Main, this);
  parts_ = {{"run", runButton_},
            {"restart", new BarButton(restart_, Icon::Restart, BarButton::Look::Quiet, this)},
            {"turbo", new BarButton(turbo_, Icon::Turbo, BarButton::Look::Framed, this)}};
  for (const auto& [name, button] : parts_) {
    QSizePolicy keeps = button->sizePolicy();
    keeps.setRetainSizeWhenHidden(true);  // so that nothing beside it jumps from step to step
    button->setSizePolicy(keeps);
    row.addWidget(button);
  }
}

void LessonBar::addPace(QHBoxLayout& row) {
  QLabel* word = makeText(tr("Pace"), 11, 400, true, this);
  auto* pace = new Slider(this);
  pace->setAccessibleName(tr("Pace"));
  pace->setToolTip(tr("How fast the world runs; real time is in the middle"));
  pace->setValue(RunBar::positionOfPace(driver_.session().life().pace()));
  connect(pace, &QSlider::valueChanged, this, [this](int at) { driver_.session().life().setPace(RunBar::paceAt(at)); });
  whenScaled(pace, [pace] { pace->setFixedWidth(scaled(96)); });
  for (QWidget* part : {static_cast<QWidget*>(word), static_cast<QWidget*>(pace)}) {
    row.addWidget(part);
    parts_.emplace_back("pace", part);
  }
}

void LessonBar::addCounts(QHBoxLayout& row) {
  falls_ = new FallLabel(24, 500, this);
  episodes_ = makeText({}, 13, 500, false, this);
  minutes_ = makeText({}, 13, 500, false, this);
  minutes_->setToolTip(tr("How long the robot has lived, by its own clock"));
  QLabel* unit = makeText(tr("minutes"), 11, 400, true, this);
  for (QLabel* label : {falls_, makeText(tr("falls"), 11, 400, true, this), episodes_,
                        makeText(tr("episodes"), 11, 400, true, this), minutes_, unit})
    row.addWidget(label);
  for (QLabel* label : {minutes_, unit}) label->setVisible(driver_.session().life().task().stepTime.has_value());
}

void LessonBar::refresh() {
  const RunningLife& life = driver_.session().life();
  const auto& show = driver_.step().show;
  const auto shows = [&](const std::string& name) { return std::find(show.begin(), show.end(), name) != show.end(); };
  // Who predicts does not try it first.
  const bool open = driver_.phase() == LessonDriver::Phase::Open && !driver_.step().predict;
  runButton_->setIcon(life.running() ? Icon::Pause : Icon::Run);
  run_->setText(life.running() ? tr("Pause") : tr("Run"));
  run_->setEnabled(shows("run") && open && !life.finished());
  restart_->setEnabled(shows("restart") && open);
  turbo_->setEnabled(shows("turbo") && open);
  turbo_->setChecked(life.turbo());
  for (const auto& [name, part] : parts_) part->setVisible(shows(name));
  const Numbers& numbers = life.numbers();
  falls_->setText(life.task().canFall ? countNumber(static_cast<double>(numbers.falls)) : QString());
  episodes_->setText(countNumber(static_cast<double>(numbers.episodes)));
  constexpr double kSeconds = 60;  // in a minute
  const double minutes = static_cast<double>(numbers.steps) * life.task().stepTime.value_or(0) / kSeconds;
  minutes_->setText(fixedNumber(minutes, 1));
}

}  // namespace surefoot

#include "moc_lesson_bar.cpp"
