// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/robustness/robustness.h"

#include <algorithm>
#include <mutex>

#include "core/experiment/work_pool.h"
#include "core/robustness/trial.h"

namespace surefoot {

namespace {

/// Trials of one model that are made in a row, by one thread, in one environment. All Q-functions and pushes come with
/// them, so that little time goes into making environments.
constexpr std::int64_t kInARow = 10;

class Trying {
 public:
  Trying(const Registry& registry, const std::vector<const TriedFunction*>& functions, Robustness& result)
      : registry_(registry),
        functions_(functions),
        result_(result),
        rows_((plan().starts + kInARow - 1) / kInARow) {
    result_.tallies.resize(plan().cells());
  }

  std::int64_t pieces() const { return static_cast<std::int64_t>(plan().models.size()) * rows_; }
  double share() const {
    return static_cast<double>(done_.load()) /
           (static_cast<double>(plan().cells()) * static_cast<double>(plan().starts));
  }

  Status piece(std::int64_t i, const std::atomic<bool>* interrupted) {
    const auto model = static_cast<std::size_t>(i / rows_);
    const std::int64_t first = i % rows_ * kInARow, last = std::min(first + kInARow, plan().starts);
    const auto environment = makeEnvironment(registry_, plan().modelled(plan().models[model]));
    if (!environment) return environment.error();
    for (std::size_t f = 0; f < functions_.size(); ++f) {
      const auto policy = makePolicy(registry_, plan().policy, plan().policies[f]);
      if (!policy) return policy.error();
      (*policy)->advance({});
      for (std::size_t p = 0; p < plan().pushes.size(); ++p) {
        Tally tally;
        for (std::int64_t start = first; start < last; ++start) {
          const auto end = tryOnce(**environment, functions_[f]->values(), **policy, trialOf(start, p), interrupted);
          if (!end) return end.error();
          ++tally.trials;
          tally.falls += *end == TrialEnd::Fell;
          tally.successes += *end == TrialEnd::Succeeded;
          tally.flewApart += *end == TrialEnd::FlewApart;
          ++done_;
        }
        add(tally, (f * plan().models.size() + model) * plan().pushes.size() + p);
      }
    }
    return Done{};
  }

 private:
  const RobustnessPlan& plan() const { return result_.plan; }
  Trial trialOf(std::int64_t start, std::size_t push) const {
    return {.seed = plan().seed,
            .number = static_cast<std::uint64_t>(start),
            .earliest = plan().earliest,
            .latest = plan().latest,
            .after = plan().after,
            .impulse = plan().pushes[push]};
  }
  void add(const Tally& more, std::size_t cell) {
    const std::lock_guard lock(mutex_);
    Tally& all = result_.tallies[cell];
    all.trials += more.trials;
    all.falls += more.falls;
    all.successes += more.successes;
    all.flewApart += more.flewApart;
  }

  const Registry& registry_;
  const std::vector<const TriedFunction*>& functions_;
  Robustness& result_;
  const std::int64_t rows_;
  std::mutex mutex_;  // guards the tallies
  std::atomic<std::int64_t> done_{0};
};

}  // namespace

bool Robustness::differ(std::size_t model, std::size_t push) const {
  if (plan.functions.size() < 2) return false;
  const Interval a = at(0, model, push).fallen(), b = at(1, model, push).fallen();
  return a.high < b.low || b.high < a.low;
}

Result<Robustness> tryOut(const Registry& registry, const RobustnessPlan& plan,
                          const std::vector<const TriedFunction*>& functions, int jobs,
                          const std::atomic<bool>* interrupted, const std::function<void(double)>& progress) {
  Robustness result{plan, {}};
  Trying trying(registry, functions, result);
  WorkPool pool(jobs, interrupted);
  const auto tick = [&] {
    if (progress) progress(trying.share());
  };
  const Status tried = pool.run(
      trying.pieces(), [&](std::int64_t i) { return trying.piece(i, interrupted); }, tick);
  if (!tried) return tried.error();
  if (interrupted && *interrupted) return Error{"interrupted; nothing is written.", ErrorKind::Interrupted};
  return result;
}

}  // namespace surefoot
