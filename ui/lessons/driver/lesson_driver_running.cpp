// SPDX-License-Identifier: GPL-3.0-or-later
// The part of LessonDriver that acts on the life: runs with an end, actions, several lives, tasks that are watched.
#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "ui/controls/preferences.h"
#include "ui/lessons/driver/lesson_driver.h"

namespace surefoot {

namespace {
constexpr double kLeastShown = 900, kLongestRest = 50;  // [ms]
constexpr double kLookEvery = 1.0 / 256;                // of the run
}  // namespace

void LessonDriver::run(const LessonRun& run, const Then& then) {
  setPhase(Phase::Running);
  progress_->store(0);
  auto from = std::make_shared<LifeFacts>();
  visit([from](const Life& life, Knowledge&) { *from = factsOf(life); });
  // In turbo it would be over before anybody sees the curve grow: it takes about a second.
  const double least = run.turbo && run.amount && !reducedMotion() ? kLeastShown : 0;
  QElapsedTimer clock;
  clock.start();
  session_->life().watch([this, run, from, then, least, clock, look = 0.0, knowledge = knowledge_, progress = progress_,
                          entered = entered_](const Life& life) mutable {
    bool over = life.finished();
    if (run.amount) {
      const double share = shareOf(*run.amount, *from, life);
      progress->store(share, std::memory_order_relaxed);
      if (least > 0 && share >= look) {  // the clock is read at every few of the steps only
        look = share + kLookEvery;
        const double ahead = least * std::min(share, 1.0) - static_cast<double>(clock.elapsed());  // [ms]
        if (ahead > 0)
          std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(std::min(ahead, kLongestRest)));
      }
      over = over || share >= 1;
    }
    if (run.until) over = over || knowledge->values.holds(*run.until, life);
    if (!over) return Watching::GoOn;
    calls_.post([this, then, entered] {
      if (entered != entered_) return;
      session_->life().setRunning(false);
      then();
    });
    return Watching::EnoughAndPause;
  });
  session_->life().setTurbo(run.turbo);
  session_->life().setRunning(true);
}

void LessonDriver::observe(const LessonCondition& of, const Then& then) {
  auto seen = std::make_shared<LessonMark>(LessonMark{.kind = LessonMark::Kind::Observed, .step = number_});
  visit(
      [seen, of, record = recorder()](const Life& life, Knowledge& k) {
        seen->value = k.values.of(of, life);
        k.values.observe(seen->step, seen->value);
        record(life, k, *seen);
      },
      [this, seen, then] {
        observed_[seen->step] = seen->value;
        mark(std::move(*seen));
        then();
      });
}

void LessonDriver::perform(LessonActions actions, std::size_t from, Then then) {
  if (from == actions.size()) return then();
  const LessonAction action = actions[from];
  const Then goOn = [this, actions = std::move(actions), from, then = std::move(then)] {
    perform(actions, from + 1, then);
  };
  Configuration now = session_->life().configuration();
  const auto refuse = [this](const Status& s) {
    if (!s) Q_EMIT refused(QString::fromStdString(s.error().message));
  };
  switch (action.kind) {
    case LessonAction::Kind::Set: {
      if (const Status s = now.parameters.set(action.key, std::string_view(action.value)); !s) refuse(s);
      const Parameters::Entry* entry = now.parameters.find(action.key);
      if (entry && entry->parameter.when == When::NewTable) return beginLife(std::move(now), goOn);
      if (entry) refuse(session_->editing().setParameter(action.key, entry->value));
      return goOn();
    }
    case LessonAction::Kind::Policy:
      session_->editing().setPolicy(action.value);
      return goOn();
    case LessonAction::Kind::Scenario:
      session_->editing().setScenario(action.value);
      return goOn();
    case LessonAction::Kind::Agent: {
      Names names = now.names;
      names.agent = action.value;
      auto changed = configurationUnder(registry_, now, names);
      if (!changed) return Q_EMIT refused(QString::fromStdString(changed.error().message));
      return beginLife(std::move(*changed), goOn);
    }
    case LessonAction::Kind::Seed:
      now.seed = action.seed;
      return beginLife(std::move(now), goOn);
    case LessonAction::Kind::Restart:
      return beginLife(std::move(now), goOn);
    case LessonAction::Kind::Transfer:
      return transfer(goOn);
    case LessonAction::Kind::Place:
      refuse(session_->life().place(action.state));
      return goOn();
    case LessonAction::Kind::Push:
      session_->life().push(action.state.at(0));
      return goOn();
    case LessonAction::Kind::Run:
      return run({.amount = action.amount, .turbo = true}, goOn);
  }
}

void LessonDriver::beginLife(Configuration configuration, const Then& then) {
  NewLives& lives = session_->newLives();
  const Status begun =
      lives.beginWhenMade(lives.makeOf(std::move(configuration)), [this, then, entered = entered_](const Status& s) {
        if (entered != entered_) return;
        if (!s) return Q_EMIT refused(QString::fromStdString(s.error().message));
        then();
      });
  static_cast<void>(static_cast<bool>(begun));  // it was told above
}

void LessonDriver::transfer(const Then& then) {
  auto learned = std::make_shared<std::pair<Configuration, std::shared_ptr<const LifeRecord>>>();
  visit(
      [learned, lesson = &lesson_, now = session_->life().configuration(), began = session_->life().began(),
       from = learnedFrom()](const Life& life, Knowledge&) {
        *learned = {transferred(life, now), std::make_shared<const LifeRecord>(recordOf(*lesson, began, life, from))};
      },
      [this, learned, then] {
        learned_[learned->first.start.get()] = learned->second;
        const int before = session_->life().curves().live().number;  // its curve is no comparison: it fell elsewhere
        beginLife(std::move(learned->first), [this, before, then] {
          session_->life().curves().remove({before});
          then();
        });
      });
}

void LessonDriver::liveWays() {
  struct Work {
    LessonLives lives;
    Configuration begun;
    std::optional<LessonValues> values{};
    Result<std::vector<std::vector<double>>> results = Error{"stopped"};
  };
  auto work = std::make_shared<Work>(Work{*step().lives, session_->life().configuration()});
  visit([work](const Life&, Knowledge& k) { work->values.emplace(k.values); },
        [this, work, entered = entered_] {
          background_.start(
              [work, &registry = registry_, lesson = &lesson_](const std::atomic<bool>& interrupted) {
                const int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
                work->results =
                    surefoot::liveWays(registry, *lesson, work->lives, work->begun, *work->values, jobs, &interrupted);
              },
              [this, work, entered] {
                if (entered != entered_) return;
                if (!work->results) return Q_EMIT refused(QString::fromStdString(work->results.error().message));
                lives_ = *work->results;
                for (std::size_t w = 0; w < lives_.size(); ++w) {
                  const LessonLives::Way& way = work->lives.ways[w];
                  know([place = way.place, values = lives_[w]](LessonValues& v) { v.lived(place, values); });
                  mark({.kind = LessonMark::Kind::Lived, .step = number_, .values = lives_[w], .text = way.label});
                }
                renderText();
                Q_EMIT livesChanged();
              });
        });
}

/// Looks now, and after every step, whether the task is done; once it is, whether its par is kept, too. When an attempt
/// is over without it, the life pauses and it is said.
void LessonDriver::watchTask() {
  if (!step().done || (taskDone_ && (!step().par || parKept_))) return;
  auto look = [this, done = *step().done, par = step().par, attempt = step().attempt, wasDone = taskDone_,
               knowledge = knowledge_, entered = entered_, record = recorder(), step = number_,
               turbo = session_->life().turbo(), before = 1.0](const Life& life) mutable {
    const LessonValues& values = knowledge->values;
    const double share = attempt ? shareOf(*attempt, LifeFacts{}, life) : 0;
    const bool isOver = std::exchange(before, share) < 1 && share >= 1;
    const bool isDone = values.holds(done, life), kept = isDone && par && values.holds(*par, life);
    if (!isDone || (wasDone && !kept)) {
      if (!isOver) return Watching::GoOn;
      calls_.post([this, entered, wasDone] {
        if (entered == entered_) noteAttempt(wasDone);
      });
      return Watching::EnoughAndPause;
    }
    LessonMark given{.kind = LessonMark::Kind::Done, .step = step, .right = kept};
    record(life, *knowledge, given);
    calls_.post([this, entered, given = std::move(given)]() mutable {
      if (entered == entered_) noteTask(std::move(given));
    });
    return turbo ? Watching::EnoughAndPause : Watching::Enough;
  };
  session_->life().visit([look](const Life& life) mutable { look(life); });  // of a life that rests a knob may do it
  session_->life().watch(look);
}

void LessonDriver::run() {
  RunningLife& life = session_->life();
  if (life.running() || !attemptOver_) return life.setRunning(!life.running());
  if (const Status s = session_->newLives().restart(); !s)
    return Q_EMIT refused(QString::fromStdString(s.error().message));
  life.setRunning(true);
}

void LessonDriver::noteAttempt(bool wasDone) {
  attemptOver_ = true;
  session_->life().setRunning(false);
  if (!wasDone) Q_EMIT judged({false, tr("That life is over; restart it and try another way.").toStdString()});
  watchTask();
}

void LessonDriver::noteTask(LessonMark done) {
  if (taskDone_ && (parKept_ || !done.right)) return;
  taskDone_ = true;
  parKept_ = done.right;
  attemptOver_ = step().attempt.has_value();
  if (session_->life().turbo()) session_->life().setRunning(false);  // else it is far beyond before one has seen it
  mark(std::move(done));
  renderText();
  Q_EMIT taskChanged();
  watchTask();
}

}  // namespace surefoot
