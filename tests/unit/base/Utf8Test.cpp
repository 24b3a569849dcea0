#include "base/Utf8.h"

#include <gtest/gtest.h>

namespace fpm {

TEST(Utf8, KnowsTheLengthOfCharacters)
{
    EXPECT_EQ(characterLength("a", 0), 1u);
    EXPECT_EQ(characterLength("\xC3\xB6", 0), 2u);
    EXPECT_EQ(characterLength("\xE2\x82\xAC", 0), 3u);
    EXPECT_EQ(characterLength("\xF0\x9F\x98\x80", 0), 4u);
}

TEST(Utf8, RefusesMalformedBytes)
{
    for (const auto* text : {"\x80", "\xC3", "\xC3z", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80",
                             "\xF4\x90\x80\x80", "\xF8\x88\x80\x80", "\xE2\x82", "\xFF"})
        EXPECT_EQ(characterLength(text, 0), 0u);
}

TEST(Utf8, CountsCharactersNotBytes)
{
    EXPECT_EQ(countCharacters("gr\xC3\xB6\xC3\x9F"), 4u);
    EXPECT_EQ(countCharacters("\xFFz"), 2u);
}

TEST(Utf8, TakesTheTeethOutOfEscapeCodes)
{
    EXPECT_EQ(printable("\x1B[31mred\x07"), "?[31mred?");
    EXPECT_EQ(printable("\xC2\x9B"), "?") << "the one-character form of ESC [";
    EXPECT_EQ(printable("a\tb\xFF"), "a\tb?");
}

TEST(Utf8, LeavesTheEndsOfLines)
{
    EXPECT_EQ(printableLines("a\x1B\n\nb\r\n"), "a?\n\nb?\n");
    EXPECT_EQ(printableLines(""), "");
}

TEST(Utf8, CutsExcerptsBetweenCharacters)
{
    std::string text;
    for (int count = 0; count < 70; ++count) text += "\xC3\xB6";

    EXPECT_EQ(excerpt(text), text.substr(0, 120) + "...");
}

} // namespace fpm
