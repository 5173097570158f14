// SPDX-License-Identifier: GPL-3.0-or-later
// All inputs of an environment in one episode. An environment that gets the same inputs again goes through the
// same states, whatever its physics engine holds inside: so an episode is a few hundred bytes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/environment.h"

namespace surefoot {

struct EpisodeInputs {
  std::array<std::uint64_t, 4> random{};  ///< the world's generator before reset()
  std::vector<double> start;              ///< the state it was placed in; empty: the state after reset()
  std::vector<std::uint16_t> actions;
  std::vector<std::uint8_t> explored{};  ///< 1: the action was not the best by q̂; as long as `actions`, or not known
  std::vector<std::uint64_t> pushSteps;  ///< steps of the episode before each push
  std::vector<double> pushImpulses;      ///< [N s]
  std::uint64_t before = 0;              ///< steps of it that were not lived by this life, which went on from there

  /// Negative actions (kHandMade) are stored at the upper end of the numbers.
  Action actionAt(std::size_t step) const { return static_cast<std::int16_t>(actions[step]); }
  void clear() {
    start.clear();
    actions.clear();
    pushSteps.clear();
    pushImpulses.clear();
    explored.clear();
    before = 0;
  }
  /// Back to the state in which the action after the first `steps` was chosen: pushes in that state are undone, too.
  void keepFirst(std::size_t steps) {
    if (explored.size() == actions.size())
      explored.resize(steps);
    else
      explored.clear();  // not known of all
    actions.resize(steps);
    const auto kept = std::lower_bound(pushSteps.begin(), pushSteps.end(), steps) - pushSteps.begin();
    pushSteps.resize(static_cast<std::size_t>(kept));
    pushImpulses.resize(static_cast<std::size_t>(kept));
  }
};

/// Takes an environment through an episode again; `visit` is called in every state on the way, with what the step
/// before it brought and the action that comes next (kNoAction in the last). `random` is left as the reset left it;
/// `ending` is how the last step ended. False: it ended before the inputs did.
template <class Visit>
bool repeat(const EpisodeInputs& inputs, Environment& environment, Random& random, Ending& ending, const Visit& visit) {
  random = Random(inputs.random);
  environment.reset(random);
  ending = environment.unanswered().empty() ? Ending::None : Ending::Unanswered;
  if (ending == Ending::Unanswered) return false;
  if (!inputs.start.empty()) environment.place(inputs.start);
  Outcome outcome;
  std::size_t push = 0;
  for (std::size_t step = 0;; ++step) {
    for (; push < inputs.pushSteps.size() && inputs.pushSteps[push] == step; ++push)
      environment.push(inputs.pushImpulses[push]);
    const bool over = step == inputs.actions.size();
    if (!over && ending != Ending::None) return false;
    visit(outcome, over ? kNoAction : inputs.actionAt(step));
    if (over) return true;
    outcome = environment.step(inputs.actionAt(step));
    ending = outcome.ending;
  }
}

}  // namespace surefoot
