// SPDX-License-Identifier: GPL-3.0-or-later
// An answer that is chosen or typed, and not given yet.
#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace surefoot {

/// In the words of a mark (hand_in.h).
struct LessonDraft {
  std::string answer{}, because{};
  bool operator==(const LessonDraft&) const = default;
};
using LessonDrafts = std::map<std::size_t, LessonDraft>;  // by steps, from 0

}  // namespace surefoot
