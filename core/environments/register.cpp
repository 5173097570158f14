// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/register.h"

#include "core/environments/chain.h"
#include "core/environments/cliff.h"
#include "core/environments/grid_world.h"
#include "core/environments/mountain_car.h"
#include "core/environments/random_walk.h"

namespace surefoot {

namespace {

template <class E>
void add(Registry& r, const char* name, const char* title, const char* help) {
  r.environments.push_back({{name, title, help}, [] { return std::make_unique<E>(); }});
}

}  // namespace

void registerEnvironments(Registry& r) {
  add<Cliff>(r, "cliff", "Cliff", "Sutton & Barto's cliff walking, a grid of 4 × 12.");
  add<GridWorld>(r, "grid-world", "Grid world", "A grid of 10 × 10 with a bad region in the middle.");
  add<Chain>(r, "chain", "Chain", "Ten states in a row between a fall and the goal.");
  add<RandomWalk>(r, "random-walk", "Random walk", "Sutton & Barto's 19 states with one action: values only.");
  add<MountainCar>(r, "mountain-car", "Mountain car", "Sutton & Barto's car that is too weak for the slope.");
}

}  // namespace surefoot
