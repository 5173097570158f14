// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/policy.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace surefoot {

namespace {

using Row = std::array<double, kMaxActions>;  // not initialised: it lies on the stack of a hot call

}  // namespace

void Policy::cautious(const ActionView& view, std::span<double> pi, Rule rule) const {
  Row row;
  const std::span<double> worth(row.data(), view.q.size());
  caution_.weigh(view, worth);
  amongAllowed(view.q, worth, pi, rule);
}

/// π of the rule among the actions whose worth is finite.
void Policy::amongAllowed(std::span<const double> q, std::span<const double> worth, std::span<double> pi,
                          Rule rule) const {
  Row worthOfAllowed, share;
  const std::size_t n = worth.size();
  std::size_t allowed = 0;
  for (const double w : worth)
    if (std::isfinite(w)) worthOfAllowed[allowed++] = w;
  if (allowed == n || allowed == 0) return (this->*rule)(allowed == n ? worth : q, pi);
  (this->*rule)(std::span(worthOfAllowed.data(), allowed), std::span(share.data(), allowed));
  for (std::size_t a = 0, i = 0; a < n; ++a) pi[a] = std::isfinite(worth[a]) ? share[i++] : 0.0;
}

void Policy::amongBest(std::span<const double> q, std::span<double> pi) const {
  shareAmongGreedy(q, 1.0, pi);
}

void Policy::greedy(const ActionView& view, std::span<double> pi) const {
  if (!caution_.actsOn(view)) return amongBest(view.q, pi);
  cautious(view, pi, &Policy::amongBest);
}

Policy::Drawn Policy::drawCautiously(const ActionView& view, std::span<double> pi, Random& random) const {
  Row row;
  const std::span<double> worth(row.data(), view.q.size());
  caution_.weigh(view, worth);
  amongAllowed(view.q, worth, pi, &Policy::among);
  const Action a = sample(pi, random);
  return {a, worth[static_cast<std::size_t>(a)] < *std::max_element(worth.begin(), worth.end())};
}

void shareAmongGreedy(std::span<const double> q, double share, std::span<double> pi) {
  double best = q[0];
  for (const double value : q) best = std::max(best, value);
  int ties = 0;
  for (const double value : q) ties += value == best;
  const double each = share / ties;
  for (std::size_t a = 0; a < q.size(); ++a) pi[a] = q[a] == best ? each : 0.0;
}

}  // namespace surefoot
