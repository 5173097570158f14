// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the steps of a lesson: part of readLesson().
#pragma once

#include "core/lessons/lesson.h"
#include "core/text/translate.h"

namespace surefoot {

/// The panels of the Live page that a lesson can show.
const std::vector<std::string>& lessonPanels();
/// What else it can show: buttons of the run, choices of rule, policy and scenario.
const std::vector<std::string>& lessonControls();

/// `show`: the panels and knobs that the start of the lesson names.
void readSteps(const Registry& registry, const std::vector<const TomlNode*>& steps,
               const std::vector<std::string>& show, Lesson& lesson, std::vector<Complaint>& complaints,
               const Translate& translate);

}  // namespace surefoot
