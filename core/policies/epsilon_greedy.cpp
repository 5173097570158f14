// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/policies/epsilon_greedy.h"

#include "core/policy.h"

namespace surefoot {

void EpsilonGreedy::among(std::span<const double> q, std::span<double> pi) const {
  const double epsilon = exploration_.epsilon.now();
  shareAmongGreedy(q, 1.0 - epsilon, pi);
  const double each = epsilon / static_cast<double>(q.size());
  for (double& p : pi) p += each;
}

}  // namespace surefoot
