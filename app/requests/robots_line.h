// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `check` and `new`: robots from files.
#pragma once

#include "app/requests/laboratory_line.h"

namespace surefoot {

struct RobotsLine {
  explicit RobotsLine(CLI::App& app);

  CLI::App *check, *create;
  CheckRequest checkRequest;
  NewRobotRequest newRequest;

  /// Nothing: none of these commands was given.
  std::optional<Result<Request>> request() const;
};

}  // namespace surefoot
