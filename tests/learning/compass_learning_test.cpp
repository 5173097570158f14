// SPDX-License-Identifier: GPL-3.0-or-later
// The compass walker learns to walk: labelled slow.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/experiment/experiment.h"
#include "physics/compass/compass.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

namespace {

/// Whether the greedy policy walks the whole 20 s from a state.
bool walks(const ActionValueFunction& values, const std::vector<double>& from) {
  Compass compass;
  compass.place(from);
  std::vector<double> q(3);
  for (;;) {
    values.evaluate(compass.state(), Layer::Sum, q);
    const Outcome o = compass.step(static_cast<Action>(std::max_element(q.begin(), q.end()) - q.begin()));
    if (o.ending != Ending::None) return o.ending == Ending::Truncated;
  }
}

bool walksFromEverywhere(const ActionValueFunction& values) {
  const std::vector<std::vector<double>> starts = {{0.20, -1.4, -0.20, 0.0},      {0.176, -1.23, -0.22, 0.11},
                                                   {0.224, -1.55, -0.185, -0.07}, {0.21, -1.29, -0.226, 0.02},
                                                   {0.185, -1.58, -0.172, 0.14},  {0.229, -1.45, -0.205, -0.13}};
  return std::all_of(starts.begin(), starts.end(), [&](const auto& start) { return walks(values, start); });
}

/// Simulated minutes after which it walks from everywhere, looked at after every episode; none within the limit.
std::optional<double> minutesToWalk(const Configuration& c, const Registry& registry, int life, double most) {
  auto made = makeLife(registry, c, life, false);
  Life& l = **made;
  std::int64_t seen = 0;
  while (l.simulatedSeconds() < most * 60) {
    l.step();
    if (l.log().totals().episodes == seen) continue;
    seen = l.log().totals().episodes;
    if (walksFromEverywhere(l.agent().values())) return l.simulatedSeconds() / 60;
  }
  return std::nullopt;
}

}  // namespace

TEST(CompassLearning, WalksFromNominalAndNoisyStartsWithinTenSimulatedMinutes) {
  const Registry registry = fullRegistry();
  Names names;
  names.environment = "compass";
  int walking = 0;
  for (int seed = 1; seed <= 10; ++seed) {
    auto c = configure(registry, names, {});
    c->seed = static_cast<std::uint64_t>(seed);
    const auto minutes = minutesToWalk(*c, registry, 0, 10.0);
    std::printf("seed %d: %s\n", seed, minutes ? std::to_string(*minutes).c_str() : "not within ten minutes");
    walking += minutes.has_value();
  }
  EXPECT_GE(walking, 9);
}

}  // namespace surefoot
