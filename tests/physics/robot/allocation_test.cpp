// SPDX-License-Identifier: GPL-3.0-or-later
// A step of a walker takes no memory from the heap. Counted in malloc, which Box2D uses, too.
#include <atomic>
#include <cstdlib>

#include "tests/physics/robot/robot_files.h"

#ifndef __SANITIZE_ADDRESS__

namespace {
std::atomic<std::int64_t> taken = 0;
}

extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) {
  taken.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}

namespace surefoot {

namespace {

/// Of so many steps of random actions; resets are not counted.
std::int64_t takenInSteps(Environment& environment, Random& random, int steps) {
  const auto actions = static_cast<double>(environment.task().actions.size());
  std::int64_t sum = 0;
  environment.reset(random);
  for (int step = 0; step < steps; ++step) {
    const std::int64_t before = taken;
    const Outcome outcome = environment.step(static_cast<Action>(random.uniform() * actions));
    sum += taken - before;
    if (outcome.ending != Ending::None) environment.reset(random);
  }
  return sum;
}

}  // namespace

// A world's first contacts take blocks of 16 kB; those of the worlds before are kept.
TEST(Allocations, AStepTakesNoMemory) {
  constexpr int kSteps = 4000;
  Registry registry = fullRegistry();
  for (const char* name :
       {"acrobot", "ball-beam", "biped", "cart-pole", "compass", "hopper", "leo", "pendulum", "segway"})
    if (auto spec = robotOf(robotText(name))) addRobot(registry, robotEntry(fileOf(name) + " of a file", spec));
  for (const EnvironmentEntry& entry : registry.environments) {
    const auto environment = entry.make();
    Random random(1);
    takenInSteps(*environment, random, kSteps);
    EXPECT_EQ(takenInSteps(*environment, random, kSteps), 0) << entry.name;
  }
}

}  // namespace surefoot

#endif
