// SPDX-License-Identifier: GPL-3.0-or-later
// A table: one feature a state, for worlds whose state variables are whole numbers (Sutton & Barto 2018, section 9.3).
#pragma once

#include <vector>

#include "core/environment.h"
#include "core/features/feature_map.h"

namespace surefoot {

class Table {
 public:
  using Active = ActiveFeatures<1, true>;
  static constexpr bool kBinary = true;

  /// Refused if a state variable is not a whole number, or there are too many states.
  static Result<Table> create(const Task& task);

  Index size() const { return size_; }
  double total() const { return 1.0; }
  Cover find(std::span<const double> state, Active& x) const;
  nlohmann::json layout() const;
  /// States along each dimension, the last dimension first.
  std::vector<std::size_t> shape() const;

 private:
  struct Dimension {
    std::string key;
    double low = 0.0, high = 0.0;
    Index stride = 1;
  };

  Table() = default;

  Index size_ = 1;
  std::vector<Dimension> dimensions_;
};

static_assert(FeatureMap<Table>);

}  // namespace surefoot
