// SPDX-License-Identifier: GPL-3.0-or-later
// Hands the newest value from one writing thread to one reading thread; neither ever waits.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace surefoot {

/// Three copies: one is written, one is read, one lies in the middle. publish() and take() swap with the middle.
template <class T>
class TripleBuffer {
 public:
  /// Writer: the copy to fill in. It may hold an old value.
  T& back() { return copies_[back_]; }
  /// Writer: makes the copy in back() the newest value.
  void publish() { back_ = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kIndex; }
  /// Writer: whether the value that was published last was fetched.
  bool taken() const { return !(middle_.load(std::memory_order_relaxed) & kFresh); }

  /// Reader: fetches the newest value if it was not taken yet.
  bool take() {
    if (!(middle_.load(std::memory_order_relaxed) & kFresh)) return false;
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return true;
  }
  /// Reader: the value last taken.
  const T& front() const { return copies_[front_]; }

 private:
  static constexpr std::uint8_t kIndex = 3, kFresh = 4;
  std::array<T, 3> copies_{};
  std::atomic<std::uint8_t> middle_{1};
  std::uint8_t back_ = 0, front_ = 2;
};

}  // namespace surefoot
