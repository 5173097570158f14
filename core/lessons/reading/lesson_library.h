// SPDX-License-Identifier: GPL-3.0-or-later
// The lessons of a folder, in the order of their files' names.
#pragma once

#include <filesystem>

#include "core/lessons/lesson.h"
#include "core/text/translate.h"

namespace surefoot {

struct ShelvedLesson {
  std::string path;
  std::optional<Lesson> lesson{};       ///< nothing: the file has an error
  std::vector<Complaint> complaints{};  ///< then what is wrong with it
  std::string file() const { return std::filesystem::path(path).filename().string(); }
};

/// A lesson's file, read and checked; an error only if it cannot be opened.
Result<ShelvedLesson> readLessonFile(const Registry& registry, const std::string& path,
                                     const Translate& translate = {});

/// All NAME.toml of a folder. Links and `needs` that lead to no lesson of it are complaints.
std::vector<ShelvedLesson> lessonsIn(const Registry& registry, const std::string& folder,
                                     const Translate& translate = {});

}  // namespace surefoot
