// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/live/triple_buffer.h"

#include <gtest/gtest.h>

#include <thread>

namespace surefoot {

TEST(TripleBuffer, TakesTheNewestOnce) {
  TripleBuffer<int> buffer;
  EXPECT_FALSE(buffer.take());
  buffer.back() = 1, buffer.publish();
  buffer.back() = 2, buffer.publish();
  EXPECT_TRUE(buffer.take());
  EXPECT_EQ(buffer.front(), 2);
  EXPECT_FALSE(buffer.take());
  EXPECT_EQ(buffer.front(), 2);
}

TEST(TripleBuffer, NeverShowsHalfAValueOrAnOlderOne) {
  struct Pair {
    int a = 0, b = 0;
  };
  TripleBuffer<Pair> buffer;
  constexpr int kValues = 100'000;
  std::thread writer([&] {
    for (int i = 1; i <= kValues; ++i) {
      buffer.back() = {i, -i};
      buffer.publish();
    }
  });
  int last = 0;
  while (last < kValues) {
    if (!buffer.take()) {
      std::this_thread::yield();
      continue;
    }
    ASSERT_EQ(buffer.front().a, -buffer.front().b);
    ASSERT_GT(buffer.front().a, last);
    last = buffer.front().a;
  }
  writer.join();
}

}  // namespace surefoot
