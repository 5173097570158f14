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
  explicit WeightTable(std::size_t size) : v_(size), e_(size, 0.0) {}

  std::size_t size() const { return v_.size(); }
  double operator[](std::size_t k) const { return v_[k] + sum_ * e_[k]; }
  /// All of w, with nothing put off any more.
  std::vector<double> settled() const {
    std::vector<double> w(v_.size());
    for (std::size_t k = 0; k < w.size(); ++k) w[k] = (*this)[k];
    return w;
  }
  /// w ← values, nothing put off.
  void assign(std::span<const double> values) {
    v_.assign(values.begin(), values.end());
    e_.assign(v_.size(), 0.0);
    sum_ = 0.0;
  }
  /// w ← those of a table of the same size, nothing put off; without allocation.
  void assign(const WeightTable& other) {
    for (std::size_t k = 0; k < v_.size(); ++k) v_[k] = other[k];
    std::fill(e_.begin(), e_.end(), 0.0);
    sum_ = 0.0;
  }
  /// w_k ← w_k + change.
  void add(std::size_t k, double change) { v_[k] += change; }

  /// q_a ← Σ_i w(i, a) over the rows i of a table with `actions` columns. Hot.
  void sumRows(std::span<const Index> rows, std::size_t actions, double* q) const;

  /// Σ_i w(i, column) over the rows i of a table with so many columns. Hot.
  double sum(std::span<const Index> rows, Index columns, Index column) const {
    const double *v = v_.data(), *e = e_.data();
    double sv = 0.0, se = 0.0;
    for (const Index row : rows) {
      const Index k = row * columns + column;
      sv += v[k];
      se += e[k];
    }
    return sv + sum_ * se;
  }

 private:
  friend class DeferredTrace;

  std::vector<double> v_, e_;
  double sum_ = 0.0;  // D
};

}  // namespace surefoot
