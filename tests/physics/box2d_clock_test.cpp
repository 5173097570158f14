// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "physics/pendulum/pendulum_world.h"

namespace surefoot {

// With Box2D's own clock the largest of 10^4 steps takes a few microseconds at least.
TEST(Box2dClock, IsOff) {
  PendulumWorld world{PendulumSettings{}};
  world.place(0.1, 0, 0);
  float longest = 0.0f;
  for (int i = 0; i < 10'000; ++i) {
    world.step(0.0);
    longest = std::max(longest, world.profiledStep());
  }
  EXPECT_EQ(longest, 0.0f);
}

}  // namespace surefoot
