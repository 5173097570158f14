// SPDX-License-Identifier: GPL-3.0-or-later
// Grades a hand-in by living it again: what it says is believed only as far as its lives come out the same.
#pragma once

#include <atomic>

#include "core/lessons/handed_in/hand_in.h"
#include "core/lessons/reading/lesson_library.h"

namespace surefoot {

struct Grade {
  std::string student, lesson;
  bool finished = false;
  std::size_t steps = 0, reached = 0;  ///< of the lesson; the steps that were gone through
  int questions = 0, rightAtOnce = 0, rightAtLast = 0;
  int tasks = 0, tasksDone = 0, pars = 0;
  int predictions = 0;
  double minutes = 0.0;
  bool trusted = true;                 ///< nothing was edited, and every life came out as it was handed in
  std::vector<std::string> remarks{};  ///< what is wrong, one sentence each
};

/// `lesson`: the one that the hand-in is of. `interrupted`, set by anyone, ends it early.
Grade gradeOf(const Registry& registry, const Lesson& lesson, const HandIn& handIn,
              const std::atomic<bool>* interrupted = nullptr);

/// The head and a line of the table (RFC 4180).
std::string gradesHead();
std::string asCsv(const Grade& grade);

}  // namespace surefoot
