// SPDX-License-Identifier: GPL-3.0-or-later
// `--load FILE`: the file holds the configuration of its life; other options change it.
#pragma once

#include "app/requests/requests.h"
#include "core/experiment/configuration.h"

namespace surefoot {

/// The configuration of a Q-function or checkpoint with other names and values on top; no seed, no length. A given
/// preset or scenario brings its values; other values that the file's life had changed stay. Other features are
/// refused, and so is another environment, unless it is another version of the same robot's file, or `fromOther`. An
/// error names the file or the option.
Result<Configuration> configurationUpon(const Registry& registry, const TensorFile& file, const ChosenNames& chosen,
                                        const std::vector<Assignment>& assignments, bool fromOther = false);

}  // namespace surefoot
