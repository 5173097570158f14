// SPDX-License-Identifier: GPL-3.0-or-later
// Box2D's allocator. Worlds come and go with every episode: what one gives back is kept for the next one of the same
// thread, so that a step takes nothing from the heap. And there is an answer for the day when memory runs out: the
// library's own hands null on to code that does not look. Stands in the executable, like box2d_clock.cpp, and for the
// same reason in an OBJECT library.
#include <box2d/b2_settings.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <new>
#include <utility>

namespace {

constexpr std::size_t kSizes = 18, kMostKept = 64;  // powers of two up to 128 kB; blocks of each

/// In front of every block; 16 bytes keep the alignment.
struct alignas(16) Head {
  std::size_t power = kSizes;  ///< of its size; kSizes: too large to be kept
  Head* next = nullptr;        ///< while it is kept
};

thread_local bool over = false;  // the thread ends: nothing is kept any more

struct Kept {
  std::array<Head*, kSizes> first{};
  std::array<std::size_t, kSizes> count{};

  ~Kept() {
    over = true;
    for (Head* head : first)
      while (head) std::free(std::exchange(head, head->next));
  }
};
thread_local Kept kept;

}  // namespace

void* b2Alloc_Default(int32 size) {
  const auto wanted = static_cast<std::size_t>(std::max(size, 1));
  const auto power = static_cast<std::size_t>(std::bit_width(wanted - 1));
  const bool small = power < kSizes;
  if (small && !over && kept.first[power]) {
    Head* head = kept.first[power];
    kept.first[power] = head->next;
    --kept.count[power];
    return head + 1;
  }
  void* memory = std::malloc(sizeof(Head) + (small ? std::size_t{1} << power : wanted));
  if (!memory) throw std::bad_alloc();
  return new (memory) Head{small ? power : kSizes, nullptr} + 1;
}

void b2Free_Default(void* memory) {
  if (!memory) return;
  Head* head = static_cast<Head*>(memory) - 1;
  if (over || head->power >= kSizes || kept.count[head->power] >= kMostKept) return std::free(head);
  head->next = kept.first[head->power];
  kept.first[head->power] = head;
  ++kept.count[head->power];
}
