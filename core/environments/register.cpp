// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environments/register.h"

#include "core/environments/cliff.h"
#include "core/environments/mountain_car.h"

namespace surefoot {

void registerEnvironments(Registry& r) {
  r.environments.push_back({{"cliff", "Cliff", "Sutton & Barto's cliff walking, a grid of 4 × 12."},
                            [] { return std::make_unique<Cliff>(); }});
  r.environments.push_back({{"mountain-car", "Mountain car", "Sutton & Barto's car that is too weak for the slope."},
                            [] { return std::make_unique<MountainCar>(); }});
}

}  // namespace surefoot
