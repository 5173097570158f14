// SPDX-License-Identifier: GPL-3.0-or-later
// 64 bits over a sequence of words, in order: tells contents apart; it is no protection against people.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

#include "core/basics/random.h"

namespace surefoot {

class Hash64 {
 public:
  void add(std::uint64_t word) { state_ = mix64((state_ ^ word) + 0x9e3779b97f4a7c15ULL); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  std::uint64_t value() const { return state_; }
  void setValue(std::uint64_t value) { state_ = value; }

 private:
  std::uint64_t state_ = 0x5375'7265'666f'6f74ULL;
};

}  // namespace surefoot
