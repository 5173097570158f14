// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/values/eligibility_trace.h"

namespace surefoot {

void EligibilityTrace::decay(double factor, double cutoff) {
  for (std::uint32_t slot = 0; slot < entries_.size();) {
    entries_[slot].z *= factor;
    if (entries_[slot].z < cutoff || entries_[slot].z == 0.0)
      remove(slot);  // the last entry, not yet decayed, takes its place
    else
      ++slot;
  }
}

void EligibilityTrace::clear() {
  for (const Entry& e : entries_) slot_[e.weight] = kNone;
  entries_.clear();
}

void EligibilityTrace::setEntries(std::span<const Entry> entries) {
  clear();
  for (const Entry& e : entries) entry(e.weight).z = e.z;
}

EligibilityTrace::Entry& EligibilityTrace::entry(Index weight) {
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
