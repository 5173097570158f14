// SPDX-License-Identifier: GPL-3.0-or-later
// Box2D's allocator with an answer for the day when memory runs out: the library's own hands null on to code that does
// not look. Stands in the executable, like box2d_clock.cpp, and for the same reason in an OBJECT library.
#include <box2d/b2_settings.h>

#include <cstdlib>
#include <new>

void* b2Alloc_Default(int32 size) {
  if (void* memory = std::malloc(static_cast<std::size_t>(size))) return memory;
  throw std::bad_alloc();
}
