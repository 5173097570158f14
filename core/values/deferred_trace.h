// SPDX-License-Identifier: GPL-3.0-or-later
// Replacing eligibility traces whose cost does not grow with their length (after Wiering & Schmidhuber 1998, Fast
// Online Q(λ), Machine Learning 33): the updates of a weight with a trace are put off until it is read or marked.
//
// Every trace decays by the same factor. Let P be the product of all factors so far: a weight that was marked when the
// product was P₀ has z = P/P₀. Its updates since then add up to Σ α δ_k P_k/P₀. With the sum D = Σ α δ_k P_k and
// e = 1/P₀
//
//   w = v + D·e,   z = e·P
//
//   decay    P ← f·P; the oldest marks, with z below the cut-off by now, are paid: v ← v + D·e, e ← 0
//   mark     v ← v + D·e − D/P, e ← 1/P, which leaves w as it is and makes z 1
//   add      D ← D + α δ·P, which adds α δ z to every weight
//
// Before P becomes too small to be exact everything is paid and P begins at 1 again. Equal to EligibilityTrace with the
// same cut-off up to rounding (tested on 10⁶ steps).
#pragma once

#include <span>
#include <vector>

#include "core/files/archive.h"
#include "core/values/weight_table.h"

namespace surefoot {

/// Used by one thread; works on one table that outlives it.
class DeferredTrace {
 public:
  DeferredTrace() : marks_(1024) {}

  /// z ← factor·z; entries that fall below `cutoff` are dropped.
  void decay(WeightTable& table, double factor, double cutoff);
  /// z_k ← 1 for k = row·columns + column of every row.
  void replace(WeightTable& table, std::span<const Index> rows, Index columns, Index column);
  /// z_k ← 1.
  void replace(WeightTable& table, Index k) { replace(table, std::span(&k, 1), 1, 0); }
  /// z_k ← 0.
  void drop(WeightTable& table, Index k) {
    WeightTable::Weight& w = table.weights_[k];
    w.v += table.sum_ * w.e;
    w.e = 0.0;
  }
  /// w ← w + step·z.
  void add(WeightTable& table, double step) { table.sum_ += step * product_; }
  /// z ← 0.
  void clear(WeightTable& table);

  /// z_k.
  double at(const WeightTable& table, std::size_t k) const { return table.weights_[k].e * product_; }

  /// f(k, z_k) for every weight with a trace.
  template <class F>
  void forEach(const WeightTable& table, F f) const {
    for (std::size_t i = begin_; i != end_; ++i) {
      const Mark& m = marks_[i & (marks_.size() - 1)];
      if (table.weights_[m.k].e == m.e) f(m.k, m.e * product_);
    }
  }

  void transfer(WeightTable& table, Archive& archive);

 private:
  struct Mark {
    Index k;
    double e;  // e of the weight when it was marked; the mark is dead if the table now holds another e
  };
  static constexpr double kSmallest = 1e-3;         // the smallest P: at most 3 digits of 16 are lost
  static constexpr std::size_t kUsualMarks = 4096;  // with more marks the dead ones are removed

  Mark& mark(std::size_t i) { return marks_[i & (marks_.size() - 1)]; }
  void pay(WeightTable& table, const Mark& mark) {
    WeightTable::Weight& w = table.weights_[mark.k];
    const bool alive = w.e == mark.e;  // no branch: nothing predicts it
    w.v += alive ? table.sum_ * mark.e : 0.0;
    w.e = alive ? 0.0 : w.e;
  }
  void makeRoom(std::size_t more);
  void beginAgain(WeightTable& table);

  void setProduct(double product) {
    product_ = product;
    inverse_ = 1.0 / product;
  }

  double product_ = 1.0;     // P
  double inverse_ = 1.0;     // 1/P
  std::vector<Mark> marks_;  // a ring, the oldest first; its size is a power of two
  std::size_t begin_ = 0, end_ = 0;
  std::size_t mostMarks_ = kUsualMarks;
};

}  // namespace surefoot
