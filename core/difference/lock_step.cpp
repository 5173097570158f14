// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/difference/lock_step.h"

#include <fmt/format.h>

#include "core/life/life_measures.h"

namespace surefoot {

namespace {

class LockStep {
 public:
  LockStep(Life& first, Life& second) : a_(first), b_(second) {}

  Result<std::optional<Parting>> live(std::int64_t steps, const std::atomic<bool>* interrupted) {
    for (Life* life : {&a_, &b_}) life->keepInputs(), life->begin();
    if (const Status s = answered(); !s) return s.error();
    if (auto parting = taskOrState()) return parting;
    while (a_.steps() < steps) {
      if (interrupted && *interrupted)
        return Error{fmt::format("interrupted at step {} of {}; up to there they are the same.", a_.steps(), steps),
                     ErrorKind::Interrupted};
      if (a_.finished() || b_.finished()) break;
      before_ = a_.steps();
      a_.step(), b_.step();
      if (const Status s = answered(); !s) return s.error();
      if (auto parting = whatWasDone()) return parting;
      if (a_.steps() == before_) break;  // nothing is left to do
    }
    before_ = a_.steps();
    if (a_.finished() != b_.finished() && a_.steps() < steps) return part("the life", endOf(a_), endOf(b_));
    if (a_.hash() != b_.hash())
      return part("what was learned (hash)", fmt::format("{:016x}", a_.hash()), fmt::format("{:016x}", b_.hash()));
    return std::optional<Parting>();
  }

 private:
  using Maybe = std::optional<Parting>;

  Status answered() const {
    for (const Life* life : {&a_, &b_})
      if (!life->unanswered().empty()) return Error{life->unanswered(), ErrorKind::Unanswered};
    return Done{};
  }
  Maybe part(const std::string& what, std::string first, std::string second) const {
    Parting parting;
    parting.what = what, parting.first = std::move(first), parting.second = std::move(second);
    parting.step = before_, parting.episode = episode_;
    return parting;
  }
  template <class T>
  Maybe compare(const std::string& what, const T& first, const T& second) const {
    return first == second ? Maybe() : part(what, fmt::format("{}", first), fmt::format("{}", second));
  }
  static std::string endOf(const Life& life) {
    return life.diverged() ? "ends: " + life.divergence() : life.finished() ? "ends" : "goes on";
  }

  /// The beginning: what there is to be compared, and the first state.
  Maybe taskOrState() const {
    const Task &x = a_.environment().task(), &y = b_.environment().task();
    const auto keysOf = [](const Task& task) {
      std::string keys;
      for (const StateVariable& v : task.state) keys += (keys.empty() ? "" : ", ") + v.key;
      return keys;
    };
    if (auto parting = compare("state variables", keysOf(x), keysOf(y))) return parting;
    if (auto parting = compare("number of actions", x.actions.size(), y.actions.size())) return parting;
    return state();
  }

  Maybe state() const {
    const auto first = a_.environment().state(), second = b_.environment().state();
    for (std::size_t d = 0; d < first.size(); ++d)
      if (auto parting = compare(a_.environment().task().state[d].key, first[d], second[d])) return parting;
    return std::nullopt;
  }

  /// The action of this step; after a rewind it is not known any more.
  Maybe action() const {
    const auto &first = a_.inputs().actions, &second = b_.inputs().actions;
    if (first.empty() || second.empty() || first.size() != second.size()) return std::nullopt;
    return compare("action", textOf(a_.inputs().actionAt(first.size() - 1)),
                   textOf(b_.inputs().actionAt(second.size() - 1)));
  }
  std::string textOf(Action action) const {
    const Task& task = a_.environment().task();
    const auto at = static_cast<std::size_t>(action);
    if (action == kHandMade) return "hand-made";
    if (!task.actionNames.empty()) return task.actionNames[at];
    if (!task.actionVariables.empty()) return fmt::format("number {}", action);
    return fmt::format("{}{}{}", task.actions[at], task.actionUnit.empty() ? "" : " ", task.actionUnit);
  }

  Maybe whatWasDone() {
    const EpisodeLog &x = a_.log(), &y = b_.log();
    const bool over = x.totals().episodes >= episode_;  // the step ended its episode
    if (auto parting = action()) return parting;
    if (auto parting = state()) return parting;
    if (auto parting = compare("the episode", endText(x), endText(y))) return parting;
    const EpisodeRow &first = over ? x.last() : x.current(), &second = over ? y.last() : y.current();
    if (auto parting = compare("reward of the episode so far", first.reward, second.reward)) return parting;
    if (auto parting = compare("falls taken back", first.rewinds, second.rewinds)) return parting;
    episode_ += over;
    return std::nullopt;
  }
  std::string endText(const EpisodeLog& log) const {
    return log.totals().episodes < episode_ ? "goes on" : fmt::format("ends ({})", nameOfEnd(log.last()));
  }
  static const char* nameOfEnd(const EpisodeRow& row) {
    return row.success ? "success" : row.falls > 0 ? "fall" : row.ending == Ending::Truncated ? "cut off" : "over";
  }

  Life &a_, &b_;
  std::int64_t before_ = 0;   // steps before the one in hand
  std::int64_t episode_ = 1;  // its episode
};

}  // namespace

Result<std::optional<Parting>> partingOf(Life& first, Life& second, std::int64_t steps,
                                         const std::atomic<bool>* interrupted) {
  return LockStep(first, second).live(steps, interrupted);
}

}  // namespace surefoot
