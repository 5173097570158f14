// SPDX-License-Identifier: GPL-3.0-or-later
// Weights, some of which have updates that were put off: w_k = v_k + D·e_k, with a sum D that all of them share (see
// DeferredTrace, which keeps D and e; without one e is 0 everywhere). Reading gives w.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/basics/expects.h"
#include "core/features/feature_map.h"

namespace surefoot {

class WeightTable {
 public:
  /// `size` weights of 0, with room for `most`.
  explicit WeightTable(std::size_t size, std::size_t most = 0) {
    weights_.reserve(std::max(size, most));
    weights_.resize(size);
  }
  /// The copy has the same room.
  WeightTable(const WeightTable& other) : sum_(other.sum_), added_(other.added_) {
    weights_.reserve(other.weights_.capacity());
    weights_ = other.weights_;
  }
  WeightTable(WeightTable&&) = default;
  WeightTable& operator=(const WeightTable&) = default;
  WeightTable& operator=(WeightTable&&) = default;
  ~WeightTable() = default;

  std::size_t size() const { return weights_.size(); }
  /// Drops weights, or adds weights of 0 in the reserved room.
  void resize(std::size_t size) {
    expects(size <= weights_.capacity(), "weights grow within the reserved room");
    weights_.resize(size);
  }
  void set(std::size_t k, double w) { weights_[k] = {w, 0.0}; }
  double operator[](std::size_t k) const { return weights_[k].v + sum_ * weights_[k].e; }
  /// All of w, or the first `count`, with all updates done.
  std::vector<double> settled() const { return settled(size()); }
  std::vector<double> settled(std::size_t count) const {
    std::vector<double> w(count);
    settle(0, count, w.data());
    return w;
  }
  /// Carries out all updates that were put off. w, which includes them already, does not change.
  void settle() {
    for (std::size_t k = 0; k < size(); ++k) set(k, (*this)[k]);
    sum_ = 0.0;
  }
  /// w_k ← w_k of another table, for `count` weights in a row; nothing may be put off in this table. Returns whether
  /// the other has put updates of them off: then these weights may change without being marked again.
  bool copy(const WeightTable& other, std::size_t first, std::size_t count) {
    bool putOff = false;
    for (std::size_t k = first; k < first + count; ++k) {
      set(k, other[k]);
      putOff |= other.weights_[k].e != 0.0;
    }
    return putOff;
  }
  bool putOff(std::size_t k) const { return weights_[k].e != 0.0; }
  /// Whether a weight was changed by add(), which puts nothing off.
  bool added() const { return added_; }
  /// out ← w of `count` weights in a row. Hot.
  void settle(std::size_t first, std::size_t count, double* out) const {
    const Weight* const w = weights_.data() + first;
    for (std::size_t k = 0; k < count; ++k) out[k] = w[k].v + sum_ * w[k].e;
  }
  /// Prefetches `count` weights in a row into the cache, which takes a while. Hot.
  void fetch(std::size_t first, std::size_t count) const {
    constexpr std::size_t kLine = 64 / sizeof(Weight);
    for (std::size_t k = first; k < first + count; k += kLine) __builtin_prefetch(weights_.data() + k);
  }
  /// w_k ← w_k + change.
  void add(std::size_t k, double change) {
    weights_[k].v += change;
    added_ = true;
  }

  /// q_a ← Σ_i w(i, a) over the rows i of a table with `actions` columns. Hot.
  void sumRows(std::span<const Index> rows, std::size_t actions, double* q) const;

  /// Σ_i w(i, column) over the rows i of a table with `columns` columns. Hot.
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

  /// Side by side, because one is never read without the other.
  struct Weight {
    double v = 0.0, e = 0.0;
  };

  std::vector<Weight> weights_;
  double sum_ = 0.0;  // D
  bool added_ = false;
};

}  // namespace surefoot
