// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/library/own_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/policy.h"

namespace surefoot {

namespace {

class OwnWorld final : public Environment {
 public:
  OwnWorld(surefoot_world world, Task task) : world_(world), task_(std::move(task)), state_(task_.state.size()) {
    for (std::size_t d = 0; d < state_.size(); ++d) state_[d] = task_.state[d].low;
  }

  void declare(Fields&) override {}
  const Task& task() const override { return task_; }
  std::span<const double> state() const override { return state_; }
  std::string unanswered() const override { return why_; }
  bool answersAtOnce() const override { return false; }  // so its functions are called by the thread that runs the life

  void reset(Random& random) override {
    Random drawn = random;
    const std::uint64_t seed = drawn.next();
    next_ = state_;
    why_ = world_.reset(world_.user, seed, next_.data()) == 0 ? check(next_) : "The caller's world could not begin.";
    if (!why_.empty()) return;
    random = drawn;
    state_ = next_;
  }

  Outcome step(Action action) override {
    surefoot_outcome told{};
    std::array<double, kMaxRewardTerms> terms{};
    next_ = state_;
    const int failed = world_.step(world_.user, action, next_.data(), terms.data(), &told);
    why_ = failed == 0 ? check(next_) : "The caller's world could not take a step.";
    if (why_.empty()) why_ = check(std::span(terms).first(task_.rewardTerms.size()));
    if (!why_.empty()) return {.ending = Ending::Unanswered};
    state_ = next_;
    Outcome outcome;
    outcome.terms = terms;
    outcome.reward = std::accumulate(terms.begin(), terms.end(), 0.0);
    outcome.ending = told.terminated ? Ending::Terminal : told.truncated ? Ending::Truncated : Ending::None;
    outcome.event = told.fall ? Event::Fall : told.success ? Event::Success : Event::None;
    return outcome;
  }

  std::vector<double> pose() const override { return {}; }
  void draw(std::span<const double>, Scene& scene) const override { scene.clear(); }
  std::vector<ReadOut> readOuts(std::span<const double>) const override { return {}; }

 private:
  static std::string check(std::span<const double> numbers) {
    const bool fine = std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
    return fine ? "" : "The caller's world gave a number that is not finite.";
  }

  surefoot_world world_;
  Task task_;
  std::vector<double> state_, next_;
  std::string why_;
};

class OwnPolicy final : public Policy {
 public:
  OwnPolicy(surefoot_policy policy, std::shared_ptr<Mishap> mishap) : policy_(policy), mishap_(std::move(mishap)) {}

 private:
  void declareRule(Fields&) override {}
  /// Where the caller's function fails, all actions are equally probable, and the life is stopped after this step.
  void among(std::span<const double> q, std::span<double> pi) const override {
    const auto wrong = [](double p) { return !(std::isfinite(p) && p >= 0); };
    double sum = 0;
    if (policy_.probabilities(policy_.user, q.data(), q.size(), pi.data()) == 0 &&
        std::none_of(pi.begin(), pi.end(), wrong))
      sum = std::accumulate(pi.begin(), pi.end(), 0.0);
    if (!(sum > 0 && std::isfinite(sum))) {
      mishap_->ofPolicy = true;
      std::fill(pi.begin(), pi.end(), 1.0);
      sum = static_cast<double>(pi.size());
    }
    for (double& p : pi) p /= sum;
  }

  surefoot_policy policy_;
  std::shared_ptr<Mishap> mishap_;
};

}  // namespace

Status addOwnParts(Registry& registry, const surefoot_world* world, const surefoot_policy* policy,
                   const std::shared_ptr<Mishap>& mishap) {
  if (world) {
    if (!world->reset || !world->step) return Error{"world: its functions must not be NULL."};
    const auto task = ownTask(world->task);
    if (!task) return task.error();
    EnvironmentEntry entry{{"own", "own world", "A world that the caller of the library brings along."}, {}};
    entry.make = [w = *world, t = *task] { return std::make_unique<OwnWorld>(w, t); };
    registry.environments.push_back(std::move(entry));
  }
  if (policy) {
    if (!policy->probabilities) return Error{"policy: its function must not be NULL."};
    PolicyEntry entry{{"own", "own policy", "A policy that the caller of the library brings along."}, {}};
    entry.make = [p = *policy, mishap] { return std::make_unique<OwnPolicy>(p, mishap); };
    registry.policies.push_back(std::move(entry));
  }
  return Done{};
}

}  // namespace surefoot
