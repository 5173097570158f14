// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reports/progress_line.h"

#include <fmt/format.h>

#include <cstdio>

#include "core/text/printable.h"

namespace surefoot {

namespace {

/// The terminal may be gone by now; that is no reason to lose the run.
void write(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace

std::string durationText(double seconds) {
  const auto s = static_cast<std::int64_t>(seconds + 0.5);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

void ProgressLine::show(double share, const std::string& words) {
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const auto filled = static_cast<std::size_t>(share * 24);
  const std::string left = share > 0.001 ? durationText(elapsed / share - elapsed) : "…";
  write(fmt::format("\r[{}{}] {:3.0f} %  {}, {} elapsed, {} left \033[K", std::string(filled, '#'),
                    std::string(24 - filled, '.'), share * 100, printable(words), durationText(elapsed), left));
}

ProgressLine::~ProgressLine() {
  write("\r\033[K");
}

}  // namespace surefoot
