// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/values/weight_table.h"

namespace surefoot {

/// For a fixed number of actions the sums stay in registers. The order of additions is that of the general case.
template <std::size_t kActions>
void WeightTable::sumOver(std::span<const Index> rows, double* q) const {
  Weight total[kActions];
  for (const Index row : rows) {
    const Weight* weights = &weights_[row * kActions];
    for (std::size_t a = 0; a < kActions; ++a) {
      total[a].v += weights[a].v;
      total[a].e += weights[a].e;
    }
  }
  for (std::size_t a = 0; a < kActions; ++a) q[a] = total[a].v + sum_ * total[a].e;
}

void WeightTable::sumRows(std::span<const Index> rows, std::size_t actions, double* q) const {
  switch (actions) {
    case 1:
      return sumOver<1>(rows, q);
    case 2:
      return sumOver<2>(rows, q);
    case 3:
      return sumOver<3>(rows, q);
    case 4:
      return sumOver<4>(rows, q);
    case 5:
      return sumOver<5>(rows, q);
    default:
      break;
  }
  for (std::size_t a = 0; a < actions; ++a) q[a] = sum(rows, static_cast<Index>(actions), static_cast<Index>(a));
}

}  // namespace surefoot
