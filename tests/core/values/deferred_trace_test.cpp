// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/values/deferred_trace.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/basics/random.h"
#include "core/values/eligibility_trace.h"

namespace surefoot {

namespace {

constexpr std::size_t kWeights = 4000;

/// Both kinds of trace on tables of their own, given the same stream of marks and errors.
struct Both {
  WeightTable deferredTable{kWeights}, plainTable{kWeights};
  DeferredTrace deferred;
  EligibilityTrace plain;

  void step(double factor, double cutoff, const std::vector<Index>& marks, double alphaDelta) {
    deferred.decay(deferredTable, factor, cutoff);
    plain.decay(plainTable, factor, cutoff);
    for (const Index k : marks) deferred.replace(deferredTable, k), plain.replace(plainTable, k);
    deferred.add(deferredTable, alphaDelta);
    plain.add(plainTable, alphaDelta);
  }
  void clear() {
    deferred.clear(deferredTable);
    plain.clear(plainTable);
  }
  double largestDifference() const {
    double most = 0.0;
    for (std::size_t k = 0; k < kWeights; ++k) most = std::max(most, std::abs(deferredTable[k] - plainTable[k]));
    return most;
  }
};

/// Marks that wander, as the tiles of a state do.
std::vector<Index> wander(std::int64_t step, Random& random) {
  std::vector<Index> marks;
  const double centre = 2000 + 1500 * std::sin(static_cast<double>(step) * 0.01);
  for (int i = 0; i < 16; ++i) marks.push_back(static_cast<Index>(centre + 20 * i + random.uniform(0, 8)));
  return marks;
}

}  // namespace

// By hand, factor .5: marked, +1; then decay and +1: w = 1 + .5; marked again, +1: w = 2.5, z = 1.
TEST(DeferredTrace, FollowsAHandComputedCourse) {
  WeightTable table(3);
  DeferredTrace trace;
  trace.decay(table, 0.5, 0.0);
  trace.replace(table, 1);
  trace.add(table, 1.0);
  EXPECT_DOUBLE_EQ(table[1], 1.0);
  trace.decay(table, 0.5, 0.0);
  trace.add(table, 1.0);
  EXPECT_DOUBLE_EQ(table[1], 1.5);
  EXPECT_DOUBLE_EQ(trace.at(table, 1), 0.5);
  trace.replace(table, 1);
  trace.add(table, 1.0);
  EXPECT_DOUBLE_EQ(table[1], 2.5);
  trace.drop(table, 1);
  trace.add(table, 1.0);
  EXPECT_DOUBLE_EQ(table[1], 2.5);
  EXPECT_EQ(table[0], 0.0);
}

// A recorded stream of 10^6 steps (marks, errors of the size that the pendulum has, ends of episodes): every weight the
// same to 10^-9, for short and long traces and whatever the cut-off.
TEST(DeferredTrace, EqualsThePlainTraceOnAMillionSteps) {
  for (const auto& [factor, cutoff, steps] :
       {std::tuple{0.9016, 0.01, 1'000'000}, std::tuple{0.98 * 0.98, 0.01, 200'000}, std::tuple{0.5, 0.25, 200'000},
        std::tuple{0.9016, 0.0, 30'000}, std::tuple{0.0, 0.01, 100'000}, std::tuple{1.0, 0.0, 20'000}}) {
    Both both;
    Random random(3);
    for (int step = 0; step < steps; ++step) {
      const double error = random.uniform(-20, 20) * (step % 50 == 0 ? 10 : 1);
      both.step(factor, cutoff, wander(step, random), 0.025 * error);
      if (step % 70 == 69) both.clear();
      if (step % 9973 != 0) continue;
      ASSERT_LT(both.largestDifference(), 1e-9) << factor << " at " << step;
    }
    EXPECT_LT(both.largestDifference(), 1e-9) << factor << ", " << cutoff;
  }
}

// λ, γ and the cut-off may change at any time.
TEST(DeferredTrace, EqualsThePlainTraceWhenTheDecayChanges) {
  Both both;
  Random random(4);
  for (int step = 0; step < 100'000; ++step) {
    const double factor = step % 1000 < 500 ? 0.95 : 0.6, cutoff = step % 3000 < 1500 ? 0.01 : 0.2;
    both.step(factor, cutoff, wander(step, random), random.uniform(-1, 1));
    if (random.next() % 300 == 0) both.clear();
  }
  EXPECT_LT(both.largestDifference(), 1e-9);
}

TEST(DeferredTrace, DroppedTracesAreAsIfTheyHadNeverBeen) {
  Both both;
  Random random(5);
  for (int step = 0; step < 20'000; ++step) {
    both.step(0.9, 0.01, wander(step, random), random.uniform(-1, 1));
    const auto k = static_cast<Index>(random.next() % kWeights);
    both.deferred.drop(both.deferredTable, k);
    both.plain.drop(both.plainTable, k);
  }
  EXPECT_LT(both.largestDifference(), 1e-9);
}

TEST(DeferredTrace, WithoutDecayItsMemoryStaysBounded) {
  WeightTable table(100);
  DeferredTrace trace;
  for (int step = 0; step < 200'000; ++step) {
    trace.decay(table, 1.0, 0.01);
    trace.replace(table, static_cast<Index>(step % 100));
    trace.add(table, 0.5);
  }
  TensorFile file;
  Archive archive = Archive::writer(file);
  trace.transfer(table, archive);
  EXPECT_LE(file.find("weights")->count(), 8192u);
  EXPECT_NEAR(table[99], 0.5 * (200'000 - 99), 1e-6);
}

}  // namespace surefoot
