// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/q_pool.h"

#include <new>

#include "core/saved/q_file.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

QPool::QPool(const Registry& registry, QObject* parent) : QObject(parent), registry_(registry) {
  connect(&background_, &Background::busyChanged, this, &QPool::changed);
  connect(&background_, &Background::failed, this, &QPool::refused);
}

namespace {

Result<PreLearned> preLearn(const Registry& registry, const Configuration& simulation, int index,
                            const std::atomic<bool>& interrupted) {
  try {
    auto life = makeLife(registry, simulation, index, false);
    if (!life) return life.error();
    while (!(*life)->finished() && !interrupted) (*life)->step();
    if (!(*life)->unanswered().empty()) return Error{(*life)->unanswered()};
    if ((*life)->diverged()) return Error{(*life)->divergence()};
    PreLearned one{.file = std::make_shared<const TensorFile>(qFileOf(**life, simulation))};
    one.episodes = (*life)->log().totals().episodes;
    one.falls = (*life)->log().totals().falls;
    one.averageReward = (*life)->log().averageReward();
    one.reached = !simulation.until || one.averageReward >= *simulation.until;
    return one;
  } catch (const std::bad_alloc&) {
    return Error{QObject::tr("There is not enough memory for this; take fewer tiles or tilings.").toStdString()};
  }
}

}  // namespace

void QPool::start(Configuration simulation, int pool) {
  simulation.names.policy = "epsilon-greedy";
  for (const char* caution : {"policy.risk", "policy.guardian"})  // a lesson is bold
    static_cast<void>(static_cast<bool>(simulation.parameters.set(caution, 0.0)));
  if (simulation.until) simulation.episodes = kCap;
  simulation.start.reset();
  simulation.beganWith = {};
  simulation.commands.clear();
  pool_.clear();
  asked_ = pool;
  const std::uint64_t run = ++run_;
  background_.start(
      [this, run, pool, simulation, &registry = registry_](const std::atomic<bool>& interrupted) {
        for (int i = 0; i < pool && !interrupted; ++i) {
          auto one = preLearn(registry, simulation, i, interrupted);
          if (interrupted) return;
          calls_.post([this, run, one] {
            if (one)
              take(*one, run);
            else if (run == run_)
              Q_EMIT refused(toText(one.error().message));
          });
        }
      },
      [] {});
  Q_EMIT changed();
}

void QPool::take(const PreLearned& one, std::uint64_t run) {
  if (run != run_) return;
  pool_.push_back(one);
  Q_EMIT changed();
}

}  // namespace surefoot

#include "moc_q_pool.cpp"
