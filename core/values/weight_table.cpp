// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/values/weight_table.h"

namespace surefoot {

/// Sums kColumns columns at once; the sums stay in registers. Additions have the same order as for a single column.
/// Inlined, so that a number of columns that the compiler knows saves a multiplication a row.
template <std::size_t kColumns>
[[gnu::always_inline]] inline void WeightTable::sumColumns(std::span<const Index> rows, std::size_t columns,
                                                           std::size_t first, double* q) const {
  Weight total[kColumns];
  for (const Index row : rows) {
    const Weight* weights = &weights_[row * columns + first];
    for (std::size_t a = 0; a < kColumns; ++a) {
      total[a].v += weights[a].v;
      total[a].e += weights[a].e;
    }
  }
  for (std::size_t a = 0; a < kColumns; ++a) q[first + a] = total[a].v + sum_ * total[a].e;
}

void WeightTable::sumRows(std::span<const Index> rows, std::size_t actions, double* q) const {
  if (actions == 5) return sumColumns<5>(rows, 5, 0, q);  // a width that the compiler knows: the pendulum's
  if (actions == 3) return sumColumns<3>(rows, 3, 0, q);  // mountain car's
  constexpr std::size_t kBlock = 6;
  std::size_t a = 0;
  for (; a + kBlock <= actions; a += kBlock) sumColumns<kBlock>(rows, actions, a, q);
  switch (actions - a) {
    case 1:
      return sumColumns<1>(rows, actions, a, q);
    case 2:
      return sumColumns<2>(rows, actions, a, q);
    case 3:
      return sumColumns<3>(rows, actions, a, q);
    case 4:
      return sumColumns<4>(rows, actions, a, q);
    case 5:
      return sumColumns<5>(rows, actions, a, q);
    default:
      return;
  }
}

}  // namespace surefoot
