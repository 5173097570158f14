// SPDX-License-Identifier: GPL-3.0-or-later
// The eligibility trace z (thesis, section 2.2.2; Sutton & Barto 2018, section 12.7): which weights are answerable for
// the reward that comes now. Only the entries that differ from 0 are kept.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/features/feature_map.h"

namespace surefoot {

class EligibilityTrace {
 public:
  /// For a table of `weights` weights; no call below allocates once the trace has reached its usual length.
  explicit EligibilityTrace(std::size_t weights) : slot_(weights, kNone) { entries_.reserve(4096); }

  /// z ← factor·z; entries that fall below `cutoff` are dropped.
  void decay(double factor, double cutoff);
  /// z_i ← 1 (replacing traces, Singh & Sutton 1996).
  void replace(Index weight) { entry(weight).z = 1.0; }
  /// z_i ← z_i + x (accumulating traces).
  void accumulate(Index weight, double x = 1.0) { entry(weight).z += x; }
  /// z_i ← max(z_i, x): a replacing trace of a feature that is worth x.
  void raise(Index weight, double x) {
    Entry& e = entry(weight);
    if (e.z < x) e.z = x;
  }
  /// z_i ← 0.
  void drop(Index weight) {
    if (slot_[weight] != kNone) remove(slot_[weight]);
  }
  /// z ← 0.
  void clear();

  /// w ← w + step·z.
  void addTo(double* weights, double step) const {
    for (const Entry& e : entries_) weights[e.weight] += step * e.z;
  }

  struct Entry {
    Index weight;
    double z;
  };
  std::span<const Entry> entries() const { return entries_; }
  /// Puts saved entries back, in their order. Each weight once.
  void setEntries(std::span<const Entry> entries);

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  Entry& entry(Index weight);
  void remove(std::uint32_t slot);

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> slot_;  // [weight] where its entry stands, or kNone
};

}  // namespace surefoot
