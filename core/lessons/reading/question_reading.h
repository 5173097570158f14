// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the question of a step: part of readLesson().
#pragma once

#include "core/lessons/reading/reading_parts.h"

namespace surefoot {

/// The question in `ask`; nothing: there is none, or it has a complaint.
std::optional<LessonQuestion> readQuestion(ReadingParts& parts, TomlReader& step);

}  // namespace surefoot
