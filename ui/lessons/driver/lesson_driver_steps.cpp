// SPDX-License-Identifier: GPL-3.0-or-later
// The part of LessonDriver that goes from step to step: the state that a step begins with, and what happens before it.
#include "ui/lessons/driver/lesson_driver.h"

#include <algorithm>
#include <utility>

#include "core/saved/checkpoint.h"

namespace surefoot {

namespace {

bool sameValues(const Parameters& a, const Parameters& b) {
  const auto& all = a.all();
  return std::all_of(all.begin(), all.end(), [&](const auto& entry) {
    const auto* other = b.find(entry.parameter.key);
    return other && other->value == entry.value;
  });
}

}  // namespace

void LessonDriver::keepState(const std::function<void(Beginning)>& then) {
  auto kept = std::make_shared<std::optional<Beginning>>();
  visit(
      [kept, write = recorder(), began = session_->life().began(), from = learnedFrom()](const Life& life,
                                                                                         Knowledge& k) {
        LessonMark mark;
        write(life, k, mark);
        *kept = Beginning{.checkpoint = std::make_shared<const TensorFile>(checkpointOf(life, began, true)),
                          .began = began,
                          .values = k.values,
                          .learnedFrom = from,
                          .record = mark.life,
                          .before = mark.before,
                          .changes = static_cast<int>(life.changes().size()),
                          .episodes = life.log().totals().episodes,
                          .parameters = life.parameters()};
      },
      [this, kept, then] {
        (*kept)->curve = session_->life().curves().live().number;
        (*kept)->earlier = session_->life().curves().earlier();
        then(std::move(**kept));
      });
}

/// The step's own part is over: what the student's hands do from now on does not go into the next step.
void LessonDriver::settle(const Then& then) {
  keepState([this, then](Beginning state) {
    settled_ = std::move(state);
    then();
  });
}

/// The life is another one than when the step had settled.
bool LessonDriver::meddled() const {
  if (!settled_) return false;
  const RunningLife& life = session_->life();
  const ValueSnapshot* values = life.values();
  return life.running() || life.snapshot().steps != settled_->record->steps ||
         life.began().start != settled_->began.start ||
         (values && static_cast<int>(values->changes.size()) != settled_->changes) ||
         !sameValues(life.configuration().parameters, settled_->parameters);
}

void LessonDriver::next() {
  // A task's life is the student's own; everything else goes on as the lesson was tried and checked.
  const bool asItWas = settled_ && !step().done && meddled();
  std::optional<Beginning> from = asItWas ? settled_ : std::nullopt;
  const auto before = beginnings_.find(number_ + 1);
  if (!step().done && before != beginnings_.end()) from = before->second;  // one has been there
  if (number_ + 1 < lesson_.steps.size()) return arrive(number_ + 1, std::move(from));
  mark({.kind = LessonMark::Kind::Finished, .step = number_});
  session_->life().setRunning(false);
  setPhase(Phase::Finished);
}

void LessonDriver::back() {
  if (phase_ == Phase::Finished) return enter(number_);
  if (number_ > 0) enter(number_ - 1);
}

/// A step that one has been at begins as it did then.
void LessonDriver::enter(std::size_t number) {
  if (const auto found = beginnings_.find(number); found != beginnings_.end()) return arrive(number, found->second);
  const LessonMark* arrived = nullptr;
  for (const LessonMark& m : handIn_.marks)
    if (!arrived && m.kind == LessonMark::Kind::Arrived && m.step == number && m.life) arrived = &m;
  if (!arrived || number == 0) return arrive(number, std::nullopt);
  goOn(number);
}

/// `from`: the state of the life with which the step begins; nothing: the present one.
void LessonDriver::arrive(std::size_t number, std::optional<Beginning> from) {
  const bool leaves = entered_ > 0 && phase_ == Phase::Open && number_ != number;
  if (leaves && step().done && step().observe && !observed(number_))
    return observe(*step().observe, [this, number, from] { arrive(number, from); });
  // A life that the student played with is no curve of the lesson once the lesson begins another.
  // Nor is one that no chart has shown.
  const LessonActions& then = lesson_.steps[number].begin;
  const bool own = leaves && (step().done || meddled()) && !then.empty();
  if (own || (leaves && !charted_ && !keepsLife(then))) undone_ = session_->life().curves().live().number;
  ++entered_;
  phase_ = Phase::Preparing;  // no task is watched on the way; it is told below
  background_.cancel();
  number_ = number;
  tries_ = 0;
  taskDone_ = parKept_ = hintTaken_ = false;
  lives_.clear();
  text_.clear();
  settled_.reset();
  progress_->store(0);
  clock_.start();
  session_->life().watch({});
  session_->life().setRunning(false);
  session_->looking().backToLive();
  // A body that the step puts somewhere stays there, until the life goes on.
  const bool placed = !step().begin.empty() && step().begin.back().kind == LessonAction::Kind::Place;
  // A world without a clock (a walk over squares) does not go on by itself either: what stands there was lived.
  session_->looking().setDemonstrating(!placed && session_->life().task().stepTime.has_value());
  setPhase(Phase::Preparing);
  Q_EMIT stepChanged();
  const auto begin = [this, restore = from.has_value()](Beginning beginning) {
    beginning_ = beginning;
    beginnings_.emplace(number_, std::move(beginning));
    mark(
        {.kind = LessonMark::Kind::Arrived, .step = number_, .life = beginning_->record, .before = beginning_->before});
    !restore&& step().begin.empty() ? open() : prepare();
  };
  if (from) restored_ = from->earlier, undone_ = from->curve;
  from ? begin(std::move(*from)) : keepState(begin);
}

void LessonDriver::resetStep() {
  if (!beginning_) return;
  predicted_.erase(number_);
  observed_.erase(number_);
  answered_.erase(number_);
  if (draft() != LessonDraft{}) keepDraft({});
  beginnings_.erase(beginnings_.upper_bound(number_), beginnings_.end());
  arrive(number_, beginning_);
}

LessonValues LessonDriver::valuesOfMarks() const {
  LessonValues values(lesson_);
  for (const LessonMark& m : handIn_.marks) {
    if (m.kind == LessonMark::Kind::Said) values.predict(m.step, m.value);
    if (m.kind == LessonMark::Kind::Observed) values.observe(m.step, m.value);
    if (m.kind != LessonMark::Kind::Lived || m.step >= lesson_.steps.size() || !lesson_.steps[m.step].lives) continue;
    for (const LessonLives::Way& way : lesson_.steps[m.step].lives->ways)
      if (way.label == m.text) values.lived(way.place, m.values);
  }
  return values;
}

void LessonDriver::goOn(std::size_t number) {
  const LessonMark* arrived = nullptr;  // as one came there first
  for (const LessonMark& m : handIn_.marks)
    if (!arrived && m.kind == LessonMark::Kind::Arrived && m.step == number && m.life) arrived = &m;
  if (number == 0 || !arrived) return arrive(number, std::nullopt);
  number_ = number;
  setPhase(Phase::Preparing);
  Q_EMIT stepChanged();
  auto made = std::make_shared<Result<LifeInHand>>(Error{"stopped"});
  background_.start(
      [made, record = arrived->life, &registry = registry_, lesson = &lesson_](const std::atomic<bool>& interrupted) {
        *made = relive(registry, *lesson, *record, &interrupted);
      },
      [this, made, number] {
        if (*made) return place(std::move(**made), valuesOfMarks(), [this, number] { arrive(number, std::nullopt); });
        Q_EMIT refused(tr("The lesson begins anew: %1").arg(QString::fromStdString(made->error().message)));
        arrive(0, std::nullopt);
      });
}

std::optional<std::pair<std::int64_t, std::int64_t>> LessonDriver::arrivedAt(std::size_t step) const {
  const auto found = beginnings_.find(step);
  if (found == beginnings_.end() || !found->second.record) return std::nullopt;
  return std::pair(found->second.episodes, found->second.record->steps);
}

bool LessonDriver::keepsLife(const LessonActions& actions) const {
  using Does = LessonAction::Kind;
  return std::all_of(actions.begin(), actions.end(), [this](const LessonAction& a) {
    if (a.kind == Does::Set) {
      const auto* entry = lesson_.start.parameters.find(a.key);
      return entry && entry->parameter.when != When::NewTable;
    }
    return a.kind == Does::Policy || a.kind == Does::Scenario || a.kind == Does::Place || a.kind == Does::Push ||
           a.kind == Does::Run;
  });
}

/// A copy of the life at the step's beginning, with what happens before the step; in the background.
void LessonDriver::prepare() {
  // The copy goes on with the life: its curve takes the place of the one before.
  const bool keeps = keepsLife(step().begin);
  // A life that this one learned from fell elsewhere: it is no comparison.
  const LessonActions& begin = step().begin;
  const auto another = std::find_if(begin.begin(), begin.end(), [this](const auto& a) { return !keepsLife({a}); });
  const bool learnsFromIt = another != begin.end() && another->kind == LessonAction::Kind::Transfer;
  if (!undone_ && (keeps || learnsFromIt)) undone_ = session_->life().curves().live().number;
  if (!keeps) charted_ = false;
  struct Work {
    Beginning beginning;
    LessonActions begin;
    Result<LifeInHand> made = Error{"stopped"};
    std::optional<LessonValues> values{};
  };
  auto work = std::make_shared<Work>(Work{*beginning_, step().begin});
  background_.start(
      [work, &registry = registry_](const std::atomic<bool>& interrupted) {
        auto resumed = resume(registry, work->beginning.checkpoint, {});
        if (!resumed) {
          work->made = resumed.error();
          return;
        }
        LessonLife lived(registry, work->beginning.values,
                         {work->beginning.began, std::move(resumed->life), work->beginning.learnedFrom}, &interrupted);
        const Status done = lived.act(work->begin);
        work->values = lived.values();
        if (done)
          work->made = lived.take();
        else
          work->made = done.error();
      },
      [this, work, entered = entered_] {
        if (entered != entered_) return;
        if (!work->made) {
          Q_EMIT refused(QString::fromStdString(work->made.error().message));
          return open();
        }
        place(std::move(*work->made), std::move(*work->values), [this] { open(); });
      });
}

void LessonDriver::place(LifeInHand life, LessonValues values, const Then& then) {
  if (life.began.start && life.learnedFrom) learned_[life.began.start.get()] = life.learnedFrom;
  auto hand = std::make_shared<LifeInHand>(std::move(life));
  const auto make = [hand](const std::atomic<bool>&) -> Result<NewLives::Made> {
    return NewLives::Made{.configuration = hand->began, .life = std::move(hand->life), .last = hand->last};
  };
  const Status begun = session_->newLives().beginWhenMade(
      make, [this, values = std::move(values), then, entered = entered_](const Status& s) {
        if (entered != entered_) return;
        if (!s) Q_EMIT refused(QString::fromStdString(s.error().message));
        visit([values](const Life&, Knowledge& k) {
          k.values = values;
          k.before = nullptr;
        });
        forgetCurves();
        then();
      });
  static_cast<void>(static_cast<bool>(begun));  // it was told above
}

/// The curves of lives that came after the state that was gone back to.
void LessonDriver::forgetCurves() {
  RunCurves& curves = session_->life().curves();
  const auto restored = std::exchange(restored_, std::nullopt);
  const auto undone = std::exchange(undone_, std::nullopt);
  if (!restored && !undone) return;
  std::vector<int> numbers;
  for (const RunCurve& curve : curves.earlier())
    if (restored || curve.number >= *undone) numbers.push_back(curve.number);
  curves.remove(numbers);
  if (restored) curves.putBack(*restored);
}

/// The step begins.
void LessonDriver::open() {
  renderText();
  const auto& show = step().show;
  charted_ = charted_ || std::any_of(show.begin(), show.end(),
                                     [](const std::string& panel) { return panel == "falls" || panel == "reward"; });
  if (step().lives) liveWays();
  const Then over = [this] {
    session_->life().setTurbo(false);  // from here on a person runs it
    settle([this] {
      setPhase(Phase::Open);
      renderText();
      watchTask();
    });
  };
  const Then observed = [this, over] { step().observe && !step().done ? observe(*step().observe, over) : over(); };
  if (step().run && step().run->ends()) return run(*step().run, observed);
  if (!step().run) return observed();
  settle([this] {
    setPhase(Phase::Open);
    watchTask();
    session_->life().setTurbo(step().run->turbo);
    session_->life().setRunning(true);
  });
}

}  // namespace surefoot
