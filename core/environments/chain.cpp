// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/chain.h"

#include <cmath>

namespace surefoot {

namespace {
struct ChainTerms {
  enum Term { Goal, Fall };
};
constexpr double kChainReward = 100.0;
}  // namespace

Chain::Chain() {
  task_.state = {cellVariable("state", 1, kStates)};
  task_.state[0].resolution = 1.0 / 3.0;  // tiles three states wide
  task_.actions = {-1, 1};
  task_.actionNames = {"left", "right"};
  task_.actionTitle = "move";
  task_.rewardTerms = {"goal", "fall"};
  task_.goalReward = kChainReward;
  task_.lowestReturn = -kChainReward;
  task_.highestReturn = kChainReward;
}

void Chain::reset(Random& random) {
  state_[0] = std::floor(random.uniform(2, kStates));
  limit_.steps = 0;
}

Outcome Chain::step(Action action) {
  state_[0] += task_.actions[static_cast<std::size_t>(action)];
  Outcome outcome;
  if (state_[0] == 1) {
    outcome.reward = outcome.terms[ChainTerms::Fall] = -kChainReward;
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Fall;
  } else if (state_[0] == kStates) {
    outcome.reward = outcome.terms[ChainTerms::Goal] = kChainReward;
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Success;
  }
  limit_.count(outcome);
  return outcome;
}

void Chain::draw(std::span<const double> pose, Scene& scene) const {
  Corridor{.first = 1, .last = kStates}.draw(scene, pose[0], "fall", "goal");
}

}  // namespace surefoot
