// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `lessons`, and those of `window` about lessons.
#pragma once

#include "app/requests/laboratory_line.h"

namespace surefoot {

struct LessonsLine {
  /// Adds `lessons` to the program, and the options to `window`.
  LessonsLine(CLI::App& app, CLI::App& window);

  CLI::App* lessons;
  LessonsRequest request;
  std::optional<std::string> lesson, kiosk, student, classFolder, resetAfter;

  /// The window's options, checked, into its request.
  Status complete(WindowRequest& window) const;
};

}  // namespace surefoot
