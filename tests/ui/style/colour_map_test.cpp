// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/colour_map.h"

#include <gtest/gtest.h>

namespace surefoot {

TEST(ColourMap, DivergesAroundThePaperColour) {
  EXPECT_EQ(divergingColour(0, false), qRgb(0xF7, 0xF6, 0xF3));
  EXPECT_EQ(divergingColour(1, false), qRgb(0x0A, 0x3A, 0x6B));
  EXPECT_EQ(divergingColour(-1, false), qRgb(0x7F, 0x2A, 0x00));
  EXPECT_EQ(divergingColour(0, true), qRgb(0x26, 0x2A, 0x30));
}

TEST(ColourMap, ClampsOutsideItsRange) {
  EXPECT_EQ(divergingColour(7, false), divergingColour(1, false));
  EXPECT_EQ(divergingColour(-7, true), divergingColour(-1, true));
  EXPECT_EQ(viridisColour(-1), viridisColour(0));
}

// matplotlib's viridis at 0, ½ and 1.
TEST(ColourMap, IsViridis) {
  EXPECT_EQ(viridisColour(0), qRgb(0x44, 0x01, 0x54));
  EXPECT_EQ(viridisColour(0.5), qRgb(0x21, 0x91, 0x8C));
  EXPECT_EQ(viridisColour(1), qRgb(0xFD, 0xE7, 0x25));
}

}  // namespace surefoot
