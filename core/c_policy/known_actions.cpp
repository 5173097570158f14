// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/c_policy/known_actions.h"

#include <algorithm>
#include <cmath>

#include "core/basics/random.h"

namespace surefoot {

namespace {

std::vector<double> anyState(const Task& task, Random& random) {
  std::vector<double> state;
  for (const StateVariable& v : task.state) {
    const double at = random.uniform(v.low, v.high);
    state.push_back(v.whole ? std::round(at) : at);
  }
  return state;
}

}  // namespace

std::vector<KnownAction> knownActions(const ActionValueFunction& values, const Task& task) {
  constexpr int kWanted = 1000, kMostTries = 100'000;
  constexpr double kClear = 1e-4;  // of the largest value
  std::vector<KnownAction> known;
  Random random(1);
  std::vector<double> q(task.actions.size());
  for (int i = 0; i < kMostTries && known.size() < kWanted; ++i) {
    std::vector<double> state = anyState(task, random);
    values.evaluate(state, Layer::Sum, q);
    const auto best = std::max_element(q.begin(), q.end());
    double second = -kInfinity, largest = 0.0;
    for (auto value = q.begin(); value != q.end(); ++value) {
      if (value != best) second = std::max(second, *value);
      largest = std::max(largest, std::abs(*value));
    }
    if (*best - second > kClear * largest) known.push_back({std::move(state), static_cast<int>(best - q.begin())});
  }
  return known;
}

}  // namespace surefoot
