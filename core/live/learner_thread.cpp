// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/live/learner_thread.h"

#include <algorithm>
#include <utility>

#include "core/basics/guarded_call.h"

namespace surefoot {

namespace {
constexpr int kBatch = 256;            // steps between two looks at the flags, where a step takes no time
constexpr double kNoClockStep = 0.05;  // [s]
constexpr auto kIdle = std::chrono::milliseconds(100);
constexpr auto kLag =
    std::chrono::milliseconds(100);  // a life that fell behind (a busy machine) does not race to catch up

double stepTimeOf(const Life& life) {
  return life.environment().task().stepTime.value_or(kNoClockStep);
}

/// The curve of a life that may have begun elsewhere: all its episodes if it has the rows, else only the last one.
LearningCurve curveOf(const Life& life) {
  LearningCurve curve;
  std::int64_t falls = 0;
  for (const EpisodeRow& row : life.log().rows()) curve.add(row, falls += row.falls);
  if (life.log().rows().empty() && life.log().last().episode > 0)
    curve.add(life.log().last(), life.log().totals().falls);
  return curve;
}
}  // namespace

LearnerThread::LearnerThread(std::unique_ptr<Life> life)
    : life_(std::move(life)),
      curve_(curveOf(*life_)),
      curvePolicy_(life_->policyName()),
      stepTime_(stepTimeOf(*life_)),
      thread_([this] { run(); }) {}

LearnerThread::~LearnerThread() {
  stop();
}

std::unique_ptr<Life> LearnerThread::stop() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  if (thread_.joinable()) thread_.join();
  return std::move(life_);
}

void LearnerThread::send(Command command) {
  {
    const std::lock_guard lock(mutex_);
    mailbox_.push_back(std::move(command));
    mail_ = true;
  }
  wake_.notify_one();
}

void LearnerThread::want(std::atomic<bool>& flag) {
  if (flag.exchange(true, std::memory_order_relaxed)) return;
  wake_.notify_one();  // without the lock: a wake-up that is missed costs kIdle at most
}

void LearnerThread::run() {
  while (!stop_.load(std::memory_order_relaxed)) {
    const std::string trouble = troubleOf([this] { lifeOn(); });
    if (trouble.empty()) continue;
    trouble_ = trouble;  // a copy of a table did not fit, say; the life itself goes on no more
    valuesWanted_ = false;
  }
}

void LearnerThread::lifeOn() {
  if (std::exchange(mustBegin_, false)) beginLife();
  if (mail_.load(std::memory_order_relaxed)) obey();
  if (!canStep())
    wait();
  else if (turbo_)
    stepFlatOut();
  else
    stepInPace();
  answer();
}

void LearnerThread::beginLife() {
  life_->begin();
  noteAnswer();
  snapshotWanted_ = true;
}

bool LearnerThread::noteAnswer() {
  if (life_->unanswered().empty()) return true;
  ++unansweredTries_;
  running_ = false;
  snapshotWanted_ = true;
  return false;
}

void LearnerThread::wait() {
  std::unique_lock lock(mutex_);
  wake_.wait_for(lock, kIdle, [this] { return stop_ || mail_ || snapshotWanted_ || valuesWanted_; });
}

void LearnerThread::step() {
  const std::int64_t before = life_->log().totals().episodes;
  if (hand_.holds() && !turbo_) life_->push(hand_.impulse(life_->environment(), stepTime_));
  if (!turbo_ && life_->inEpisode()) {
    const auto state = life_->environment().state();
    last_.state.assign(state.begin(), state.end());
    last_.action = life_->nextAction();
  }
  constexpr std::size_t kMostSeen = 2000;  // between two snapshots
  const bool sees = stepsWanted_ && !turbo_ && life_->inEpisode() && seen_.size() < kMostSeen;
  if (sees) seen_.push_back(stepToCome());
  life_->step(&stop_);
  if (sees) seen_.back().outcome = life_->outcome();
  if (!noteAnswer()) return;
  if (life_->log().totals().episodes != before) noteEpisode();
  if (watch_) beWatched();
}

void LearnerThread::beWatched() {
  const Watching seen = watch_(*life_);
  if (seen == Watching::GoOn) return;
  watch_ = nullptr;
  if (seen == Watching::EnoughAndPause) running_ = false;
  snapshotWanted_ = valuesWanted_ = true;
}

void LearnerThread::noteEpisode() {
  const LifeTotals& totals = life_->log().totals();
  curve_.add(life_->log().last(), totals.falls);
  curvePolicy_ = life_->policyName();
  if (life_->log().last().falls == 0) return;
  if (!turbo_) fallenPose_ = life_->environment().pose();
  noteFall();
}

void LearnerThread::noteFall() {
  // A change holds from the next episode on, so one look at the fall after it is not enough.
  if (life_->changes().size() != changesSeen_) changesSeen_ = life_->changes().size(), looksLeft_ = 2;
  if (!environment_ || looksLeft_ > 0 || life_->changesLeftOut()) {
    environment_ = std::make_shared<const std::vector<std::pair<std::string, double>>>(life_->environmentInForce());
    --looksLeft_;
  }
  const EpisodeRow& row = life_->log().last();
  const std::lock_guard lock(mutex_);
  falls_.push_back({.life = lifeNumber_,
                    .number = life_->log().totals().falls,
                    .episode = row.episode,
                    .lifeSteps = row.lifeSteps,
                    .policy = life_->policyName(),
                    .inputs = life_->inputs(),
                    .parameters = environment_});
  if (falls_.back().byHand()) fallsByHand_ += row.falls;
  thinOut(falls_);
}

std::vector<Fall> LearnerThread::takeFalls() {
  const std::lock_guard lock(mutex_);
  return std::exchange(falls_, {});
}

void LearnerThread::stepFlatOut() {
  const int batch = life_->environment().answersAtOnce() ? kBatch : 1;
  for (int i = 0; i < batch && running_ && !isOver(); ++i) step();
}

void LearnerThread::stepInPace() {
  const auto now = Clock::now();
  if (nextStep_ + kLag < now) nextStep_ = now;
  if (nextStep_ > now) {
    std::unique_lock lock(mutex_);
    wake_.wait_until(lock, std::min(nextStep_, now + kIdle),
                     [this] { return stop_ || mail_ || snapshotWanted_ || valuesWanted_; });
    if (Clock::now() < nextStep_) return;
  }
  step();
  nextStep_ += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(stepTime_ / pace_));
}

void LearnerThread::obey() {
  std::vector<Command> commands;
  {
    const std::lock_guard lock(mutex_);
    commands.swap(mailbox_);
    mail_ = false;
  }
  for (Command& command : commands) {
    const std::string trouble = troubleOf([&] { carryOut(command); });
    if (!trouble.empty()) trouble_ = trouble;  // the other commands are carried out nevertheless
  }
  snapshotWanted_ = true;  // the effect of a command shows at once, paused or not
}

void LearnerThread::carryOut(Command& command) {
  struct Visitor {
    LearnerThread& t;
    void operator()(SetParameter& c) const { static_cast<void>(static_cast<bool>(t.life_->set(c.key, c.value))); }
    void operator()(SetPolicy& c) const { t.life_->setPolicy(c.name, std::move(c.policy)); }
    void operator()(SetTeacher& c) const { t.life_->setTeacher(std::move(c.teacher)); }
    void operator()(SetRunning& c) const { t.running_ = c.running; }
    void operator()(SetPace& c) const { t.pace_ = c.pace; }
    void operator()(SetTurbo& c) const { t.turbo_ = c.turbo; }
    void operator()(SetHand& c) const { t.hand_.hold(c.target); }
    void operator()(GoOn& c) const { static_cast<void>(static_cast<bool>(t.life_->goOn(c.until))); }
    void operator()(Place& c) const { static_cast<void>(static_cast<bool>(t.life_->place(c.state))); }
    void operator()(Visit& c) const { c.look(*t.life_); }
    void operator()(SingleStep&) const {
      if (!t.running_ && !t.isOver()) t.step();
    }
    void operator()(Watch& c) const { t.watch_ = std::move(c.look); }
    void operator()(Push& c) const { t.life_->push(c.impulse); }
    void operator()(ReplaceLife& c) const { t.replace(c); }
  };
  std::visit(Visitor{*this}, command);
}

void LearnerThread::replace(ReplaceLife& c) {
  if (!c.life && !(c.back && c.back->life)) return;
  if (c.before)
    *c.before = {std::move(life_), std::move(curve_), std::move(curvePolicy_), std::move(fallenPose_), fallsByHand_};
  LifeAside next;
  if (c.life)
    next = {.life = nullptr, .curve = curveOf(*c.life), .curvePolicy = c.life->policyName(), .fallenPose = {}};
  else
    next = std::exchange(*c.back, {});
  life_ = c.life ? std::move(c.life) : std::move(next.life);
  ++lifeNumber_;
  curve_ = std::move(next.curve);
  curvePolicy_ = std::move(next.curvePolicy);
  fallenPose_ = std::move(next.fallenPose);
  fallsByHand_ = next.fallsByHand;
  last_ = std::move(c.last);
  seen_.clear(), seenPublished_ = 0;  // they were of the life before
  environment_.reset();
  hand_.hold(std::nullopt);
  watch_ = nullptr;
  trouble_.clear();
  mustBegin_ = true;
  stepTime_ = stepTimeOf(*life_);
  valuesWanted_ = true;
}

}  // namespace surefoot
