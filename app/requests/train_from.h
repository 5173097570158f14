// SPDX-License-Identifier: GPL-3.0-or-later
// `--from FILE`: what a journal, a saved session or a Q-function says of the life behind it, to be lived anew.
#pragma once

#include <optional>

#include "core/experiment/configuration.h"

namespace surefoot {

struct LivedBefore {
  Configuration configuration;        ///< that the life began with: seed and all that was done to it included
  std::optional<std::int64_t> steps;  ///< how long it had lived when it was saved; a Q-function does not say
};

/// An error names the file.
Result<LivedBefore> readLivedBefore(const Registry& registry, const std::string& path);

}  // namespace surefoot
