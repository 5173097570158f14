// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/basics/expects.h"

#include <gtest/gtest.h>

namespace surefoot {

TEST(Expects, SaysWhereAndWhatShouldHold) {
  EXPECT_NO_THROW(expects(true, "all is well"));
  const int line = __LINE__ + 2;
  try {
    expects(false, "a table has rows");
    FAIL();
  } catch (const std::logic_error& error) {
    const std::string told = error.what();
    EXPECT_NE(told.find("expects_test.cpp:" + std::to_string(line)), std::string::npos) << told;
    EXPECT_NE(told.find("a table has rows"), std::string::npos) << told;
  }
}

}  // namespace surefoot
