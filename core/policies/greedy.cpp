// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/policies/greedy.h"

#include <algorithm>

namespace surefoot {

void shareAmongGreedy(std::span<const double> q, double share, std::span<double> pi) {
  double best = q[0];
  for (const double value : q) best = std::max(best, value);
  int ties = 0;
  for (const double value : q) ties += value == best;
  const double each = share / ties;
  for (std::size_t a = 0; a < q.size(); ++a) pi[a] = q[a] == best ? each : 0.0;
}

}  // namespace surefoot
