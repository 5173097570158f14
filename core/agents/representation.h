// SPDX-License-Identifier: GPL-3.0-or-later
// From a name and parameters to a feature map, and to an estimate over it: what every agent is built from.
#pragma once

#include <variant>

#include "core/features/hashed_tile_coder.h"
#include "core/features/radial_basis.h"
#include "core/features/table.h"
#include "core/features/tile_coder.h"
#include "core/registry.h"
#include "core/values/estimate.h"

namespace surefoot {

/// Every feature map that an estimate may stand on.
using AnyFeatures = std::variant<TileCoder, HashedTileCoder, RadialBasis, Table>;

/// The settings of all representations.
struct RepresentationSettings {
  TileSettings tiles;
  RadialBasis::Settings gaussians;
  explicit RepresentationSettings(const Task& task) : tiles(task), gaussians(task) {}
  /// Declares the settings of the named features.
  void declare(const std::string& features, Fields& f);
};

/// The features named `features`, or why they do not fit the task.
/// `prefix` is that of the settings' keys, "features.".
Result<AnyFeatures> makeFeatures(const Task& task, const std::string& features, const RepresentationSettings& settings,
                                 const std::string& prefix);

/// An estimate for `actions` actions. If `stored` is given, its tables are read later (Agent::transferValues); that
/// they fit is checked here, before any memory is taken. `name` is the estimate's in files.
template <FeatureMap F>
Result<Estimate<F>> makeEstimate(const std::string& name, F features, int actions, const InitialValue& initial,
                                 std::uint64_t seed, const EstimateSettings& learning, const TensorFile* stored);

/// Whether a stored estimate has our layout; the error names the first difference, with both values. The tables of a
/// hashed estimate are only as long as its number of features (`growing`).
Status checkLayout(const TensorFile& stored, const std::string& name, const Json& layout,
                   const std::vector<std::size_t>& shape, bool growing);

template <FeatureMap F>
Result<Estimate<F>> makeEstimate(const std::string& name, F features, int actions, const InitialValue& initial,
                                 std::uint64_t seed, const EstimateSettings& learning, const TensorFile* stored) {
  if (stored) {
    std::vector<std::size_t> shape = features.shape();
    shape.push_back(columnsOf(features, actions));
    if (const Status s = checkLayout(*stored, name, features.layout(), shape, ClaimingFeatureMap<F>); !s)
      return s.error();
  }
  return Estimate<F>(LinearActionValue<F>(std::move(features), actions, initial, seed), learning);
}

}  // namespace surefoot
