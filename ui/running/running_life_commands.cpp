// SPDX-License-Identifier: GPL-3.0-or-later
// The part of RunningLife that sends commands to the learner's thread.
#include <algorithm>
#include <tuple>
#include <utility>

#include "core/values_of_state.h"
#include "ui/running/beginning.h"
#include "ui/running/running_life.h"

namespace surefoot {

void RunningLife::wantSteps(bool wants) {
  learner_->wantSteps(wants);
}

void RunningLife::setRunning(bool running) {
  if (running && finished()) return;
  Q_EMIT commanded();
  restartMeasuring();
  running_ = running;
  learner_->send(SetRunning{running});
  Q_EMIT stateChanged();
}

void RunningLife::setTurbo(bool turbo) {
  restartMeasuring();
  turbo_ = turbo;
  learner_->send(SetTurbo{turbo});
  Q_EMIT stateChanged();
}

void RunningLife::setPace(double pace) {
  restartMeasuring();
  pace_ = pace;
  learner_->send(SetPace{pace});
  Q_EMIT stateChanged();
}

void RunningLife::stepOnce() {
  if (running_) setRunning(false);
  learner_->send(SingleStep{});
}

void RunningLife::hold(std::optional<double> target) {
  learner_->send(SetHand{target});
}

Status RunningLife::place(const std::vector<double>& state) {
  if (running_) return Error{tr("Pause first; then a click on the map puts the body into that state.").toStdString()};
  std::vector<double> inside = state;
  for (std::size_t d = 0; d < inside.size(); ++d)
    inside[d] = std::clamp(inside[d], task().state[d].low, task().state[d].high);
  if (const Status s = checkState(task(), inside); !s) return s;
  learner_->send(Place{inside});
  return Done{};
}

Status RunningLife::goOn(EpisodeInputs until) {
  if (finished()) return Error{tr("The life is complete; nothing goes on in it.").toStdString()};
  if (!environment().answersAtOnce())
    return Error{tr("A program moves this robot; it cannot be put back into a moment.").toStdString()};
  learner_->send(GoOn{std::move(until)});
  return Done{};
}

Status RunningLife::setParameter(const std::string& key, double value) {
  Configuration changed = configuration();
  if (const Status s = changed.parameters.set(key, value); !s) return s;
  if (key.starts_with("policy."))
    if (const Status s = checkCaution(changed); !s) return s;
  const bool elsewhere = key.starts_with("environment.");
  if (elsewhere) {
    auto environment = makeEnvironment(registry_, changed);
    if (!environment) return environment.error();
    environment_ = std::move(*environment);
  }
  known_.configuration = std::move(changed);
  learner_->send(SetParameter{key, value});
  Q_EMIT parameterChanged(QString::fromStdString(key));
  Q_EMIT configurationChanged();
  return Done{};
}

Status RunningLife::checkCaution(const Configuration& changed) const {
  const ValueSnapshot* learned = values();
  if (!learned || !isShown()) return Done{};
  auto policy = makePolicy(registry_, changed.names.policy, changed.parameters);
  if (!policy) return policy.error();
  return (*policy)->caution().check(usableBy(*learned->values, task().handMade, changed.teacher != nullptr));
}

Status RunningLife::setTeacher(std::shared_ptr<const TensorFile> file) {
  auto teacher = makeTeacher(registry_, *file, task());
  if (!teacher) return teacher.error();
  known_.began.teacher = known_.configuration.teacher = std::move(file);  // what is saved goes back to the beginning
  learner_->send(SetTeacher{std::move(*teacher)});
  return Done{};
}

Status RunningLife::setPolicy(const std::string& name) {
  auto policy = makePolicy(registry_, name, configuration().parameters);
  if (!policy) return policy.error();
  known_.configuration.names.policy = name;
  learner_->send(SetPolicy{name, std::move(*policy)});
  Q_EMIT policyChanged();
  Q_EMIT configurationChanged();
  return Done{};
}

void RunningLife::setScenario(const std::string& name) {
  known_.configuration.names.scenario = name;
  known_.base = knownAs(registry_, configuration(), {}).base;
  Q_EMIT configurationChanged();
}

void RunningLife::setFile(LifeFile file) {
  known_.file = std::move(file);
  Q_EMIT fileChanged();
}

void RunningLife::visit(std::function<void(const Life&)> look) {
  learner_->send(Visit{std::move(look)});
}

void RunningLife::watch(std::function<Watching(const Life&)> look) {
  learner_->send(Watch{std::move(look)});
}

void RunningLife::push(double impulse) {
  learner_->send(Push{impulse});
}

void RunningLife::replace(KnownLife known, ReplaceLife replacement) {
  Q_EMIT aboutToBeReplaced();
  const Names before = std::exchange(known_, std::move(known)).configuration.names;
  const Names& now = known_.configuration.names;
  numbers_ = {.episodes = known_.progress.episodes, .falls = known_.falls, .steps = known_.progress.steps};
  curves_.setBegan(beginningOf(known_.began));
  makeEnvironmentAnew();
  replacement.last = known_.last;
  learner_->send(std::move(replacement));
  ++lifeSent_;
  Q_EMIT replaced();
  Q_EMIT fileChanged();
  if (std::tie(now.environment, now.preset, now.agent, now.features) !=
      std::tie(before.environment, before.preset, before.agent, before.features))
    Q_EMIT parametersReplaced();
  Q_EMIT configurationChanged();
}

}  // namespace surefoot
