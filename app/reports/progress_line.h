// SPDX-License-Identifier: GPL-3.0-or-later
// One line on the terminal, drawn over again.
#pragma once

#include <chrono>
#include <string>

namespace surefoot {

/// "0:07", "1:02:03"
std::string durationText(double seconds);

class ProgressLine {
 public:
  /// How much of the work is done (0 … 1), and a few words on it.
  void show(double share, const std::string& words);
  ~ProgressLine();

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace surefoot
