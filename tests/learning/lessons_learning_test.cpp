// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons whose seed is the student's say what holds for other students, too. One of them, and all other lessons, are
// lived through in tests/contract.
#include <gtest/gtest.h>

#include "core/lessons/lesson_check.h"
#include "core/lessons/reading/lesson_library.h"
#include "core/lessons/reading/lesson_reading.h"
#include "tests/core/experiment/test_setup.h"

namespace surefoot {

TEST(Lessons, OfStudentsHoldForOtherStudents) {
  const Registry registry = fullRegistry();
  int lived = 0;
  for (const ShelvedLesson& one : lessonsIn(registry, std::string(SUREFOOT_SOURCE) + "/resources/lessons")) {
    ASSERT_TRUE(one.lesson) << one.path;
    if (!one.lesson->seedOfStudent) continue;
    ++lived;
    for (const std::uint64_t seed : {2, 3})
      for (const Complaint& wrong : liveThrough(registry, *one.lesson, seed))
        ADD_FAILURE() << "seed " << seed << ", " << complaintText(one.file(), wrong);
  }
  EXPECT_GT(lived, 0);
}

}  // namespace surefoot
