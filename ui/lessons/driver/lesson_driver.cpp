// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/driver/lesson_driver.h"

#include <algorithm>
#include <utility>

#include "core/saved/checkpoint.h"

namespace surefoot {

namespace {

Configuration startOf(const Lesson& lesson, const HandIn& handIn) {
  Configuration start = lesson.start;
  start.seed = handIn.seed;
  return start;
}

}  // namespace

LessonDriver::LessonDriver(const Registry& registry, Lesson lesson, HandIn handIn, QObject* parent)
    : QObject(parent),
      registry_(registry),
      lesson_(std::move(lesson)),
      handIn_(std::move(handIn)),
      knowledge_(std::make_shared<Knowledge>(Knowledge{LessonValues(lesson_), nullptr})),
      session_(std::make_unique<Session>(registry, startOf(lesson_, handIn_), true)),
      progress_(std::make_shared<std::atomic<double>>(0.0)) {
  for (const LessonMark& m : handIn_.marks) {
    if (m.kind == LessonMark::Kind::Said) predicted_[m.step] = m.value;
    if (m.kind == LessonMark::Kind::Observed) observed_[m.step] = m.value;
    if (m.kind == LessonMark::Kind::Words || (m.kind == LessonMark::Kind::Answered && m.right))
      answered_.insert(m.step);
  }
  connect(&background_, &Background::failed, this, &LessonDriver::refused);
  connect(&session_->newLives(), &NewLives::refused, this, &LessonDriver::refused);
  connect(&session_->life(), &RunningLife::aboutToBeReplaced, this, [this] {
    visit([this_ = &lesson_, began = session_->life().began(), from = learnedFrom()](const Life& life, Knowledge& k) {
      k.values.endLife(factsOf(life));
      k.before = std::make_shared<const LifeRecord>(recordOf(*this_, began, life, from));
    });
  });
  connect(&session_->life(), &RunningLife::replaced, this, [this] { attemptOver_ = false; });
  for (const auto changed : {&RunningLife::replaced, &RunningLife::configurationChanged, &RunningLife::stateChanged})
    connect(&session_->life(), changed, this, [this] {
      if (phase_ == Phase::Open) watchTask();
    });
}

LessonDriver::~LessonDriver() {
  background_.cancel();
  session_->life().finish();  // its thread knows the queue of calls
}

std::optional<double> LessonDriver::predicted(std::size_t step) const {
  const auto found = predicted_.find(step);
  return found == predicted_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> LessonDriver::observed(std::size_t step) const {
  const auto found = observed_.find(step);
  return found == observed_.end() ? std::nullopt : std::optional(found->second);
}

std::shared_ptr<const LifeRecord> LessonDriver::learnedFrom() const {
  const auto found = learned_.find(session_->life().began().start.get());
  return found == learned_.end() ? nullptr : found->second;
}

LessonDriver::Record LessonDriver::recorder() const {
  return [lesson = &lesson_, began = session_->life().began(), from = learnedFrom()](
             const Life& life, const Knowledge& k, LessonMark& m) {
    m.life = std::make_shared<const LifeRecord>(recordOf(*lesson, began, life, from));
    m.before = k.before;
  };
}

void LessonDriver::visit(std::function<void(const Life&, Knowledge&)> look, Then then) {
  session_->life().visit([this, look = std::move(look), then = std::move(then), knowledge = knowledge_,
                          entered = entered_](const Life& life) {
    look(life, *knowledge);
    if (!then) return;
    calls_.post([this, then, entered] {
      if (entered == entered_) then();
    });
  });
}

void LessonDriver::know(std::function<void(LessonValues&)> change) {
  visit([change = std::move(change)](const Life&, Knowledge& k) { change(k.values); });
}

void LessonDriver::setPhase(Phase phase) {
  phase_ = phase;
  Q_EMIT phaseChanged();
}

bool LessonDriver::mayGoOn() const {
  if (phase_ != Phase::Open) return false;
  if (step().predict) return observed(number_).has_value();
  if (step().done) return taskDone_;
  return !step().ask || answered();
}

void LessonDriver::copyLife(std::function<void(Configuration began, std::unique_ptr<Life>)> then) {
  auto copy = std::make_shared<std::pair<Configuration, TensorFile>>();
  visit(
      [copy, began = session_->life().began()](const Life& life, Knowledge&) {
        *copy = {began, checkpointOf(life, began, true)};
      },
      [this, copy, then] {
        auto resumed = resume(registry_, std::make_shared<const TensorFile>(std::move(copy->second)), {});
        if (!resumed) return Q_EMIT refused(QString::fromStdString(resumed.error().message));
        then(copy->first, std::move(resumed->life));
      });
}

}  // namespace surefoot

#include "moc_lesson_driver.cpp"
