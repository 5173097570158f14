// SPDX-License-Identifier: GPL-3.0-or-later
// What two lives were told otherwise.
#pragma once

#include "core/difference/difference.h"
#include "core/saved/journal.h"

namespace surefoot {

/// Names, seed, number of the life, limits, what it began with, the guardian's Q-function, and every parameter; then
/// the first command that is another, at the step from which on the commands differ.
std::vector<ToldOtherwise> toldOtherwise(const Journal& first, const Journal& second);

}  // namespace surefoot
