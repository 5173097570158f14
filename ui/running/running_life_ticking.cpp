// SPDX-License-Identifier: GPL-3.0-or-later
// The part of RunningLife that takes data from the learner's thread, and measures how fast it is.
#include "ui/running/running_life.h"

namespace surefoot {

namespace {
constexpr int kValuesEvery = 100;   // [ms]
constexpr double kSpeedOver = 0.5;  // [s]
}  // namespace

void RunningLife::tick() {
  const double seconds = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  clock_.restart();
  learner_->takeSnapshot();
  learner_->wantSnapshot();
  if (learner_->takeValues() && values()) takeValues();
  if (lookedAt_ && sinceValues_.elapsed() >= kValuesEvery) {
    sinceValues_.restart();
    learner_->wantValues();
  }
  if (std::exchange(lifeMeasured_, snapshot().life) != snapshot().life) restartMeasuring();
  if (running_ && finished()) {
    running_ = false;
    learner_->send(SetRunning{false});
    Q_EMIT stateChanged();
  }
  measureSpeed(seconds);
  Q_EMIT ticked(seconds);
}

void RunningLife::takeValues() {
  const ValueSnapshot& v = *values();
  curves_.update(configuration().names.agent, v.policy, v.curve, v.changes);
  numbers_ = {.episodes = v.totals.episodes,
              .falls = v.totals.falls,
              .fallsByHand = v.fallsByHand,
              .steps = v.steps,
              .simulatedSeconds = v.simulatedSeconds,
              .stepsPerSecond = stepsPerSecond_};
  Q_EMIT valuesArrived();
}

bool RunningLife::obeyed() const {
  const Snapshot& s = snapshot();
  return isShown() && s.running == running_ && s.turbo == turbo_ && s.pace == pace_;
}

void RunningLife::measureSpeed(double seconds) {
  speedSeconds_ += seconds;
  if (!obeyed()) return restartMeasuring();
  if (!measuring_) stepsBefore_ = snapshot().steps, speedSeconds_ = 0, measuring_ = true;
  if (speedSeconds_ < kSpeedOver) return;
  stepsPerSecond_ = static_cast<double>(snapshot().steps - stepsBefore_) / speedSeconds_;
  stepsBefore_ = snapshot().steps;
  speedSeconds_ = 0;
}

void RunningLife::restartMeasuring() {
  numbers_.stepsPerSecond = stepsPerSecond_ = 0;
  measuring_ = false;  // until the learner has got the change
}

}  // namespace surefoot
