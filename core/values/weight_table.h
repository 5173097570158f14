// SPDX-License-Identifier: GPL-3.0-or-later
// Weights, some of which have updates that were put off: w_k = v_k + D·e_k, with a sum D that all of them share (see
// DeferredTrace, which keeps D and e; without one e is 0 everywhere). Whoever reads gets w.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/features/feature_map.h"

namespace surefoot {

class WeightTable {
 public:
  explicit WeightTable(std::size_t size) : weights_(size) {}

  std::size_t size() const { return weights_.size(); }
  double operator[](std::size_t k) const { return weights_[k].v + sum_ * weights_[k].e; }
  /// All of w, with nothing put off any more.
  std::vector<double> settled() const {
    std::vector<double> w(size());
    for (std::size_t k = 0; k < w.size(); ++k) w[k] = (*this)[k];
    return w;
  }
  /// w ← values, as many as there are; nothing put off.
  void assign(std::span<const double> values) {
    for (std::size_t k = 0; k < size(); ++k) weights_[k] = {values[k], 0.0};
    sum_ = 0.0;
  }
  /// w ← those of a table of the same size, nothing put off; without allocation.
  void assign(const WeightTable& other) {
    for (std::size_t k = 0; k < size(); ++k) weights_[k] = {other[k], 0.0};
    sum_ = 0.0;
  }
  /// out ← w of so many weights in a row. Hot.
  void settle(std::size_t first, std::size_t count, double* out) const {
    const Weight* const w = weights_.data() + first;
    for (std::size_t k = 0; k < count; ++k) out[k] = w[k].v + sum_ * w[k].e;
  }
  /// w_k ← w_k + change.
  void add(std::size_t k, double change) { weights_[k].v += change; }

  /// q_a ← Σ_i w(i, a) over the rows i of a table with `actions` columns. Hot.
  void sumRows(std::span<const Index> rows, std::size_t actions, double* q) const;

  /// Σ_i w(i, column) over the rows i of a table with so many columns. Hot.
  double sum(std::span<const Index> rows, Index columns, Index column) const {
    const Weight* weights = weights_.data() + column;
    Weight total;
    for (const Index row : rows) {
      const Weight& w = weights[row * columns];
      total.v += w.v;
      total.e += w.e;
    }
    return total.v + sum_ * total.e;
  }

 private:
  friend class DeferredTrace;

  template <std::size_t kColumns>
  void sumColumns(std::span<const Index> rows, std::size_t columns, std::size_t first, double* q) const;

  /// Side by side, because whoever reads one needs the other.
  struct Weight {
    double v = 0.0, e = 0.0;
  };

  std::vector<Weight> weights_;
  double sum_ = 0.0;  // D
};

}  // namespace surefoot
