// SPDX-License-Identifier: GPL-3.0-or-later
// The eligibility trace z (thesis, section 2.2.2; Sutton & Barto 2018, section 12.7): which weights are answerable for
// the reward that comes now. Only the entries that differ from 0 are kept; every one of them is touched in every step.
// Where it can, the learner takes DeferredTrace, which is faster. This class is for accumulating traces and for
// features that are not binary; tests compare DeferredTrace with it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/files/archive.h"
#include "core/values/weight_table.h"

namespace surefoot {

/// Used by one thread; for one table. Most calls need only the size of the table.
class EligibilityTrace {
 public:
  /// z ← factor·z; entries whose size falls below `cutoff` are dropped.
  void decay(const WeightTable& table, double factor, double cutoff);
  /// z_i ← 1 (replacing traces, Singh & Sutton 1996).
  void replace(const WeightTable& table, Index weight) { entry(table, weight).z = 1.0; }
  /// z_i ← z_i + x (accumulating traces).
  void accumulate(const WeightTable& table, Index weight, double x = 1.0) { entry(table, weight).z += x; }
  /// z_i ← max(z_i, x): a replacing trace of a feature that is worth x.
  void raise(const WeightTable& table, Index weight, double x) {
    Entry& e = entry(table, weight);
    if (e.z < x) e.z = x;
  }
  /// z_i.
  double at(const WeightTable&, Index weight) const {
    return weight < slot_.size() && slot_[weight] != kNone ? entries_[slot_[weight]].z : 0.0;
  }
  /// z_i ← 0.
  void drop(const WeightTable& table, Index weight);
  /// z ← 0.
  void clear(const WeightTable& table);
  /// w ← w + step·z.
  void add(WeightTable& table, double step) const {
    for (const Entry& e : entries_) table.add(e.weight, step * e.z);
  }

  struct Entry {
    Index weight;
    double z;
  };
  std::span<const Entry> entries() const { return entries_; }

  void transfer(const WeightTable& table, Archive& archive);

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  Entry& entry(const WeightTable& table, Index weight);
  void remove(std::uint32_t slot);

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> slot_;  // [weight] where its entry stands, or kNone; empty until it is needed
};

}  // namespace surefoot
