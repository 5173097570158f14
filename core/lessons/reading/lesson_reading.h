// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a lesson's TOML and checks all of it: names, texts, conditions, questions. Any thread.
#pragma once

#include "core/lessons/lesson.h"
#include "core/text/translate.h"

namespace surefoot {

inline constexpr std::size_t kLongestLesson = 256u << 10;  ///< [bytes]
inline constexpr int kMostWords = 60;                      ///< of a step's text
inline constexpr std::size_t kMostSteps = 40, kMostOptions = 8, kMostWays = 6;

/// The lesson; nothing if there is any complaint. `name`: of its file. `translate`: of its texts, each a whole, before
/// their numbers are compiled; labels of lives are theirs in expressions, and translated beside. What is asked, done
/// and marked is the same in every language. A lesson that says it is written in another than English stays as it is.
std::optional<Lesson> readLesson(const Registry& registry, std::string_view text, const std::string& name,
                                 std::vector<Complaint>& complaints, const Translate& translate = {});

/// "05-exploring.toml, line 12, column 8: …"
std::string complaintText(const std::string& file, const Complaint& complaint);

/// "200 episodes", "1.5 minutes", "5000 steps".
std::optional<LessonAmount> parseAmount(std::string_view text);

}  // namespace surefoot
