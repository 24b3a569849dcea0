#include "dictionary/Report.h"

#include <gtest/gtest.h>

namespace fpm {

namespace {

Document documentOf(const std::string& text)
{
    Document document;
    document.files.push_back({"system/contactDict", text, {}, {}});
    return document;
}

Token tokenAt(std::uint32_t offset, std::uint32_t length)
{
    return {TokenKind::word, 0, offset, length};
}

} // namespace

TEST(Report, ShowsPlaceLineCaretAndAdvice)
{
    const auto document = documentOf(std::string(13, '\n') + "        fricton     0.3;\n");

    EXPECT_EQ(report(document, tokenAt(21, 7), "pairs.rodPlate", "unknown keyword 'fricton'",
                     "did you mean 'friction'?"),
              "unknown keyword 'fricton'\n"
              "  --> system/contactDict:14:9, in pairs.rodPlate\n"
              "   |\n"
              "14 |         fricton     0.3;\n"
              "   |         ^^^^^^^\n"
              "   = did you mean 'friction'?");
}

TEST(Report, CountsCharactersNotBytes)
{
    const auto document = documentOf("\"\xC3\xB6\" x");

    EXPECT_EQ(report(document, tokenAt(5, 1), "", "wrong", ""),
              "wrong\n  --> system/contactDict:1:5\n   |\n 1 | \"\xC3\xB6\" x\n   |     ^");
}

TEST(Report, UnderlinesToTheEndOfTheLineAtMost)
{
    const auto text = report(documentOf("ab\ncd"), tokenAt(1, 3), "", "wrong", "");

    EXPECT_TRUE(text.ends_with(" 1 | ab\n   |  ^"));
}

TEST(Report, ShowsAWindowOfALongLine)
{
    const auto text =
        report(documentOf(std::string(1'000'000, 'x')), tokenAt(500'000, 1), "", "w", "");

    EXPECT_LT(text.size(), 500u);
    EXPECT_NE(text.find("1:500001"), text.npos);
}

TEST(Report, MarksTheEndOfTheText)
{
    EXPECT_TRUE(
        report(documentOf("a 1"), tokenAt(3, 1), "", "w", "").ends_with(" 1 | a 1\n   |    ^"));
    EXPECT_TRUE(report(documentOf(""), tokenAt(0, 0), "", "w", "").ends_with(" 1 |\n   | ^"));
}

TEST(Report, FindsLineAndColumn)
{
    EXPECT_EQ(lineAndColumn("a\nbc\n", 0).line, 1u);
    EXPECT_EQ(lineAndColumn("a\nbc\n", 3).line, 2u);
    EXPECT_EQ(lineAndColumn("a\nbc\n", 3).column, 2u);
    EXPECT_EQ(lineAndColumn("a\nbc\n", 5).line, 3u);
}

} // namespace fpm
