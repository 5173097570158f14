// SPDX-License-Identifier: GPL-3.0-or-later
// CPU time, to measure speeds: other programs do not lengthen it.
#pragma once

#include <time.h>

namespace surefoot {

/// CPU time of the calling thread [s].
inline double threadCpuSeconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace surefoot
