// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/values/eligibility_trace.h"

#include <algorithm>
#include <cmath>

namespace surefoot {

void EligibilityTrace::decay(const WeightTable&, double factor, double cutoff) {
  for (std::uint32_t slot = 0; slot < entries_.size();) {
    entries_[slot].z *= factor;
    if (std::abs(entries_[slot].z) < cutoff || entries_[slot].z == 0.0)
      remove(slot);  // the last entry, not yet decayed, takes its place
    else
      ++slot;
  }
}

void EligibilityTrace::drop(const WeightTable&, Index weight) {
  if (weight < slot_.size() && slot_[weight] != kNone) remove(slot_[weight]);
}

void EligibilityTrace::clear(const WeightTable&) {
  for (const Entry& e : entries_) slot_[e.weight] = kNone;
  entries_.clear();
}

void EligibilityTrace::transfer(const WeightTable& table, Archive& archive) {
  std::vector<Index> weights;
  std::vector<double> z;
  for (const Entry& e : entries_) weights.push_back(e.weight), z.push_back(e.z);
  archive.list("weights", weights, table.size());
  archive.list("z", z, table.size());
  if (!archive.reading() || !archive.good()) return;
  const auto outside = [&](Index i) { return i >= table.size(); };
  if (weights.size() != z.size() || std::any_of(weights.begin(), weights.end(), outside))
    return archive.refuse("weights", "does not fit the table");
  clear(table);
  for (std::size_t i = 0; i < weights.size(); ++i) entry(table, weights[i]).z = z[i];
}

EligibilityTrace::Entry& EligibilityTrace::entry(const WeightTable& table, Index weight) {
  if (slot_.size() < table.size()) slot_.resize(table.size(), kNone);
  std::uint32_t& slot = slot_[weight];
  if (slot == kNone) {
    slot = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back({weight, 0.0});
  }
  return entries_[slot];
}

void EligibilityTrace::remove(std::uint32_t slot) {
  slot_[entries_[slot].weight] = kNone;
  if (slot + 1 != entries_.size()) {
    entries_[slot] = entries_.back();
    slot_[entries_[slot].weight] = slot;
  }
  entries_.pop_back();
}

}  // namespace surefoot
