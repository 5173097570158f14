// SPDX-License-Identifier: GPL-3.0-or-later
// Radial basis functions (Sutton & Barto 2018, section 9.5.5; thesis, section 6.5): Gaussians on a grid of centres,
// normalised to a sum of 1,
//
//   x_i(s) = g_i(s) / Σ_j g_j(s),   g_i(s) = Π_d exp(−(s_d − c_id)² / 2σ_d²)
//
// The spacing of the centres and the width σ are set apart: resolution and generalisation, which tile coding ties
// together. A Gaussian ends at kReach widths, so that a state has a fixed block of centres around it; as both the
// Gaussian and the block are products over the dimensions, so are sum and normalisation.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/environment.h"
#include "core/features/feature_map.h"

namespace surefoot {

class RadialBasis {
 public:
  static constexpr int kMostActive = 4096;
  static constexpr double kReach = 3.0;  ///< beyond it a Gaussian is below 0.011 of its top
  using Active = ActiveFeatures<kMostActive, false>;
  static constexpr bool kBinary = false;

  struct Settings {
    double scale = 1.0;              ///< multiplies every resolution
    double widthScale = 1.0;         ///< multiplies every width
    std::vector<double> resolution;  ///< centres per span, one a state variable
    std::vector<double> width;       ///< σ, in units of the variable

    explicit Settings(const Task& task);
    void declare(Fields& f);
    const std::vector<StateVariable>& variables() const { return variables_; }

   private:
    std::vector<StateVariable> variables_;
  };

  /// Refused if there are too many centres, too many at once, or a wrapping variable has no whole number of them.
  static Result<RadialBasis> create(const Task& task, const Settings& settings);

  Index size() const { return size_; }
  double total() const { return 1.0; }
  Cover find(std::span<const double> state, Active& x) const;
  nlohmann::json layout() const;
  /// Centres along each dimension, the last dimension first.
  std::vector<std::size_t> shape() const;

 private:
  struct Dimension {
    std::string key;
    double first = 0.0, spacing = 1.0, width = 1.0;  // in units of the variable
    double low = 0.0, high = 0.0;                    // the range, clamped to
    int centres = 1, block = 1;                      // in all; at once
    bool wraps = false;
    Index stride = 1;
  };

  RadialBasis() = default;
  static Result<Dimension> layOut(const StateVariable& variable, const Settings& settings, std::size_t d);

  Index size_ = 1;
  std::vector<Dimension> dimensions_;
};

static_assert(FeatureMap<RadialBasis>);

}  // namespace surefoot
