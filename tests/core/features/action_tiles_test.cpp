// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/action_tiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/basics/random.h"
#include "core/features/hashed_tile_coder.h"
#include "core/values/estimate.h"

namespace surefoot {

namespace {

/// A state variable and two action variables with `levels` levels from −1 to 1.
Task taskWith(int levels, double resolution) {
  Task task;
  task.state = {{.key = "x", .title = "x", .low = -1, .high = 1, .span = 1, .resolution = 4}};
  for (const char* key : {"u", "v"}) {
    ActionVariable variable{.key = key, .title = key, .symbol = key, .unit = "V", .resolution = resolution};
    for (int i = 0; i < levels; ++i) variable.levels.push_back(-1 + 2.0 * i / (levels - 1));
    task.actionVariables.push_back(variable);
  }
  for (int a = 0; a < levels * levels; ++a) task.actions.push_back(a);
  return task;
}

TileSettings settingsOf(const Task& task, int tilings) {
  TileSettings settings(task);
  settings.tilings = tilings;
  settings.memory = 4096;
  return settings;
}

/// The plain definition: the tile of an action variable in tiling i of n, d its place behind the state variables.
int plainTile(double value, double low, double resolution, int n, int i, int d) {
  return static_cast<int>(std::floor((std::floor((value - low) * resolution * n + 1e-9) + i * (2 * d + 1) % n) / n));
}

}  // namespace

TEST(ActionTiles, TwoActionsShareAColumnExactlyWhereTheyShareATile) {
  const Task task = taskWith(5, 1.3);
  const int n = 8;
  const auto tiles = ActionTiles::create(task, settingsOf(task, n));
  ASSERT_TRUE(tiles) << tiles.error().message;
  for (int i = 0; i < n; ++i)
    for (int a = 0; a < 25; ++a)
      for (int b = 0; b < 25; ++b) {
        bool same = true;
        for (int j = 0; j < 2; ++j) {
          const auto& levels = task.actionVariables[static_cast<std::size_t>(j)].levels;
          const auto of = [&](int action) {
            return levels[static_cast<std::size_t>(j == 0 ? action / 5 : action % 5)];
          };
          same &= plainTile(of(a), -1, 1.3, n, i, 1 + j) == plainTile(of(b), -1, 1.3, n, i, 1 + j);
        }
        EXPECT_EQ(tiles->column(static_cast<std::size_t>(i), a) == tiles->column(static_cast<std::size_t>(i), b), same);
      }
}

TEST(ActionTiles, OrdinaryActionsHaveAColumnEach) {
  Task task = taskWith(3, 1);
  task.actionVariables.clear();
  const auto tiles = ActionTiles::create(task, settingsOf(task, 4));
  ASSERT_TRUE(tiles);
  EXPECT_FALSE(tiles->shared());
  EXPECT_EQ(tiles->count(), 9u);
  EXPECT_EQ(tiles->column(3, 7), 7u);
}

// All action values at once, by blocks, against one after the other over the plain tiles.
class ManyActions : public testing::TestWithParam<int> {};
TEST_P(ManyActions, LearningIsThatOfThePlainSlowEvaluation) {
  const Task task = taskWith(5, 1.3);
  const int n = GetParam();
  const TileSettings settings = settingsOf(task, n);
  auto coder = HashedTileCoder::create(task, settings);
  ASSERT_TRUE(coder) << coder.error().message;
  Estimate<HashedTileCoder> estimate(LinearActionValue<HashedTileCoder>(*coder, 25, InitialValue{0, 0}, 1),
                                     EstimateSettings{Scheduled{0.3}, 0.8});
  std::map<std::tuple<int, int, int, int>, double> weight, trace;  // tiling, state's tile, the action's tiles
  const auto key = [&](double x, int a, int i) {
    const auto& u = task.actionVariables[0].levels;
    const double low = -1;
    return std::tuple{i, plainTile(x, low, 4, n, i, 0),
                      plainTile(u[static_cast<std::size_t>(a / 5)], low, 1.3, n, i, 1),
                      plainTile(u[static_cast<std::size_t>(a % 5)], low, 1.3, n, i, 2)};
  };
  const auto slow = [&](double x, int a) {
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += weight[key(x, a, i)];
    return sum;
  };
  Random random(3);
  std::vector<double> q(25);
  double x = random.uniform(-1, 1);
  estimate.arrive(std::vector{x}, q);
  estimate.go();
  for (int step = 0; step < 2000; ++step) {
    const int a = static_cast<int>(random.uniform(0, 25));
    const double reward = random.uniform(-1, 1), next = random.uniform(-1, 1);
    const double delta = reward + 0.9 * slow(next, a) - slow(x, a);
    estimate.arrive(std::vector{next}, q);
    for (int b = 0; b < 25; ++b) ASSERT_NEAR(q[static_cast<std::size_t>(b)], slow(next, b), 1e-9) << step;
    estimate.learn(a, reward, 0.9 * q[static_cast<std::size_t>(a)], 0.9, {});
    for (auto& [k, z] : trace) z = z * 0.9 * 0.8 < 0.01 ? 0 : z * 0.9 * 0.8;
    for (int i = 0; i < n; ++i) trace[key(x, a, i)] = 1;
    for (const auto& [k, z] : trace) weight[k] += 0.3 / n * delta * z;
    estimate.go();
    x = next;
  }
  EXPECT_EQ(estimate.values().features().failedLookUps(), 0);
}
INSTANTIATE_TEST_SUITE_P(Tilings, ManyActions, testing::Values(8, 6));  // blocks are taken four at a time, or singly

}  // namespace surefoot
