// SPDX-License-Identifier: GPL-3.0-or-later
// Box2D in a process that is not ours. The program's own definitions of sine, cosine and the profiling clock stand in
// the executable, where the dynamic linker finds them first (physics/world/box2d_clock.cpp). A library comes behind the
// C library, so the calls that Box2D makes are pointed at our definitions here, in the table through which it makes
// them.
#pragma once

#include "core/basics/result.h"

namespace surefoot {

/// Call once, before any world is made. An error: a call was not found, and worlds would have other bits.
Status bindBox2d();

}  // namespace surefoot
