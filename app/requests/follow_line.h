// SPDX-License-Identifier: GPL-3.0-or-later
// `window --follow FILE`.
#pragma once

#include "app/requests/laboratory_line.h"

namespace surefoot {

struct FollowLine {
  /// Adds the option to the window's.
  explicit FollowLine(CLI::App& window);

  /// Whether the window may follow what was asked for: a file of a kind that can be followed, and no option that begins
  /// a life.
  Status check() const;

  const CLI::App& window;
  std::optional<std::string> follow;
};

}  // namespace surefoot
