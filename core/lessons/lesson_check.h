// SPDX-License-Identifier: GPL-3.0-or-later
// Lives through a lesson as its solutions say, and as nobody should.
#pragma once

#include "core/lessons/lesson_life.h"

namespace surefoot {

/// All steps. What does not come out gets a complaint: a task that is done before anything was done, by its wrong way,
/// or not by its solution; a par that the solution does not keep; a text that says what does not hold (`expect`); a run
/// that does not end; a prediction whose outcome lies outside its range; a place that should be accepted and is not.
/// `told` gets of every step what a student reads, with its numbers, and what the step came to.
struct ToldStep {
  std::string say{}, came{};
};
std::vector<Complaint> liveThrough(const Registry& registry, const Lesson& lesson, std::uint64_t seed,
                                   std::vector<ToldStep>* told = nullptr);

}  // namespace surefoot
