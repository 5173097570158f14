// SPDX-License-Identifier: GPL-3.0-or-later
// The exit codes of the program. The README lists them; scripts rely on them.
#pragma once

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
