// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/tile_coder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/basics/random.h"

namespace surefoot {

namespace {

StateVariable variable(const char* key, double low, double high, double resolution) {
  return {.key = key, .title = key, .low = low, .high = high, .span = 1.0, .spanText = "1", .resolution = resolution};
}

Task tiledTask(std::vector<StateVariable> state, int actions = 2) {
  Task task;
  task.state = std::move(state);
  task.actions.assign(static_cast<std::size_t>(actions), 0.0);
  return task;
}

TileCoder coderFor(const Task& task, int tilings) {
  TileCoder::Settings settings(task);
  settings.tilings = tilings;
  Result<TileCoder> coder = TileCoder::create(task, settings);
  EXPECT_TRUE(coder) << coder.error().message;
  return *coder;
}

std::vector<Index> active(const TileCoder& coder, std::vector<double> state) {
  TileCoder::Active x;
  coder.find(state, x);
  return {x.indices().begin(), x.indices().end()};
}

}  // namespace

// Thesis, Figure 4.2: 10 states, 3 tilings, tiles 3 states wide. By the formula floor((x + i)/3) the tiles with state 5
// hold the states 3–5, 5–7 and 4–6, so an update of state 5 by 1 reaches the states 3 … 7 as 1/3, 2/3, 1, 2/3, 1/3.
TEST(TileCoder, SpreadsAnUpdateAsInFigure42) {
  const Task task = tiledTask({variable("state", 0, 9, 1.0 / 3)});
  const TileCoder coder = coderFor(task, 3);
  const auto updated = active(coder, {5});
  const std::vector<double> expected = {0, 0, 0, 1, 2, 3, 2, 1, 0, 0};
  for (int s = 0; s < 10; ++s) {
    int shared = 0;
    const auto x = active(coder, {static_cast<double>(s)});
    for (std::size_t i = 0; i < 3; ++i) shared += x[i] == updated[i];
    EXPECT_EQ(shared, expected[static_cast<std::size_t>(s)]) << "state " << s;
  }
}

// By hand, 4 tilings of 2 × 2 tiles over [0, 1)², width 0.5: steps of width/4 = 0.125. State (0.3, 0.9) is step (2, 7).
// Tiling i is displaced by (i, 3i): (2 + i)/4 = 0, 0, 1, 1 and (7 + 3i)/4 = 1, 2, 3, 4.
// The state (0.3 + 0.125, 0.9) is step (3, 7), (3 + i)/4 = 0, 1, 1, 1: it shares the tilings 0, 2 and 3.
TEST(TileCoder, DisplacesByOddNumbers) {
  const Task task = tiledTask({variable("x", 0, 1, 2), variable("y", 0, 1, 2)});
  const TileCoder coder = coderFor(task, 4);
  const auto a = active(coder, {0.3, 0.9});
  const auto b = active(coder, {0.425, 0.9});
  // Numbers: 3 × 3 tiles a tiling (one more than cover the range, for the displacement), the tiling fastest, then x:
  // 4·(tx + 3·ty) + i, with the displacement mod 4, ty = (7 + 3i mod 4)/4 = 1, 2, 2, 2.
  EXPECT_EQ(a, (std::vector<Index>{4 * 3 + 0, 4 * 6 + 1, 4 * 7 + 2, 4 * 7 + 3}));
  EXPECT_EQ(a[0], b[0]);
  EXPECT_NE(a[1], b[1]);
  EXPECT_EQ(a[2], b[2]);
  EXPECT_EQ(a[3], b[3]);
}

// Two states share the tile of tiling i exactly if Sutton's formula gives them the same tile in every dimension.
TEST(TileCoder, PartitionsTheSpaceAsTheFormulaSays) {
  const Task task = tiledTask({variable("x", -2, 2, 1.7), variable("y", -3, 1, 0.8), variable("z", 0, 5, 2.9)});
  for (const int n : {1, 3, 8, 16}) {
    const TileCoder coder = coderFor(task, n);
    Random random(17);
    const auto draw = [&] {
      return std::vector<double>{random.uniform(-2, 2), random.uniform(-3, 1), random.uniform(0, 5)};
    };
    const auto formula = [&](const std::vector<double>& s, int i) {
      std::vector<double> tile;
      for (std::size_t d = 0; d < s.size(); ++d)
        tile.push_back(
            std::floor((std::floor(s[d] * task.state[d].resolution * n) + i * (2.0 * static_cast<double>(d) + 1)) / n));
      return tile;
    };
    int shared = 0;
    for (int trial = 0; trial < 3000; ++trial) {
      const auto s = draw();
      auto t = draw();
      if (trial % 2)
        for (std::size_t d = 0; d < 3; ++d) t[d] = s[d] + random.uniform(-0.2, 0.2);
      for (std::size_t d = 0; d < 3; ++d) t[d] = std::clamp(t[d], task.state[d].low, task.state[d].high);
      const auto x = active(coder, s), y = active(coder, t);
      for (int i = 0; i < n; ++i) {
        const bool same = formula(s, i) == formula(t, i);
        shared += same;
        ASSERT_EQ(x[static_cast<std::size_t>(i)] == y[static_cast<std::size_t>(i)], same)
            << n << " tilings, tiling " << i;
      }
    }
    EXPECT_GT(shared, 100 * n / 2);
  }
}

TEST(TileCoder, EveryTilingHasItsOwnNumbers) {
  const Task task = tiledTask({variable("x", -1, 1, 3), variable("y", -1, 1, 3)});
  const TileCoder coder = coderFor(task, 8);
  Random random(3);
  std::vector<std::set<Index>> seen(8);
  for (int trial = 0; trial < 5000; ++trial) {
    const auto x = active(coder, {random.uniform(-1, 1), random.uniform(-1, 1)});
    for (std::size_t i = 0; i < 8; ++i) {
      ASSERT_LT(x[i], coder.size());
      seen[i].insert(x[i]);
    }
  }
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (const Index tile : seen[i]) EXPECT_FALSE(seen[j].contains(tile));
}

TEST(TileCoder, AWrappingVariableIsTheSameAfterOnePeriod) {
  StateVariable angle = variable("angle", 0, 1, 5);
  angle.period = 1.0;
  const Task task = tiledTask({angle, variable("y", 0, 1, 2)});
  const TileCoder coder = coderFor(task, 8);
  for (const double a : {0.01, 0.13, 0.5, 0.77, 0.99}) {
    EXPECT_EQ(active(coder, {a, 0.4}), active(coder, {a + 1.0, 0.4}));
    EXPECT_EQ(active(coder, {a, 0.4}), active(coder, {a - 3.0, 0.4}));
  }
  // Neighbours across the seam share tiles.
  const auto left = active(coder, {0.999, 0.4}), right = active(coder, {0.001, 0.4});
  int shared = 0;
  for (std::size_t i = 0; i < 8; ++i) shared += left[i] == right[i];
  EXPECT_EQ(shared, 7);
}

TEST(TileCoder, AWrappingVariableNeedsAWholeNumberOfTiles) {
  StateVariable angle = variable("angle", 0, 1, 2.5);
  angle.period = 1.0;
  const Task task = tiledTask({angle});
  EXPECT_FALSE(TileCoder::create(task, TileCoder::Settings(task)));
}

TEST(TileCoder, StatesOutsideUseTheEdgeAndSaySo) {
  const Task task = tiledTask({variable("x", -1, 1, 4)});
  const TileCoder coder = coderFor(task, 8);
  TileCoder::Active x;
  EXPECT_EQ(coder.find(std::vector<double>{1.0}, x), Cover::Inside);
  for (const double beyond : {1.2, 1e300, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(coder.find(std::vector<double>{beyond}, x), Cover::Edge);
    EXPECT_EQ(active(coder, {beyond}), active(coder, {1.0}));
  }
  EXPECT_EQ(coder.find(std::vector<double>{std::nan("")}, x), Cover::Edge);
}

TEST(TileCoder, ATableBeyondTheLimitIsRefusedWithItsSize) {
  const Task task = tiledTask({variable("x", 0, 1, 1000), variable("y", 0, 1, 1000), variable("z", 0, 1, 1000)});
  const auto coder = TileCoder::create(task, TileCoder::Settings(task));
  ASSERT_FALSE(coder);
  EXPECT_NE(coder.error().message.find("features.z"), std::string::npos) << coder.error().message;
}

// Thesis, eq. 6.7 and section 6.2: 12 tiles × 16 tilings tell 192 positions per span apart.
TEST(TileCoder, EffectiveResolutionIsTilesTimesTilings) {
  const Task task = tiledTask({variable("x", 0, 1, 12)});
  const TileCoder coder = coderFor(task, 16);
  std::set<std::vector<Index>> distinct;
  for (int i = 0; i < 19200; ++i) distinct.insert(active(coder, {(i + 0.5) / 19200}));
  EXPECT_EQ(distinct.size(), 192u);
}

// Thesis, section 6.5: a fine representation that covers only part of the states.
TEST(TileCoder, OutsideItsBoxNoTileIsOn) {
  const Task task = tiledTask({variable("x", -1, 1, 10), variable("y", -1, 1, 10)});
  TileCoder::Settings settings(task);
  settings.from[0] = -0.2;
  settings.to[0] = 0.3;
  const auto coder = TileCoder::create(task, settings);
  ASSERT_TRUE(coder);
  TileCoder::Active x;
  EXPECT_EQ(coder->find(std::vector<double>{0.3, 0.9}, x), Cover::Inside);
  EXPECT_EQ(x.count, 16);
  EXPECT_EQ(coder->find(std::vector<double>{0.1, 1.9}, x), Cover::Edge) << "the other variable has no box";
  for (const double outside : {-0.21, 0.31, 5.0, std::nan("")}) {
    EXPECT_EQ(coder->find(std::vector<double>{outside, 0.0}, x), Cover::Nothing);
    EXPECT_EQ(x.count, 0);
  }
  EXPECT_LT(coder->size(), coderFor(task, 16).size() / 2) << "and the table is smaller";
  settings.to[0] = -0.2;
  EXPECT_FALSE(TileCoder::create(task, settings));
}

}  // namespace surefoot
