// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Experiment that runs a plan, pauses it and goes on.
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QThread>
#include <algorithm>
#include <thread>
#include <tuple>

#include "core/environment_library.h"
#include "core/environment_programs.h"
#include "core/plans/plan_programs.h"
#include "ui/experiment/experiment.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {
constexpr int kTick = 200;  // [ms]
}  // namespace

Experiment::~Experiment() {
  if (thread_) thread_->stop();                                    // tell all threads to stop; the wait comes later
  for (Following* left : findChildren<Following*>()) delete left;  // they use the members
}

Status Experiment::run(bool otherVersion) {
  needs_ = Consent::None;
  if (state_ == State::Running || state_ == State::Complete) return Done{};
  if (state_ == State::Following)
    return Error{tr("%1 is followed, read only; stop following first.").arg(following_->name()).toStdString()};
  if (!plan_) return whyNot_.empty() ? Status(Done{}) : Error{whyNot_, ErrorKind::File};
  if (const Status s = checkPrograms(registry_, *plan_); !s) {
    needs_ = Consent::Programs;
    return s;
  }
  if (thread_)
    thread_->setPaused(false);
  else if (const Status s = openToRun(otherVersion); !s)
    return s;
  running_.start();
  shareAtStart_ = share_;
  setState(State::Running);
  timer_.start(kTick);
  return Done{};
}

void Experiment::allowProgram() {
  if (const auto programs = programsToAllow(registry_, *plan_); !programs.empty())
    registry_.programs->allow(programs.front()->program);
}

Status Experiment::openToRun(bool otherVersion) {
  if (std::any_of(leaving_.begin(), leaving_.end(), [&](const Leaving& l) { return l.store == storePath_; }))
    return Error{tr("What these results had in hand is still being kept; run them again in a moment.").toStdString()};
  if (storePath_.empty()) {
    if (!QDir().mkpath(folder_))
      return Error{tr("The results have no place: %1 cannot be made.").arg(folder_).toStdString()};
    storePath_ = placeForResults();
  }
  auto store = Store::missing(storePath_) ? Store::create(storePath_, stored_) : Store::openToWrite(storePath_);
  if (!store) return store.error();
  const auto there = store->plan();
  if (!there) return there.error();
  if (const Status s = checkSamePlan(*there, stored_, storePath_); !s) return s;
  const auto lives = store->lives();
  if (!lives) return lives.error();
  if (const Status s = checkLivesVersion(*lives, storePath_); !s && !otherVersion) {
    needs_ = Consent::OtherVersion;
    return s;
  }
  const LabOptions options{.jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency())),
                           .shard = stored_.shard,
                           .shards = stored_.shards};
  thread_ = std::make_unique<LaboratoryThread>(registry_, *plan_, std::move(*store), options);
  shareBefore_ = share_;
  return Done{};
}

/// A new empty file, named by the time; another window may have taken the name in the same millisecond.
std::string Experiment::placeForResults() const {
  for (;;) {
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd-HHmmss-zzz"));
    QFile file(QDir(folder_).filePath(QStringLiteral("results-%1.sqlite").arg(stamp)));
    // If the file cannot be made at all, the store reports it.
    if (file.open(QIODevice::WriteOnly | QIODevice::NewOnly) || !file.exists()) return file.fileName().toStdString();
    QThread::msleep(1);
  }
}

void Experiment::pause() {
  if (state_ != State::Running) return;
  before_ = elapsed();
  thread_->setPaused(true);
  setState(State::Paused);
}

// Tells the running thread to stop and keeps it until it has stopped: saving its unfinished lives may take seconds.
void Experiment::leave() {
  if (!thread_) return;
  thread_->stop();
  leaving_.push_back({storePath_, std::move(thread_)});
  timer_.start(kTick);
}

void Experiment::reset() {
  if (thread_ || (livesDone_ > 0 && !text_.empty())) Q_EMIT leftBehind(toText(storePath_));
  leave();
  Following::end(std::move(following_), this);
  view_.reset();
  results_.begin(results_.claims(), stored_);
  storePath_.clear();
  before_ = share_ = shareBefore_ = 0;
  livesDone_ = 0;
  falls_ = 0;
  setState(State::Ready);
}

void Experiment::take() {
  const LabProgress p = thread_->progress();
  const auto before = std::tuple(livesDone_, share_, falls_);
  livesDone_ = std::max(livesDone_, p.livesThere + p.work.livesDone);
  share_ = std::max(share_, shareBefore_ + (1.0 - shareBefore_) * p.work.share);
  falls_ = std::max(falls_, p.falls);
  if (state_ == State::Running || before != std::tuple(livesDone_, share_, falls_)) Q_EMIT progressed();
  if (auto view = thread_->view(); view && view != view_) {
    view_ = std::move(view);
    results_.show(view_);
  }
}

void Experiment::tick() {
  std::erase_if(leaving_, [&](const Leaving& l) {
    if (!l.thread->over()) return false;
    if (const std::string trouble = l.thread->trouble(); !trouble.empty()) Q_EMIT failed(toText(trouble));
    return true;
  });
  if (!thread_) {
    if (leaving_.empty()) timer_.stop();
    return;
  }
  const bool over = thread_->over();
  take();
  if (!over || results_.view() != view_) return;  // wait until the last results are shown, too
  before_ = elapsed();
  const std::string trouble = thread_->trouble();
  const bool complete = thread_->complete();
  thread_.reset();
  if (complete) share_ = 1, livesDone_ = livesPlanned();
  setState(complete ? State::Complete : State::Paused);
  Q_EMIT progressed();
  if (!trouble.empty()) Q_EMIT failed(toText(trouble));
}

double Experiment::elapsed() const {
  return before_ + (state_ == State::Running ? static_cast<double>(running_.elapsed()) * 1e-3 : 0.0);
}

std::optional<double> Experiment::left() const {
  if (state_ == State::Following) {
    const int came = livesDone_ - livesAtFirst_, missing = livesPlanned() - livesDone_;
    if (!sinceFirstLife_.isValid() || came <= 0 || missing <= 0 || !following_->isWritten()) return std::nullopt;
    return static_cast<double>(sinceFirstLife_.elapsed()) * 1e-3 * missing / came;
  }
  const double done = share_ - shareAtStart_;
  if (state_ != State::Running || done < 0.01) return std::nullopt;
  return static_cast<double>(running_.elapsed()) * 1e-3 * (1.0 - share_) / done;
}

}  // namespace surefoot
