// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/policies/softmax.h"

#include <algorithm>

#include "core/basics/portable_math.h"

namespace surefoot {

void Softmax::among(std::span<const double> q, std::span<double> pi) const {
  double best = q[0];
  for (const double value : q) best = std::max(best, value);
  const double temperature = settings_.temperature.now();
  double sum = 0.0;
  for (std::size_t a = 0; a < q.size(); ++a) {
    pi[a] = portableExp((q[a] - best) / temperature);
    sum += pi[a];
  }
  for (double& p : pi) p /= sum;
}

}  // namespace surefoot
