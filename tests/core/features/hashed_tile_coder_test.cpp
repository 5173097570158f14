// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/hashed_tile_coder.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "core/basics/random.h"
#include "core/features/tile_coder.h"

namespace surefoot {

namespace {

Task taskOf(int dimensions, double resolution) {
  Task task;
  for (int d = 0; d < dimensions; ++d)
    task.state.push_back({.key = "x", .title = "x", .low = -1, .high = 1, .span = 1, .resolution = resolution});
  task.actions = {0, 1};
  return task;
}

HashedTileCoder coderWith(const Task& task, int memory) {
  TileSettings settings(task);
  settings.memory = memory;
  auto coder = HashedTileCoder::create(task, settings);
  EXPECT_TRUE(coder) << coder.error().message;
  return *coder;
}

std::vector<double> randomState(const Task& task, Random& random) {
  std::vector<double> s;
  for (std::size_t d = 0; d < task.state.size(); ++d) s.push_back(random.uniform(-1, 1));
  return s;
}

}  // namespace

// With room for every tile the hashed coder is the dense one under other numbers: a bijection of features.
TEST(HashedTileCoder, WithEnoughMemoryItTellsTheSameTilesApart) {
  const Task task = taskOf(2, 4);
  const auto dense = TileCoder::create(task, TileSettings(task));
  ASSERT_TRUE(dense);
  HashedTileCoder hashed = coderWith(task, static_cast<int>(4 * dense->size()));
  std::map<Index, Index> slotOf, tileOf;
  Random random(3);
  for (int trial = 0; trial < 20'000; ++trial) {
    const auto s = randomState(task, random);
    TileCoder::Active x;
    HashedTileCoder::Active y;
    dense->find(s, x);
    hashed.claim(s, y);
    ASSERT_EQ(x.count, y.count);
    for (std::size_t i = 0; i < 16; ++i) {
      ASSERT_EQ(slotOf.try_emplace(x.index[i], y.index[i]).first->second, y.index[i]);
      ASSERT_EQ(tileOf.try_emplace(y.index[i], x.index[i]).first->second, x.index[i]);
    }
  }
  EXPECT_EQ(hashed.occupied(), slotOf.size());
  EXPECT_EQ(hashed.failedLookUps(), 0);
}

TEST(HashedTileCoder, LookingClaimsNothingAndFindsWhatClaimingWouldGive) {
  const Task task = taskOf(3, 8);
  HashedTileCoder coder = coderWith(task, 100'000);
  Random random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const auto s = randomState(task, random);
    HashedTileCoder::Active seen, claimed;
    const Index before = coder.occupied();
    coder.find(s, seen);
    EXPECT_EQ(coder.occupied(), before);
    coder.claim(s, claimed);
    EXPECT_TRUE(std::ranges::equal(seen.indices(), claimed.indices()));
    coder.find(s, seen);
    EXPECT_TRUE(std::ranges::equal(seen.indices(), claimed.indices())) << "and afterwards it stays";
  }
}

TEST(HashedTileCoder, FeaturesAreNumberedAsTheyAreClaimedAndMadeAgainFromTheirTiles) {
  const Task task = taskOf(3, 8);
  HashedTileCoder coder = coderWith(task, 3000), again = coderWith(task, 3000);
  Random random(6);
  HashedTileCoder::Active x, y;
  for (int trial = 0; trial < 150; ++trial) {
    const Index before = coder.occupied();
    coder.claim(randomState(task, random), x);
    for (const Index i : x.indices()) EXPECT_LT(i, before + 16);
  }
  ASSERT_EQ(coder.tiles().size(), coder.occupied());
  ASSERT_TRUE(again.setTiles(coder.tiles()));
  for (int trial = 0; trial < 100; ++trial) {
    const auto s = randomState(task, random);
    coder.find(s, x);
    again.find(s, y);
    EXPECT_TRUE(std::ranges::equal(x.indices(), y.indices()));
  }
  const std::vector<std::uint64_t> twice = {7, 8, 7};
  EXPECT_FALSE(again.setTiles(twice));
}

// 10 dimensions of 8 tiles a unit: 16^10 tiles and more in a table of 5,000.
TEST(HashedTileCoder, AFullTableSharesSlotsAndCountsIt) {
  const Task task = taskOf(10, 8);
  HashedTileCoder coder = coderWith(task, 5000);
  Random random(5);
  HashedTileCoder::Active x;
  for (int trial = 0; trial < 2000; ++trial) {
    coder.claim(randomState(task, random), x);
    for (const Index slot : x.indices()) ASSERT_LT(slot, 5000u);
  }
  EXPECT_EQ(coder.occupied(), 5000u);
  EXPECT_GT(coder.failedLookUps(), 20'000);
}

TEST(HashedTileCoder, LookingForAFreeSlotGoesOnAtTheFrontOfTheTable) {
  constexpr int kSlots = 50;  // fewer than are looked at
  static_assert(kSlots < HashedTileCoder::kMostProbes);
  HashedTileCoder coder = coderWith(taskOf(2, 4), kSlots);
  std::vector<std::uint64_t> tiles(kSlots);
  std::iota(tiles.begin(), tiles.end(), 1u);
  const Status s = coder.setTiles(tiles);
  EXPECT_TRUE(s) << s.error().message;
  EXPECT_EQ(coder.occupied(), 50u);
}

TEST(HashedTileCoder, TooMuchMemoryIsRefusedWithTheNumber) {
  const Task task = taskOf(2, 4);
  TileSettings settings(task);
  settings.memory = 1 << 27;
  const auto coder = HashedTileCoder::create(task, settings);
  ASSERT_FALSE(coder);
  EXPECT_NE(coder.error().message.find("134217728"), std::string::npos) << coder.error().message;
}

}  // namespace surefoot
