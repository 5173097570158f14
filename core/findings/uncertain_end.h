// SPDX-License-Identifier: GPL-3.0-or-later
// A condition's end of learning is found from its lives, so other lives would have ended elsewhere: falls and minutes
// up to it are less certain than the scatter of lives says. The bootstrap (Efron & Tibshirani 1993) tells by how much:
// it draws the condition's units with replacement, finds the end anew and measures up to there.
#pragma once

#include <map>
#include <string>

#include "core/findings/measures.h"

namespace surefoot {

/// Of falls, minutes, success_during, success_after, failure_during and failure_after the means of resamples. Two
/// conditions with as many units are resampled alike. Empty where no resample ends elsewhere, or there is one unit.
std::map<std::string, std::vector<double>, std::less<>> resampledUntilEnd(const ConditionRecord& record,
                                                                          std::optional<std::size_t> end);

}  // namespace surefoot
