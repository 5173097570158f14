// SPDX-License-Identifier: GPL-3.0-or-later
// `--load FILE`: the file knows what it was learned under; what is given besides comes on top.
#pragma once

#include "app/requests/requests.h"
#include "core/experiment/configuration.h"

namespace surefoot {

/// The configuration of a Q-function or checkpoint with other names and values on top; no seed, no length. A preset or
/// scenario that is given brings its values, other values that the file's life had changed stay. Another environment or
/// other features cannot be meant: refused with both. An error names the file or the option.
Result<Configuration> configurationUpon(const Registry& registry, const TensorFile& file, const ChosenNames& chosen,
                                        const std::vector<Assignment>& assignments);

}  // namespace surefoot
