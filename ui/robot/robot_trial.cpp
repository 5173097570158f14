// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robot/robot_trial.h"

#include <algorithm>
#include <cmath>

#include "ui/language/from_core.h"

namespace surefoot {

namespace {

constexpr int kFrame = 16;  // [ms]

/// The action nearest to doing nothing.
Action stillAction(const Task& task) {
  if (task.actionVariables.empty()) {
    const auto nearest = std::min_element(task.actions.begin(), task.actions.end(),
                                          [](double a, double b) { return std::abs(a) < std::abs(b); });
    return static_cast<Action>(nearest - task.actions.begin());
  }
  Action action = 0;
  for (const ActionVariable& v : task.actionVariables) {
    const auto nearest = std::min_element(v.levels.begin(), v.levels.end(),
                                          [](double a, double b) { return std::abs(a) < std::abs(b); });
    action = action * static_cast<Action>(v.levels.size()) + static_cast<Action>(nearest - v.levels.begin());
  }
  return action;
}

}  // namespace

RobotTrial::RobotTrial(QObject* parent) : QObject(parent) {
  timer_.setInterval(kFrame);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &RobotTrial::advance);
}

void RobotTrial::start(const EnvironmentFile& file, Mode mode) {
  environment_ = mode == Mode::Passive && file.passive   ? file.passive()
                 : mode == Mode::Dropped && file.dropped ? file.dropped()
                                                         : file.entry.make();
  random_ = Random(static_cast<std::uint64_t>(1000 + episodes_));
  environment_->reset(random_);
  until_ = -1, rest_ = 0, due_ = 0;
  setMode(mode);
  timer_.start();
  show();
}

void RobotTrial::replay(const EnvironmentFile& file, int begin, int fall) {
  environment_ = file.entry.make();
  random_ = Random(1);
  mode_ = Mode::Random;
  environment_->reset(random_);
  for (int step = 0; step < begin; ++step)
    if (environment_->step(chosen()).ending != Ending::None) environment_->reset(random_);
  until_ = fall - begin, rest_ = 0, due_ = 0;
  timer_.start();
  show();
}

void RobotTrial::stop() {
  if (!environment_) return;
  timer_.stop();
  environment_.reset();
  Q_EMIT stopped();
}

void RobotTrial::setMode(Mode mode) {
  mode_ = mode;
  if (environment_) action_ = stillAction(environment_->task());
}

Action RobotTrial::chosen() {
  const auto actions = static_cast<double>(environment_->task().actions.size());
  if (mode_ == Mode::Random) return static_cast<Action>(random_.uniform() * actions);
  return mode_ == Mode::HandMade && environment_->task().handMade ? kHandMade : action_;
}

void RobotTrial::advance() {
  constexpr int kRest = 40;  // frames
  if (rest_ > 0) {
    if (--rest_ > 0) return;
    if (until_ == 0) return stop();
    environment_->reset(random_);
  }
  due_ += kFrame / 1000.0 / environment_->task().stepTime.value_or(0.05);
  while (due_ >= 1.0 && rest_ == 0) {
    due_ -= 1.0;
    const Outcome outcome = environment_->step(chosen());
    if (until_ > 0) --until_;
    if (outcome.ending == Ending::None && until_ != 0) continue;
    ++episodes_;
    rest_ = kRest;
  }
  show();
}

void RobotTrial::show() {
  Scene scene;
  environment_->draw(environment_->pose(), scene);
  Q_EMIT moved(scene);
}

bool RobotTrial::press(int key) {
  if (!environment_) return false;
  const Task& task = environment_->task();
  if (key == Qt::Key_Left || key == Qt::Key_Right) return environment_->push(key == Qt::Key_Left ? -0.2 : 0.2);
  if (key < Qt::Key_1 || key > Qt::Key_9) return false;
  int number = key - Qt::Key_1;
  mode_ = Mode::Keys;
  if (task.actionVariables.empty()) {
    if (number < static_cast<int>(task.actions.size())) action_ = number;
    return true;
  }
  // 1 … n: the next level of actuator 1 … n, from the last to the first again.
  std::vector<std::size_t> levels;
  auto rest = static_cast<std::size_t>(action_);
  for (auto v = task.actionVariables.rbegin(); v != task.actionVariables.rend(); ++v)
    levels.insert(levels.begin(), rest % v->levels.size()), rest /= v->levels.size();
  if (number >= static_cast<int>(levels.size())) return true;
  auto& level = levels[static_cast<std::size_t>(number)];
  level = (level + 1) % task.actionVariables[static_cast<std::size_t>(number)].levels.size();
  action_ = 0;
  for (std::size_t v = 0; v < levels.size(); ++v)
    action_ = action_ * static_cast<Action>(task.actionVariables[v].levels.size()) + static_cast<Action>(levels[v]);
  return true;
}

QString RobotTrial::words() const {
  if (!environment_) return {};
  const Task& task = environment_->task();
  if (until_ >= 0) return tr("a fall of the random life");
  if (task.actionVariables.empty())
    return tr("keys 1 … %1: %2; ← → push")
        .arg(QString::number(std::min<std::size_t>(9, task.actions.size())), fromCore(task.actionTitle));
  return tr("keys 1 … %1: the next level of each motor; ← → push").arg(task.actionVariables.size());
}

}  // namespace surefoot

#include "moc_robot_trial.cpp"
