// SPDX-License-Identifier: GPL-3.0-or-later
// Falls that are taken back: after a fall that ends its episode the world goes back N steps (to the beginning, if there
// were fewer), and the episode goes on from there with other actions, at most so many times an episode. The learner
// learns the fall as always, and for it another episode begins there. Ours, for pre-learning in simulation: no real
// robot goes back in time.
//
// A fall that was taken back is counted as a rewind and not as a fall; its steps and its reward were lived and are in
// the episode's row. The task's measures and its time limit are of the course that stands in the end.
#pragma once

#include "core/parameters.h"

namespace surefoot {

class Environment;

struct Rewinding final : Configurable {
  static constexpr int kMost = 1'000'000;
  int steps = 0;  ///< N; 0: no fall is taken back
  int most = 3;   ///< times an episode

  /// Whether the fall of an episode that was rewound so often is taken back.
  bool takesBack(int rewinds) const { return steps > 0 && rewinds < most; }
  void declare(Fields& f) override;
};

/// Whether the environment can go back, if the parameters ask for it: one that answers at once can, a robot that a
/// program moves cannot.
Status checkRewinding(const Parameters& parameters, const Environment& environment);

}  // namespace surefoot
