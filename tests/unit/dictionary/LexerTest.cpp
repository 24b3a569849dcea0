#include "dictionary/Lexer.h"

#include <gtest/gtest.h>

namespace fpm {

namespace {

/// The tokens of `text`, without the end.
std::vector<std::pair<TokenKind, std::string>> tokensOf(const std::string& text)
{
    Document document;
    document.files.push_back({"text", text, {}, {}});
    std::vector<std::pair<TokenKind, std::string>> tokens;
    for (Lexer lexer(document, 0); lexer.peek().kind != TokenKind::end;) {
        const auto token = lexer.take();
        tokens.emplace_back(token.kind, document.text(token));
    }
    return tokens;
}

std::size_t faultOffset(const std::string& text)
{
    try {
        tokensOf(text);
    } catch (const Fault& fault) {
        return fault.at.offset;
    }
    return text.npos;
}

} // namespace

TEST(Lexer, CutsAnEntryIntoTokens)
{
    const std::vector<std::pair<TokenKind, std::string>> expected{
        {TokenKind::word, "origin"},       {TokenKind::openBracket, "("},
        {TokenKind::number, "-1.5e-3"},    {TokenKind::macro, "$x"},
        {TokenKind::string, "\"a b\""},    {TokenKind::closeBracket, ")"},
        {TokenKind::semicolon, ";"},       {TokenKind::openBrace, "{"},
        {TokenKind::closeBrace, "}"},      {TokenKind::directive, "#include"},
        {TokenKind::macro, "$:pairs.a.b"},
    };

    EXPECT_EQ(tokensOf("origin(-1.5e-3 $x \"a b\");{}#include $:pairs.a.b"), expected);
}

TEST(Lexer, TakesPointsColonsAndDashesAsPartsOfAWord)
{
    EXPECT_EQ(tokensOf("alpha.water-2:x_1").size(), 1u);
}

TEST(Lexer, SkipsComments)
{
    EXPECT_EQ(tokensOf("a // b ; \n /* c { ** / \n */ d//").size(), 2u);
}

TEST(Lexer, KeepsCommentSignsInsideStrings)
{
    const auto tokens = tokensOf("\"http://x /* y\" z");

    ASSERT_EQ(tokens.size(), 2u);
    EXPECT_EQ(tokens[0].second, "\"http://x /* y\"");
}

TEST(Lexer, PointsAtWhatItRefuses)
{
    EXPECT_EQ(faultOffset("a \"b\nc\";"), 2u);
    EXPECT_EQ(faultOffset("a /* b"), 2u);
    EXPECT_EQ(faultOffset("a 1,5;"), 2u);
    EXPECT_EQ(faultOffset("ab [m] 5;"), 3u);
    EXPECT_EQ(faultOffset("a b\xC2\xB5;"), 3u);
    EXPECT_EQ(faultOffset("a ${b};"), 2u);
    EXPECT_EQ(faultOffset("a $..b;"), 2u);
    EXPECT_EQ(faultOffset("a $"), 2u);
}

TEST(Lexer, RefusesATokenLongerThanTheLimit)
{
    EXPECT_EQ(tokensOf(std::string(64 << 10, 'a')).size(), 1u);
    EXPECT_EQ(faultOffset(' ' + std::string((64 << 10) + 1, 'a')), 1u);
    EXPECT_EQ(faultOffset(' ' + std::string((64 << 10) + 1, '1')), 1u);
    EXPECT_EQ(faultOffset(" \"" + std::string(64 << 10, '1') + '"'), 1u);
}

TEST(Lexer, DoesNotLimitComments)
{
    EXPECT_EQ(tokensOf("/*" + std::string(1 << 20, '*') + "*/ a").size(), 1u);
}

} // namespace fpm
