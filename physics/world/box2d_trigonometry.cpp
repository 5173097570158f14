// SPDX-License-Identifier: GPL-3.0-or-later
// Box2D turns bodies by sinf and cosf. These definitions stand in the executable, where the dynamic linker finds them
// before those of the C library, like box2d_clock.cpp, and for the same reason in an OBJECT library.
#include "physics/world/single_trigonometry.h"

namespace surefoot {

#ifdef __x86_64__
[[gnu::target("fma")]] float singleSineFused(float x, int quarters) {
  return singleSineOfAny(x, quarters);
}
#else
float singleSineFused(float x, int quarters) {
  return singleSineOfAny(x, quarters);
}
#endif

float singleSineAnywhere(float x, int quarters) {
  return singleSineOfAny(x, quarters);
}

namespace {

#ifdef __x86_64__
const bool kHasFused = __builtin_cpu_supports("fma");  // before it is known: false, which gives the same bits
#else
constexpr bool kHasFused = false;
#endif

}  // namespace

bool hasFusedMultiplyAdd() {
  return kHasFused;
}

}  // namespace surefoot

extern "C" float sinf(float x) noexcept {
  return surefoot::kHasFused ? surefoot::singleSineFused(x, 0) : surefoot::singleSineAnywhere(x, 0);
}
extern "C" float cosf(float x) noexcept {
  return surefoot::kHasFused ? surefoot::singleSineFused(x, 1) : surefoot::singleSineAnywhere(x, 1);
}
