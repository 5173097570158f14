// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robustness/robustness_run.h"

#include <fmt/format.h>

#include <QPointer>
#include <algorithm>
#include <new>
#include <thread>

#include "core/saved/q_file.h"
#include "ui/running/running_life.h"
#include "ui/session/life_files.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

/// A core is left to the learner.
int jobsBesideTheLearner() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
}

Result<Robustness> triedOut(const Registry& registry, const std::shared_ptr<const TensorFile>& function,
                            const std::string& second, const RobustnessQuestion& question,
                            const std::atomic<bool>& interrupted, const std::function<void(double)>& progress) {
  std::vector<TriedFunction> tried;
  auto first = makeTried(registry, "learned here", function);
  if (!first) return first.error();
  tried.push_back(std::move(*first));
  if (!second.empty()) {
    auto file = readQFile(second);
    if (!file) return file.error();
    auto other = makeTried(registry, second, std::move(*file));
    if (!other) return other.error();
    tried.push_back(std::move(*other));
  }
  std::vector<const TriedFunction*> functions;
  for (const TriedFunction& t : tried) functions.push_back(&t);
  const auto plan = makeRobustnessPlan(registry, functions, question);
  if (!plan) return plan.error();
  if (plan->models.size() > RobustnessRun::kMostRows || plan->pushes.size() > RobustnessRun::kMostColumns)
    return Error{
        fmt::format("{} models and {} pushes are no map any more; at most {} and {} are shown here, and "
                    "`surefoot robustness` takes more.",
                    plan->models.size(), plan->pushes.size(), RobustnessRun::kMostRows, RobustnessRun::kMostColumns)};
  return tryOut(registry, *plan, functions, jobsBesideTheLearner(), &interrupted, progress);
}

}  // namespace

RobustnessRun::RobustnessRun(RunningLife& life, LifeFiles& files, QObject* parent)
    : QObject(parent),
      life_(life),
      files_(files) {
  connect(&background_, &Background::busyChanged, this, &RobustnessRun::changed);
  connect(&background_, &Background::failed, this, &RobustnessRun::refused);
}

void RobustnessRun::start(const RobustnessQuestion& question, const std::string& second) {
  copying_ = true;
  share_ = 0.0;
  const std::uint64_t number = ++number_;
  files_.copyFunction([here = QPointer(this), number, question, second](const LifeFiles::Function& function) {
    if (!here || here->number_ != number) return;
    here->copying_ = false;
    if (function) return here->tryWith(question, second, *function);
    Q_EMIT here->refused(toText(function.error().message));
    Q_EMIT here->changed();
  });
  Q_EMIT changed();
}

void RobustnessRun::cancel() {
  ++number_;
  copying_ = false;
  background_.cancel();
  Q_EMIT changed();
}

void RobustnessRun::tryWith(const RobustnessQuestion& question, const std::string& second,
                            const std::shared_ptr<const TensorFile>& function) {
  const auto outcome = std::make_shared<Result<Robustness>>(Error{});
  background_.start(
      [this, &registry = life_.registry(), question, second, function, outcome](const std::atomic<bool>& interrupted) {
        const auto progress = [this](double share) {
          share_ = share;
          calls_.post([this] { Q_EMIT changed(); });
        };
        try {
          *outcome = triedOut(registry, function, second, question, interrupted, progress);
        } catch (const std::bad_alloc&) {
          *outcome = Error{QObject::tr("There is not enough memory to try this Q-function.").toStdString()};
        }
      },
      [this, function, outcome] {
        if (!*outcome) return Q_EMIT refused(toText(outcome->error().message));
        result_ = std::make_shared<const Robustness>(std::move(**outcome));
        tried_ = function;
        Q_EMIT finished();
      });
}

}  // namespace surefoot

#include "moc_robustness_run.cpp"
