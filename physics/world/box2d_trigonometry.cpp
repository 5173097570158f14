// SPDX-License-Identifier: GPL-3.0-or-later
// Box2D turns bodies by sinf, cosf and sincosf. These definitions stand in the executable, where the dynamic linker
// finds them before those of the C library, like box2d_clock.cpp, and for the same reason in an OBJECT library.
#include "physics/world/single_trigonometry.h"

#ifdef __x86_64__
#define SUREFOOT_FUSED [[gnu::target("fma")]]
#else
#define SUREFOOT_FUSED
#endif

namespace surefoot {

SUREFOOT_FUSED void sineAndCosineFused(float x, float* sine, float* cosine) {
  sineAndCosineOf(x, *sine, *cosine);
}

void sineAndCosineAnywhere(float x, float* sine, float* cosine) {
  sineAndCosineOf(x, *sine, *cosine);
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

extern "C" void sincosf(float x, float* sine, float* cosine) noexcept {
  if (surefoot::kHasFused) return surefoot::sineAndCosineFused(x, sine, cosine);
  surefoot::sineAndCosineAnywhere(x, sine, cosine);
}
extern "C" float sinf(float x) noexcept {
  float sine, cosine;
  sincosf(x, &sine, &cosine);
  return sine;
}
extern "C" float cosf(float x) noexcept {
  float sine, cosine;
  sincosf(x, &sine, &cosine);
  return cosine;
}
