// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/values/eligibility_trace.h"

#include <gtest/gtest.h>

#include <map>

#include "core/basics/random.h"

namespace surefoot {

TEST(EligibilityTrace, DropsEntriesBelowTheCutoff) {
  WeightTable w(10);
  EligibilityTrace trace;
  trace.replace(w, 3);
  trace.decay(w, 0.5, 0.2);  // 0.5
  trace.replace(w, 4);
  trace.decay(w, 0.5, 0.2);  // 0.25 and 0.5
  EXPECT_EQ(trace.entries().size(), 2u);
  trace.decay(w, 0.5, 0.2);  // 0.125 is dropped
  ASSERT_EQ(trace.entries().size(), 1u);
  EXPECT_EQ(trace.entries()[0].weight, 4u);
  EXPECT_DOUBLE_EQ(trace.entries()[0].z, 0.25);
}

TEST(EligibilityTrace, ReplacingSetsToOneAndAccumulatingAddsOne) {
  WeightTable w(10);
  EligibilityTrace trace;
  trace.replace(w, 1);
  trace.accumulate(w, 2);
  trace.decay(w, 0.5, 0.0);
  trace.replace(w, 1);
  trace.accumulate(w, 2);
  trace.add(w, 1.0);
  EXPECT_DOUBLE_EQ(w[1], 1.0);
  EXPECT_DOUBLE_EQ(w[2], 1.5);
}

// Against a plain vector of all weights, over a long random course.
TEST(EligibilityTrace, EqualsADenseVector) {
  constexpr std::size_t kWeights = 50;
  EligibilityTrace trace;
  const WeightTable table(kWeights);
  std::vector<double> dense(kWeights, 0.0);
  Random random(9);
  for (int step = 0; step < 20'000; ++step) {
    const auto weight = static_cast<Index>(random.next() % kWeights);
    switch (random.next() % 12) {
      case 0:
        trace.drop(table, weight);
        dense[weight] = 0;
        break;
      case 1:
        trace.accumulate(table, weight);
        dense[weight] += 1;
        break;
      case 2:
        if (random.next() % 20 == 0) {
          trace.clear(table);
          std::fill(dense.begin(), dense.end(), 0.0);
        }
        break;
      case 3:
      case 4:
      case 5:
      case 6:
        trace.replace(table, weight);
        dense[weight] = 1;
        break;
      default:
        trace.decay(table, 0.9, 0.01);
        for (double& z : dense) z = z * 0.9 < 0.01 ? 0.0 : z * 0.9;
    }
    WeightTable sparse(kWeights);
    trace.add(sparse, 1.0);
    ASSERT_EQ(sparse.settled(), dense) << "step " << step;
  }
}

}  // namespace surefoot
