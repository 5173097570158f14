// SPDX-License-Identifier: GPL-3.0-or-later
// What a class answered, for its teacher: who said what at which step, and what most say. Nothing is lived again here;
// grading does that.
#pragma once

#include <string>
#include <vector>

#include "core/lessons/handed_in/hand_in.h"

namespace surefoot {

struct ClassCell {
  enum class State { Nothing, There, Right, Wrong };
  State state = State::Nothing;
  std::string text{};  ///< "40", "2", "own words"
};

struct ClassStep {
  int answered = 0, right = 0;
  std::string mostSay{};  ///< "6 of 9 say: It forgets what it has learned." ; "half of them say 40 to 80"
};

struct ClassTable {
  std::vector<std::string> students;
  std::vector<std::vector<ClassCell>> cells;  ///< of each student, of each step
  std::vector<ClassStep> steps;
};

/// The hand-ins of other lessons are passed over; students in the order of their names.
ClassTable classTableOf(const Lesson& lesson, const std::vector<HandIn>& handIns);

}  // namespace surefoot
