// SPDX-License-Identifier: GPL-3.0-or-later
// Between our doubles and Box2D's single precision.
#pragma once

#include <box2d/box2d.h>

namespace surefoot::robot_units {

inline float single(double x) {
  return static_cast<float>(x);
}
inline double full(float x) {
  return static_cast<double>(x);
}

}  // namespace surefoot::robot_units
