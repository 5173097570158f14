// SPDX-License-Identifier: GPL-3.0-or-later
// How robust is what was learned? Every cell of a plan's grid (a Q-function, a model, a push) is tried as often as the
// plan says (trial.h), on many threads; the same numbers for any number of threads.
#pragma once

#include <atomic>
#include <functional>

#include "core/robustness/robustness_plan.h"
#include "core/statistics/wilson.h"

namespace surefoot {

/// How the trials of a cell ended; those that are in none of the counts held out.
struct Tally {
  std::int64_t trials = 0, falls = 0, successes = 0, flewApart = 0;

  Interval fallen() const { return wilsonInterval(falls, trials); }
  Interval succeeded() const { return wilsonInterval(successes, trials); }
};

struct Robustness {
  RobustnessPlan plan;
  std::vector<Tally> tallies;  ///< [function][model][push]

  const Tally& at(std::size_t function, std::size_t model, std::size_t push) const {
    return tallies[(function * plan.models.size() + model) * plan.pushes.size() + push];
  }
  /// Whether the 95 % intervals of two functions' falls have nothing in common.
  bool differ(std::size_t model, std::size_t push) const;
};

/// `functions` as for the plan. `progress`: the share that is done, about four times a second, on the calling thread.
/// An error: an environment did not answer, or `interrupted` was set (ErrorKind::Interrupted).
Result<Robustness> tryOut(const Registry& registry, const RobustnessPlan& plan,
                          const std::vector<const TriedFunction*>& functions, int jobs,
                          const std::atomic<bool>* interrupted, const std::function<void(double)>& progress = {});

}  // namespace surefoot
