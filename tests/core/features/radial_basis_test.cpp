// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/radial_basis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/basics/random.h"

namespace surefoot {

namespace {

StateVariable variable(double low, double high, double resolution) {
  return {.key = "x", .title = "x", .low = low, .high = high, .span = 1, .spanText = "1", .resolution = resolution};
}

Task gaussianTask(std::vector<StateVariable> state) {
  Task task;
  task.state = std::move(state);
  task.actions = {0, 1};
  return task;
}

RadialBasis mapFor(const Task& task, const std::vector<double>& width) {
  RadialBasis::Settings settings(task);
  settings.width = width;
  auto map = RadialBasis::create(task, settings);
  EXPECT_TRUE(map) << map.error().message;
  return *map;
}

}  // namespace

// By hand: centres at 0, 1 … 10, σ = 1, s = 5.25. The block is the 7 centres 2 … 8 around the nearest one, 5.
TEST(RadialBasis, IsANormalisedGaussianOfEveryCentreNear) {
  const RadialBasis map = mapFor(gaussianTask({variable(0, 10, 1)}), {1.0});
  ASSERT_EQ(map.size(), 11u);
  RadialBasis::Active x;
  EXPECT_EQ(map.find(std::vector<double>{5.25}, x), Cover::Inside);
  ASSERT_EQ(x.count, 7);
  double sum = 0.0;
  for (int c = 2; c <= 8; ++c) sum += std::exp(-0.5 * (5.25 - c) * (5.25 - c));
  for (std::size_t k = 0; k < 7; ++k) {
    const double c = 2.0 + static_cast<double>(k);
    EXPECT_EQ(x.index[k], static_cast<Index>(c));
    EXPECT_NEAR(x.value[k], std::exp(-0.5 * (5.25 - c) * (5.25 - c)) / sum, 1e-14);
  }
}

TEST(RadialBasis, SumsToOneInAnyNumberOfDimensions) {
  const Task task = gaussianTask({variable(-1, 1, 4), variable(0, 3, 2), variable(-5, 5, 1)});
  const RadialBasis map = mapFor(task, {0.1, 0.5, 1.0});
  Random random(9);
  for (int trial = 0; trial < 500; ++trial) {
    RadialBasis::Active x;
    map.find(std::vector<double>{random.uniform(-1.5, 1.5), random.uniform(0, 3), random.uniform(-5, 5)}, x);
    std::set<Index> distinct(x.indices().begin(), x.indices().end());
    ASSERT_EQ(distinct.size(), static_cast<std::size_t>(x.count));
    ASSERT_LT(*distinct.rbegin(), map.size());
    double sum = 0.0;
    for (std::size_t k = 0; k < distinct.size(); ++k) sum += x.value[k];
    ASSERT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST(RadialBasis, TheFactorMultipliesEveryWidth) {
  const Task task = gaussianTask({variable(0, 10, 1), variable(0, 4, 2)});
  RadialBasis::Settings settings(task);
  settings.width = {0.5, 0.25};
  settings.widthScale = 2;
  const auto twice = RadialBasis::create(task, settings);
  ASSERT_TRUE(twice) << twice.error().message;
  const RadialBasis wide = mapFor(task, {1.0, 0.5});
  RadialBasis::Active a, b;
  const std::vector<double> state{5.25, 1.1};
  twice->find(state, a);
  wide.find(state, b);
  ASSERT_EQ(a.count, b.count);
  for (std::size_t k = 0; k < static_cast<std::size_t>(a.count); ++k) EXPECT_EQ(a.value[k], b.value[k]);
}

// What tile coding cannot do (thesis, section 6.5): the same centres with a wide or a narrow reach.
TEST(RadialBasis, WidthAndSpacingAreSetApart) {
  const Task task = gaussianTask({variable(0, 10, 1)});
  const RadialBasis narrow = mapFor(task, {0.3}), wide = mapFor(task, {3.0});
  EXPECT_EQ(narrow.size(), wide.size());
  const auto share = [](const RadialBasis& map) {  // how much of an update at 5 reaches the state 6
    RadialBasis::Active five, six;
    map.find(std::vector<double>{5.0}, five);
    map.find(std::vector<double>{6.0}, six);
    double dot = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(five.count); ++i)
      for (std::size_t k = 0; k < static_cast<std::size_t>(six.count); ++k)
        if (five.index[i] == six.index[k]) dot += five.value[i] * six.value[k];
    return dot;
  };
  EXPECT_LT(share(narrow), 0.02);
  EXPECT_GT(share(wide) / share(narrow), 4.0);
}

TEST(RadialBasis, WrapsAroundWhereTheVariableDoes) {
  StateVariable angle = variable(0, 1, 8);
  angle.period = 1.0;
  const RadialBasis map = mapFor(gaussianTask({angle}), {0.1});
  EXPECT_EQ(map.size(), 8u);
  RadialBasis::Active a, b;
  map.find(std::vector<double>{0.99}, a);
  map.find(std::vector<double>{-0.01}, b);
  ASSERT_EQ(a.count, b.count);
  for (std::size_t k = 0; k < static_cast<std::size_t>(a.count); ++k) {
    EXPECT_EQ(a.index[k], b.index[k]);
    EXPECT_NEAR(a.value[k], b.value[k], 1e-12);
  }
  angle.resolution = 2.5;
  const Task odd = gaussianTask({angle});
  EXPECT_FALSE(RadialBasis::create(odd, RadialBasis::Settings(odd)));
}

TEST(RadialBasis, AVeryNarrowGaussianTakesTheNearestCentre) {
  const RadialBasis map = mapFor(gaussianTask({variable(0, 10, 1)}), {0.001});
  RadialBasis::Active x;
  map.find(std::vector<double>{4.4}, x);
  double best = 0.0;
  Index nearest = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(x.count); ++k)
    if (x.value[k] > best) best = x.value[k], nearest = x.index[k];
  EXPECT_EQ(best, 1.0);
  EXPECT_EQ(nearest, 4u);
}

TEST(RadialBasis, TooManyAtOnceAreRefused) {
  const Task task = gaussianTask({variable(0, 10, 100), variable(0, 10, 100)});
  RadialBasis::Settings settings(task);
  settings.width = {5.0, 5.0};
  const auto map = RadialBasis::create(task, settings);
  ASSERT_FALSE(map);
  EXPECT_NE(map.error().message.find("_width"), std::string::npos) << map.error().message;
}

}  // namespace surefoot
