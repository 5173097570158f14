// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/printable.h"

#include <gtest/gtest.h>

namespace surefoot {

TEST(Printable, OrdinaryTextStays) {
  for (const char* text : {"", "Häßlich µ τ = 1 − ε ≥ 0", "a\tb\nc", "日本 🙂", "α̇"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, ControlCharactersAndTurnsOfDirectionAreShownAsEscapes) {
  EXPECT_EQ(printable("\x1b[31mred\x7f\r"), "\\x1b[31mred\\u007f\\x0d");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\\u009b31m");  // CSI as one character
  EXPECT_EQ(printable("a\xe2\x80\xae"
                      "b\xe2\x81\xa9"),
            "a\\u202eb\\u2069");  // right-to-left override, isolate's end
}

TEST(Printable, BytesThatAreNoUtf8AreShownAsEscapes) {
  EXPECT_EQ(printable("q\xff.st"), "q\\xff.st");
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");           // overlong
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // surrogate
  EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82");           // cut off
}

TEST(Printable, Utf8IsToldFromOtherBytes) {
  for (const char* text : {"", "abc", "Ä", "\xf4\x8f\xbf\xbf"}) EXPECT_TRUE(isUtf8(text)) << text;
  for (const char* text : {"\xff", "\xc0\xaf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80",
                           "\xf8\x88\x80\x80\x80", "\xe2\x82", "\x80"})
    EXPECT_FALSE(isUtf8(text)) << printable(text);
}

}  // namespace surefoot
