// SPDX-License-Identifier: GPL-3.0-or-later
#include <box2d/box2d.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/basics/random.h"
#include "physics/world/single_trigonometry.h"

namespace surefoot {

namespace {

std::string fileOf(const void* address) {
  Dl_info info{};
  return dladdr(address, &info) != 0 && info.dli_fname ? info.dli_fname : "";
}

/// In units of the last place.
double offBy(float value, double exact) {
  const auto full = static_cast<double>(value);
  return std::abs(full - exact) / std::abs(static_cast<double>(std::nextafter(value, 2.0f)) - full);
}

}  // namespace

TEST(Box2dTrigonometry, IsOurs) {
  for (const char* name : {"sinf", "cosf", "sincosf"}) {
    const void* found = dlsym(RTLD_DEFAULT, name);
    ASSERT_TRUE(found);
    EXPECT_EQ(fileOf(found), fileOf(reinterpret_cast<const void*>(&fileOf))) << name;
  }
}

TEST(Box2dTrigonometry, HasTheSameBitsWithAndWithoutFusedMultiplyAdd) {
  Random random(3);
  for (int i = 0; i < 1'000'000; ++i) {
    const auto x = static_cast<float>(random.uniform(-130, 130) * std::pow(random.uniform(), 8));
    float sine = 0, cosine = 0, fusedSine = 0, fusedCosine = 0;
    sineAndCosineAnywhere(x, &sine, &cosine);
    sincosf(x, &fusedSine, &fusedCosine);
    ASSERT_EQ(fusedSine, sine) << x;
    ASSERT_EQ(fusedCosine, cosine) << x;
    ASSERT_LE(offBy(sine, std::sin(static_cast<double>(x))), 0.57) << x;
    ASSERT_LE(offBy(cosine, std::cos(static_cast<double>(x))), 0.57) << x;
  }
}

TEST(Box2dTrigonometry, KnowsTheEndsOfItsRange) {
  EXPECT_EQ(sinf(0.0f), 0.0f);
  EXPECT_TRUE(std::signbit(sinf(-0.0f)));
  EXPECT_EQ(cosf(0.0f), 1.0f);
  EXPECT_NEAR(sinf(1e5f), std::sin(1e5), 1e-7);
  EXPECT_NEAR(cosf(-12345.678f), std::cos(static_cast<double>(-12345.678f)), 1e-7);
  for (const float x : {INFINITY, -INFINITY, NAN}) EXPECT_TRUE(std::isnan(sinf(x)) && std::isnan(cosf(x)));
}

}  // namespace surefoot
