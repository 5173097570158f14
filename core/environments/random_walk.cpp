// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/random_walk.h"

namespace surefoot {

namespace {
enum RewardTerm { kRight, kLeft };
}

RandomWalk::RandomWalk() {
  task_.state = {cellVariable("state", 1, kStates)};
  task_.actions = {0};
  task_.actionNames = {"walk"};
  task_.actionTitle = "move";
  task_.rewardTerms = {"right", "left"};
  task_.lowestReturn = -1;
  task_.highestReturn = 1;
}

void RandomWalk::reset(Random& random) {
  position_ = (1 + kStates) / 2;
  limit_.steps = 0;
  way_ = Random(random.next());
}

Outcome RandomWalk::step(Action) {
  position_ += way_.uniform() < 0.5 ? -1 : 1;
  ++limit_.steps;
  Outcome outcome;
  if (position_ < 1) {
    outcome.reward = outcome.terms[kLeft] = -1;
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Fall;
  } else if (position_ > kStates) {
    outcome.reward = outcome.terms[kRight] = 1;
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Success;
  } else if (limit_.steps >= limit_.most) {
    outcome.ending = Ending::Truncated;
  }
  return outcome;
}

void RandomWalk::draw(std::span<const double> pose, Scene& scene) const {
  Corridor{.first = 1, .last = kStates, .endsOutside = true}.draw(scene, pose[0], "−1", "+1");
}

}  // namespace surefoot
