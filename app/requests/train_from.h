// SPDX-License-Identifier: GPL-3.0-or-later
// `--from FILE`: lives a life anew, from its description in a journal, a saved session or a Q-function.
#pragma once

#include <optional>
#include <string>

#include "core/experiment/configuration.h"

namespace surefoot {

struct LivedBefore {
  Configuration configuration;        ///< as the life began, with its seed and all commands given to it
  std::optional<std::int64_t> steps;  ///< the life's length when it was saved; a Q-function does not hold it
  std::string note{};                 ///< what is left out; empty: nothing
};

/// An error names the file.
Result<LivedBefore> readLivedBefore(const Registry& registry, const std::string& path);

}  // namespace surefoot
