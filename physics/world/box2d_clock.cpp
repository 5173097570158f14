// SPDX-License-Identifier: GPL-3.0-or-later
// Box2D without its profiling clock. b2World::Step reads the time a dozen times a step to fill in b2Profile; for a
// world of two bodies that is half of the step. These definitions stand in the executable, where the dynamic linker
// finds them before those of the library; Debian's Box2D stays as it is.
//
// This works only if the object file itself is linked into the executable (an OBJECT library, not an archive member
// that nobody asks for) and its symbols are visible. tests/physics/box2d_clock_test.cpp proves that it does.
#include <box2d/b2_timer.h>

b2Timer::b2Timer() : m_start_sec(0), m_start_usec(0) {}
void b2Timer::Reset() {}
float b2Timer::GetMilliseconds() const {
  return 0.0f;
}
