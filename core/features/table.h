// SPDX-License-Identifier: GPL-3.0-or-later
// A table: one feature a state, for worlds whose state variables are whole numbers (Sutton & Barto 2018, section 9.3).
#pragma once

#include <vector>

#include "core/environment.h"
#include "core/features/feature_map.h"

namespace surefoot {

class Table {
 public:
  /// Refused if a state variable is not a whole number, or there are too many states.
  static Result<Table> create(const Task& task);

  Index size() const { return size_; }
  int active() const { return 1; }
  bool activeFeatures(std::span<const double> state, std::span<Index> out) const;

 private:
  struct Dimension {
    double low = 0.0, high = 0.0;
    Index stride = 1;
  };

  Table() = default;

  Index size_ = 1;
  std::vector<Dimension> dimensions_;
};

static_assert(FeatureMap<Table>);

}  // namespace surefoot
