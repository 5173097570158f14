// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/basics/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace surefoot {

// The reference output of xoshiro256++ for the state {1, 2, 3, 4}: from the authors' C code (prng.di.unimi.it), as also
// printed in the test of the Rust crate rand_xoshiro.
TEST(Random, IsXoshiro256PlusPlus) {
  Random random(std::array<std::uint64_t, 4>{1, 2, 3, 4});
  for (const std::uint64_t expected : {41943041ULL, 58720359ULL, 3588806011781223ULL, 3591011842654386ULL,
                                       9228616714210784205ULL, 9973669472204895162ULL, 14011001112246962877ULL,
                                       12406186145184390807ULL, 15849039046786891736ULL, 10450023813501588000ULL})
    EXPECT_EQ(random.next(), expected);
}

// The published sequence of SplitMix64 for the seed 1234567.
TEST(Random, SeedsBySplitMix64) {
  std::uint64_t state = 1234567;
  for (const std::uint64_t expected : {6457827717110365317ULL, 3203168211198807973ULL, 9817491932198370423ULL,
                                       4593380528125082431ULL, 16408922859458223821ULL})
    EXPECT_EQ(splitMix64(state), expected);
}

TEST(Random, UniformHasMeanOneHalfAndStaysBelowOne) {
  Random random(7);
  double sum = 0.0;
  constexpr int kDraws = 100'000;
  for (int i = 0; i < kDraws; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 5 * 0.2887 / std::sqrt(kDraws));  // five standard errors
}

TEST(Random, EveryStreamOfEveryLifeHasItsOwnSeed) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t master = 0; master < 10; ++master)
    for (std::uint64_t life = 0; life < 100; ++life)
      for (const Stream stream : {Stream::World, Stream::Policy, Stream::Weights, Stream::Viewer})
        seeds.insert(deriveSeed(master, life, stream));
  EXPECT_EQ(seeds.size(), 10u * 100u * 4u);
}

TEST(Random, NumberAtAnIndexDependsOnSeedAndIndexOnly) {
  EXPECT_EQ(uniformAt(3, 1000), uniformAt(3, 1000));
  EXPECT_NE(uniformAt(3, 1000), uniformAt(3, 1001));
  EXPECT_NE(uniformAt(3, 1000), uniformAt(4, 1000));
}

}  // namespace surefoot
