// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/random_walk.h"

namespace surefoot {

namespace {
struct WalkTerms {
  enum Term { Right, Left };
};
}  // namespace

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
  state_[0] = (1 + kStates) / 2;
  limit_.steps = 0;
  way_ = Random(random.next());
}

Outcome RandomWalk::step(Action) {
  state_[0] += way_.uniform() < 0.5 ? -1 : 1;
  Outcome outcome;
  if (state_[0] < 1) {
    outcome.reward = outcome.terms[WalkTerms::Left] = -1;
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Fall;
  } else if (state_[0] > kStates) {
    outcome.reward = outcome.terms[WalkTerms::Right] = 1;
    outcome.ending = Ending::Terminal;
    outcome.event = Event::Success;
  }
  limit_.count(outcome);
  return outcome;
}

void RandomWalk::draw(std::span<const double> pose, Scene& scene) const {
  Corridor{.first = 1, .last = kStates, .endsOutside = true}.draw(scene, pose[0], "−1", "+1");
}

}  // namespace surefoot
