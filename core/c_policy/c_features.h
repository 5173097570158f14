// SPDX-License-Identifier: GPL-3.0-or-later
// From a state to its features, as C99 text, by the description of a feature map (FeatureMap::layout). Of every kind
// the text has the same operations in the same order as the map's find().
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/basics/result.h"
#include "core/files/tensor_file.h"

namespace surefoot {

/// The functions that `text` calls and does not have: whole numbers, exp, hashes.
std::string helpersInC(const std::string& text);

/// Features that a C program finds.
struct CFeatures {
  std::string text;       ///< static int NAME_features(const double s[], uint32_t x[], double value[]): how many are on
  int most = 1;           ///< at most so many at once
  bool binary = true;     ///< worth 1 each
  double tableBytes = 0;  ///< of the tables in `text`
};

/// Tiles of a hashed table are in `tiles`, in the order of their features.
Result<CFeatures> featuresInC(const std::string& name, const Json& layout, std::span<const std::uint64_t> tiles);

}  // namespace surefoot
