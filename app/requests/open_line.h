// SPDX-License-Identifier: GPL-3.0-or-later
// What the window opens: `window FILE`, `window --follow FILE`, and in which window.
#pragma once

#include "app/requests/laboratory_line.h"

namespace surefoot {

struct OpenLine {
  /// Adds the options to the window's.
  explicit OpenLine(CLI::App& window);

  /// Whether the window may open what was asked for: a file that can be read, or one of a kind that can be followed,
  /// and no option that begins a life.
  Status check() const;
  /// What was checked, into the window's request.
  void complete(WindowRequest& request) const;

  /// The pages of the window by their names, in their order.
  static const std::vector<std::string>& pages();
  /// The languages of the window by their codes.
  static const std::vector<std::string>& languages();
  /// Whether a word in the place of a command is a file to open: it is there, or is written like one.
  static bool isFile(const std::string& word);

  const CLI::App& window;
  std::string file;
  std::optional<std::string> follow, page, language;
  bool newWindow = false, reuseWindow = false;

 private:
  Status nothingBeside(const std::vector<std::string>& allowed, const std::string& why) const;
};

}  // namespace surefoot
