// SPDX-License-Identifier: GPL-3.0-or-later
// True online Sarsa against the forward view that it equals.
#include <cmath>
#include <numeric>

#include "tests/core/agents/row_of_states.h"

namespace surefoot {

namespace {

/// The online λ-return algorithm, the forward view that true online TD(λ) equals (van Seijen et al. 2016, section 3;
/// Sutton & Barto 2018, section 12.3): at every moment h all weights are computed anew from the beginning.
struct ForwardView {
  double stepSize, discount, traceDecay;
  std::vector<std::vector<double>> x{};       ///< features of every state
  std::vector<double> rewards{};              ///< rewards[t] comes after state t
  std::vector<std::vector<double>> online{};  ///< w_h, the result at moment h

  static double dot(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  }
  /// w_h from w_0; at the end of an episode state h has no features.
  std::vector<double> weightsAt(std::size_t h) const {
    std::vector<double> w = online[0];
    for (std::size_t t = 0; t < h; ++t) {
      double target = 0.0, sum = 0.0, power = 1.0;  // G_t^{λ|h} = (1 − λ) Σ λ^(n−1) G^(n) + λ^(h−t−1) G^(h−t)
      for (std::size_t n = 1; t + n <= h; ++n) {
        sum += std::pow(discount, static_cast<double>(n - 1)) * rewards[t + n - 1];
        const double bootstrap = dot(online[t + n - 1], x[t + n]);
        const double G = sum + std::pow(discount, static_cast<double>(n)) * bootstrap;
        target += (t + n == h ? power : (1.0 - traceDecay) * power) * G;
        power *= traceDecay;
      }
      const double error = target - dot(w, x[t]);
      for (std::size_t i = 0; i < w.size(); ++i) w[i] += stepSize / dot(x[t], x[t]) * error * x[t][i];
    }
    return w;
  }
};

}  // namespace

TEST(TrueOnlineSarsa, EqualsItsForwardViewAfterEveryStep) {
  constexpr int kTilings = 4;
  RowOfStates<TrueOnlineTarget> c({0.4, 0.9, 0.8}, kTilings);
  Task task;
  task.state = {{.key = "s", .title = "s", .low = 0, .high = 9, .span = 1, .resolution = 1}};
  TileCoder::Settings tiles(task);
  tiles.tilings = kTilings;
  const TileCoder coder = *TileCoder::create(task, tiles);
  const auto features = [&](double state) {
    TileCoder::Active active;
    coder.find(std::vector<double>{state}, active);
    std::vector<double> x(coder.size(), 0.0);
    for (const Index i : active.indices()) x[i] = 1.0;
    return x;
  };
  Random random(5);
  std::vector<double> weights(coder.size(), 0.0);
  for (int episode = 0; episode < 3; ++episode) {
    ForwardView view{0.4, 0.9, 0.8};
    double s = random.uniform(0, 3);  // states that share tiles
    c.start(s);
    view.x.push_back(features(s));
    view.online.push_back(weights);
    constexpr int kSteps = 15;
    for (int step = 1; step <= kSteps; ++step) {
      s = random.uniform(0, 3);
      const double reward = random.uniform(-1, 1);
      view.rewards.push_back(reward);
      view.x.push_back(step < kSteps ? features(s) : std::vector<double>(coder.size(), 0.0));
      if (step < kSteps)
        c.step(reward, s);
      else
        c.end(reward);
      view.online.push_back(view.weightsAt(static_cast<std::size_t>(step)));
      weights = view.online.back();
      for (double state = 0.1; state < 3.0; state += 0.37)
        EXPECT_NEAR(c.q(state, 0), ForwardView::dot(weights, features(state)), 1e-10)
            << "episode " << episode << ", step " << step;
    }
  }
}

}  // namespace surefoot
