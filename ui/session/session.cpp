// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/session.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <new>

#include "core/schedule.h"
#include "core/text/text.h"
#include "ui/session/beginning.h"

namespace surefoot {

namespace {
constexpr int kFrame = 16;         // [ms]
constexpr int kValuesEvery = 100;  // [ms]
constexpr int kFlash = 200;        // [ms]
}  // namespace

Session::Session(const Registry& registry, Configuration configuration, bool keepRows, QObject* parent)
    : QObject(parent),
      registry_(registry),
      configuration_(std::move(configuration)),
      began_(configuration_),
      keepRows_(keepRows) {
  base_ = baseOf(configuration_.names);
  curvesIn_ = configuration_.names.environment;
  auto life = makeLifeOf(configuration_);
  assert(life && "the configuration was checked before");
  bytesOfLife_ = (*life)->agent().values().bytes();
  curves_.setBegan(beginningOf(began_));
  learner_ = std::make_unique<LearnerThread>(std::move(*life));
  makeViewer();
  connect(&background_, &Background::failed, this, &Session::refused);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Session::tick);
  timer_.start(kFrame);
  clock_.start();
  sinceValues_.start();
}

Session::~Session() = default;

Result<std::unique_ptr<Life>> Session::makeLifeOf(const Configuration& configuration) const {
  try {
    auto life = makeLife(registry_, configuration, 0, keepRows_);
    if (life) (*life)->keepInputs();  // so that it can be saved in the middle of an episode
    return life;
  } catch (const std::bad_alloc&) {
    return Error{"There is not enough memory for this; take fewer tiles or tilings."};
  }
}

Parameters Session::baseOf(const Names& names) const {
  const auto plain = configure(registry_, names, {});
  return plain ? plain->parameters : configuration_.parameters;
}

void Session::makeViewer() {
  auto environment = makeEnvironment(registry_, configuration_);
  auto policy = makePolicy(registry_, configuration_.names.policy, configuration_.parameters);
  assert(environment && policy);
  viewer_ = std::make_unique<Viewer>(std::move(*environment), std::move(*policy),
                                     deriveSeed(configuration_.seed, 0, Stream::Viewer));
}

const ValueSnapshot* Session::values() const {
  const ValueSnapshot& v = learner_->values();
  return v.values && v.life == lifeSent_ ? &v : nullptr;
}

QString Session::factorText() const {
  const double factor = numbers_.stepsPerSecond * task().stepTime.value_or(0.0);
  if (factor <= 0) return {};
  const double unit = factor >= 1000 ? 100 : factor >= 100 ? 10 : 1;
  return QStringLiteral("×") +
         QString::fromStdString(factor < 9.95 ? fixedText(factor, 1) : countText(std::round(factor / unit) * unit));
}

std::optional<std::int64_t> Session::changedAt(const std::string& key) const {
  const ValueSnapshot* v = values();
  if (!v) return std::nullopt;
  for (auto change = v->changes.rbegin(); change != v->changes.rend(); ++change)
    if (change->key == key) return change->step;
  return std::nullopt;
}

void Session::tick() {
  const double seconds = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  clock_.restart();
  learner_->takeSnapshot();
  learner_->wantSnapshot();
  if (learner_->takeValues() && values()) takeValues();
  if (lookedAt_ && sinceValues_.elapsed() >= kValuesEvery) {
    sinceValues_.restart();
    learner_->wantValues();
  }
  if (snapshot().life != lifeShown_) {
    lifeShown_ = snapshot().life;
    fallsBefore_ = snapshot().totals.falls;
    restartMeasuring();
  }
  if (running_ && runFinished()) {
    running_ = false;
    learner_->send(SetRunning{false});
    Q_EMIT stateChanged();
  }
  speedSeconds_ += seconds;
  measureSpeed();
  if (playback_)
    showPlayback(seconds);
  else
    show(seconds);
  Q_EMIT frame();
}

void Session::takeValues() {
  const ValueSnapshot& v = *values();
  curves_.update(configuration_.names.agent, v.policy, v.curve, v.changes);
  numbers_ = {.episodes = v.totals.episodes,
              .falls = v.totals.falls,
              .fallsByHand = v.fallsByHand,
              .steps = v.steps,
              .simulatedSeconds = v.simulatedSeconds,
              .stepsPerSecond = stepsPerSecond_};
  takeFalls();
  Q_EMIT valuesArrived();
}

bool Session::obeyed() const {
  const Snapshot& s = snapshot();
  return s.life == lifeSent_ && s.running == running_ && s.turbo == turbo_ && s.pace == pace_;
}

void Session::measureSpeed() {
  constexpr double kOver = 0.5;  // [s]
  if (!obeyed()) return restartMeasuring();
  if (!measuring_) stepsBefore_ = snapshot().steps, speedSeconds_ = 0, measuring_ = true;
  if (speedSeconds_ < kOver) return;
  stepsPerSecond_ = static_cast<double>(snapshot().steps - stepsBefore_) / speedSeconds_;
  stepsBefore_ = snapshot().steps;
  speedSeconds_ = 0;
}

void Session::restartMeasuring() {
  numbers_.stepsPerSecond = stepsPerSecond_ = 0;
  measuring_ = false;  // until the learner has heard of what changed
}

CurvePoint Session::latest() const {
  const auto& points = curves_.live().points;
  return points.empty() ? CurvePoint{} : points.back();
}

void Session::show(double seconds) {
  if (snapshot().life != lifeSent_) return;  // that of the life before, perhaps in another environment
  const bool viewing = turbo_ && running_ && values();
  std::int64_t falls = snapshot().totals.falls;
  if (viewing) {
    viewer_->policy().advance(lifeTime());
    viewer_->advance(seconds, *values()->values);
    shown_.state.assign(viewer_->environment().state().begin(), viewer_->environment().state().end());
    shown_.pose = viewer_->pose();
    shown_.q.resize(task().actions.size());
    values()->values->evaluate(shown_.state, Layer::Sum, shown_.q);  // the viewer's own are of the step before
    fillParts(*values()->values);
    shown_.action = viewer_->action();
    falls = viewer_->falls();
  } else {
    shown_.state = snapshot().state;
    shown_.pose = snapshot().pose;
    shown_.q = snapshot().q;
    shown_.qPositive = snapshot().qPositive;
    shown_.qNegative = snapshot().qNegative;
    shown_.action = snapshot().action;
  }
  if (falls == fallsBefore_ + 1) sinceFall_.start();  // one fall; a jump by many is a change of the world shown
  fallsBefore_ = falls;
  shown_.flash = sinceFall_.isValid() && sinceFall_.elapsed() < kFlash;
  // The next episode has begun already, but a fall wants to be seen: the fallen pose stays for as long as the flash.
  if (shown_.flash && !viewing && !snapshot().fallenPose.empty()) shown_.pose = snapshot().fallenPose;
  if (running_ || recording_.size() == 0) recording_.add(shown_);
}

void Session::fillParts(const ActionValueFunction& values) {
  for (auto* part : {&shown_.qPositive, &shown_.qNegative}) part->resize(values.split() ? shown_.q.size() : 0);
  if (!values.split()) return;
  values.evaluate(shown_.state, Layer::Positive, shown_.qPositive);
  values.evaluate(shown_.state, Layer::Negative, shown_.qNegative);
}

LifeTime Session::lifeTime() const {
  const ValueSnapshot* v = values();
  const std::optional<double> rule = v && v->rule ? std::optional(v->rule->threshold) : std::nullopt;
  return {numbers_.episodes, numbers_.steps, rule};
}

double Session::threshold() const {
  Scheduled threshold(0.0);
  Fields fields("policy.");
  threshold.declare(fields, {.key = "threshold", .title = "", .low = 0, .high = 0, .help = ""}, true);
  configuration_.parameters.apply(fields);
  threshold.advance(lifeTime());
  return threshold.now();
}

void Session::setRunning(bool running) {
  if (running && runFinished()) return;
  backToLive();
  restartMeasuring();
  running_ = running;
  learner_->send(SetRunning{running});
  Q_EMIT stateChanged();
}

void Session::setTurbo(bool turbo) {
  restartMeasuring();
  turbo_ = turbo;
  learner_->send(SetTurbo{turbo});
  Q_EMIT stateChanged();
}

void Session::setPace(double pace) {
  restartMeasuring();
  pace_ = pace;
  learner_->send(SetPace{pace});
  Q_EMIT stateChanged();
}

void Session::hold(std::optional<double> target) {
  viewer_->hold(target);
  learner_->send(SetHand{target});
}

Status Session::place(const std::vector<double>& state) {
  if (running_) return Error{tr("Pause first; then a click on the map puts the body into that state.").toStdString()};
  std::vector<double> inside = state;
  for (std::size_t d = 0; d < inside.size(); ++d)
    inside[d] = std::clamp(inside[d], task().state[d].low, task().state[d].high);
  if (const Status s = checkState(task(), inside); !s) return s;
  learner_->send(Place{inside});
  return Done{};
}

void Session::stepOnce() {
  if (playback_ && playback_->rate == 0) return lookBack(+1);
  if (running_) setRunning(false);
  learner_->send(SingleStep{});
}

std::unique_ptr<Life> Session::finish() {
  timer_.stop();
  return learner_->stop();
}

}  // namespace surefoot
