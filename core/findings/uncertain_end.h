// SPDX-License-Identifier: GPL-3.0-or-later
// A condition's end of learning is found from its lives, so other lives would give another end: falls and minutes up to
// it are less certain than the scatter of lives says. The bootstrap (Efron & Tibshirani 1993) shows by how much: it
// draws the condition's units with replacement, finds the end anew and measures up to this end.
#pragma once

#include <map>
#include <string>

#include "core/findings/measures.h"

namespace surefoot {

/// A(k) of a resample reaches to the end of the shortest of the lives that were drawn. The error is the root mean
/// square of the resamples' distances from our value, not from their own mean (mean_estimate.cpp).
///
/// The means in the resamples of falls, minutes, success_during, success_after, failure_during and failure_after, and
/// under `end` the episode in which learning ended (infinite: it never did). Two conditions with equally many units are
/// resampled alike. Empty if all resamples have the same end, or for one unit.
std::map<std::string, std::vector<double>, std::less<>> resampledUntilEnd(const ConditionRecord& record,
                                                                          std::optional<std::size_t> end);

}  // namespace surefoot
