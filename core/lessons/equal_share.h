// SPDX-License-Identifier: GPL-3.0-or-later
// ε-greedy and Softmax that explore equally often: the fair way to compare them.
#pragma once

#include <atomic>
#include <vector>

#include "core/experiment/configuration.h"

namespace surefoot {

/// The ε at which ε-greedy leaves the best of n actions in a share of its steps: share·n/(n − 1), as an exploring step
/// takes the best action with probability 1/n, too. At most 1.
double epsilonFor(double share, std::size_t actions);

/// A share of steps that explore, and the temperature at which Softmax explores so often.
struct ShareOfTemperature {
  double temperature, share;
};

/// The share at each of a row of temperatures, rising by the factor 2 from 1/16 to 64: measured in lives of so many
/// episodes that begin as `start` does. An interruption ends it early, with fewer rows.
std::vector<ShareOfTemperature> sharesOfSoftmax(const Registry& registry, const Configuration& start,
                                                std::int64_t episodes, const std::atomic<bool>* interrupted = nullptr);

/// The temperature for a share, between the rows (by the logarithm of the temperature); the first or last one beyond
/// them. 0 for a share of 0: greedy.
double temperatureFor(double share, const std::vector<ShareOfTemperature>& rows);

}  // namespace surefoot
