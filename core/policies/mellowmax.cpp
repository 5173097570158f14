// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/policies/mellowmax.h"

#include <algorithm>

#include "core/basics/portable_math.h"

namespace surefoot {

namespace {

/// π(a) ← exp(β (q(a) − best)); returns their sum.
double powers(std::span<const double> q, double best, double beta, std::span<double> pi) {
  double sum = 0.0;
  for (std::size_t a = 0; a < q.size(); ++a) sum += pi[a] = portableExp(beta * (q[a] - best));
  return sum;
}

}  // namespace

void Mellowmax::among(std::span<const double> q, std::span<double> pi) const {
  const double best = *std::max_element(q.begin(), q.end()), n = static_cast<double>(q.size());
  if (*std::min_element(q.begin(), q.end()) == best) return std::fill(pi.begin(), pi.end(), 1.0 / n);
  const double omega = settings_.omega.now();
  const double below = portableLog(powers(q, best, omega, pi) / n) / omega;  // mm − best
  /// Whether the expected value under β is above mm.
  const auto above = [&](double beta) {
    powers(q, best, beta, pi);
    double sum = 0.0;
    for (std::size_t a = 0; a < q.size(); ++a) sum += pi[a] * (q[a] - best - below);
    return sum > 0;
  };
  double low = 0.0, high = omega;
  constexpr int kMostDoublings = 64, kMostHalvings = 64;
  for (int i = 0; i < kMostDoublings && !above(high); ++i) low = high, high *= 2.0;
  for (int i = 0; i < kMostHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (above(middle) ? high : low) = middle;
  }
  const double sum = powers(q, best, low, pi);
  for (double& p : pi) p /= sum;
}

}  // namespace surefoot
