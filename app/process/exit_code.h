// SPDX-License-Identifier: GPL-3.0-or-later
// The exit codes of the program. `surefoot --help`, the manual and the handbook list them; scripts rely on them.
#pragma once

#include <string>
#include <string_view>

#include "core/basics/result.h"

namespace surefoot {

enum ExitCode : int {
  kDone = 0,
  kDifferent = 1,  ///< as diff has it
  kUsage = 2,
  kFile = 3,
  kDiverged = 4,
  kMismatch = 5,
  kUnanswered = 6,
  kInterrupted = 130
};

/// What each of them means.
struct ExitMeaning {
  ExitCode code;
  std::string_view text;
};
inline constexpr ExitMeaning kExitMeanings[] = {
    {kDone, "done"},
    {kDifferent, "difference: they differ"},
    {kUsage,
     "usage: an unknown name, a value out of range, an impossible combination, too little memory for it, no display "
     "for "
     "the window"},
    {kFile, "a file that cannot be read or written, or exists already"},
    {kDiverged,
     "the action values diverged, or a robot was cut off in a hundred episodes in a row; what was learned so far is "
     "reported"},
    {kMismatch, "replay --verify: it was not the same life"},
    {kUnanswered, "the program that moves a robot did not answer, or is not allowed to start; the life can go on"},
    {kInterrupted, "interrupted by Ctrl-C, SIGTERM or SIGHUP before it was done; what was done so far is reported"},
};
/// "Exit codes:", and a line each.
inline std::string exitCodesText() {
  std::string text = "Exit codes:\n";
  for (const ExitMeaning& m : kExitMeanings) {
    const std::string code = std::to_string(m.code);
    text += "  " + code + std::string(5 - code.size(), ' ') + std::string(m.text) + "\n";
  }
  return text;
}

constexpr ExitCode exitCode(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::File:
      return kFile;
    case ErrorKind::Diverged:
      return kDiverged;
    case ErrorKind::Mismatch:
      return kMismatch;
    case ErrorKind::Unanswered:
      return kUnanswered;
    case ErrorKind::Interrupted:
      return kInterrupted;
    case ErrorKind::Usage:
      break;
  }
  return kUsage;
}

}  // namespace surefoot
