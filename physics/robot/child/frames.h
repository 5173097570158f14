// SPDX-License-Identifier: GPL-3.0-or-later
// What a program that moves a robot and Surefoot say to each other ("surefoot child 1"), over the program's standard
// input and output. A frame: its kind and the bytes of its content, each 32 bits; then the content. All little-endian.
//
//   to the program                                      from the program
//   1 hello  lines of text, see helloText()             1  the line "surefoot child 1"
//   2 reset  4 random words of 64 bits, then the        2  the numbers of `sends`
//            parameters
//   3 step   the levels of the actuators                3  reward, terminated, truncated (1 or 0), the numbers
//                                                       4  instead of any answer: a sentence, why there is none
//
// Numbers are doubles. All chance of an episode comes from the random words; a reset forgets everything before.
#pragma once

#include <cstddef>
#include <cstdint>

namespace surefoot {

enum class FrameKind : std::uint32_t { Hello = 1, Reset = 2, Step = 3, Trouble = 4 };

struct FrameHead {
  std::uint32_t kind = 0, bytes = 0;
};

inline constexpr const char* kChildFormat = "surefoot child 1";
inline constexpr std::size_t kLongestTrouble = 4096;  ///< [bytes]

}  // namespace surefoot
