// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/values/weight_table.h"

namespace surefoot {

namespace {

/// For a fixed number of actions the sums stay in registers. The order of additions is that of the general case.
template <std::size_t kActions>
void sumOver(std::span<const Index> rows, const double* v, const double* e, double d, double* q) {
  double sv[kActions] = {}, se[kActions] = {};
  for (const Index row : rows)
    for (std::size_t a = 0; a < kActions; ++a) {
      sv[a] += v[row * kActions + a];
      se[a] += e[row * kActions + a];
    }
  for (std::size_t a = 0; a < kActions; ++a) q[a] = sv[a] + d * se[a];
}

}  // namespace

void WeightTable::sumRows(std::span<const Index> rows, std::size_t actions, double* q) const {
  switch (actions) {
    case 1:
      return sumOver<1>(rows, v_.data(), e_.data(), sum_, q);
    case 2:
      return sumOver<2>(rows, v_.data(), e_.data(), sum_, q);
    case 3:
      return sumOver<3>(rows, v_.data(), e_.data(), sum_, q);
    case 4:
      return sumOver<4>(rows, v_.data(), e_.data(), sum_, q);
    case 5:
      return sumOver<5>(rows, v_.data(), e_.data(), sum_, q);
    default:
      break;
  }
  for (std::size_t a = 0; a < actions; ++a) {
    double sv = 0.0, se = 0.0;
    for (const Index row : rows) sv += v_[row * actions + a], se += e_[row * actions + a];
    q[a] = sv + sum_ * se;
  }
}

}  // namespace surefoot
