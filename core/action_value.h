// SPDX-License-Identifier: GPL-3.0-or-later
// q̂(s, a, w): the estimated action values, seen from outside a learner. A value: it can be copied while the learner
// goes on, and the copy read on another thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/basics/types.h"

namespace surefoot {

/// The memory of a table of features. A dense table has a slot for every feature.
struct MemoryUse {
  std::size_t slots = 0;
  std::optional<std::size_t> occupied;        ///< slots in use, in a hashed table
  std::optional<std::int64_t> failedLookUps;  ///< in a hashed table, since the life began
};

/// The eligibility of a weight. Lists of them are in the order of the weights; a weight not in the list has none.
struct Eligibility {
  std::uint64_t weight = 0;
  float z = 0.0f;
};

class ActionValueFunction {
 public:
  virtual ~ActionValueFunction() = default;

  /// Number of actions: the length of every `q` below.
  virtual int actions() const = 0;
  /// q ← q̂(s, ·) of one layer.
  virtual void evaluate(std::span<const double> state, Layer layer, std::span<double> q) const = 0;
  /// Whether Layer::Positive and Layer::Negative differ from the sum.
  virtual bool split() const { return false; }
  /// Whether there is a Layer::Risk.
  virtual bool hasRisk() const { return false; }
  /// Mean over the features of s of how often each was visited (its state was updated, for any action).
  virtual double visits(std::span<const double> state) const = 0;
  /// Share of the features of s that were ever visited, 0 … 1.
  virtual double familiarity(std::span<const double> state) const = 0;
  /// out ← for every action, the mean eligibility of the features of s.
  virtual void average(std::span<const Eligibility> z, std::span<const double> state, std::span<double> out) const = 0;

  /// The weights, a table for each estimate.
  virtual std::vector<std::vector<double>> tables() const = 0;
  /// The memory of each table.
  virtual std::vector<MemoryUse> memoryUse() const = 0;
  /// Memory of a copy [bytes], about.
  virtual std::size_t bytes() const = 0;
  virtual std::unique_ptr<ActionValueFunction> clone() const = 0;
  /// Copies the content of a function of the same shape, without allocation.
  virtual void assign(const ActionValueFunction& other) = 0;
};

}  // namespace surefoot
