#include "dictionary/Parser.h"

#include "dictionary/Dictionary.h"
#include "dictionary/Limits.h"

#include <gtest/gtest.h>

#include <chrono>

namespace fpm {

namespace {

std::string messageOf(const std::string& text)
{
    try {
        parseText(text, "text");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::string valuesOf(const std::string& text, const std::string& key)
{
    const auto document = parseText(text, "text");
    std::string values;
    for (const auto& value : document->nodes.front().find(key)->values)
        values += std::string(document->text(value)) + ' ';
    return values;
}

bool startsWith(const std::string& text, const std::string& beginning)
{
    return text.rfind(beginning, 0) == 0;
}

} // namespace

TEST(Parser, ReadsEntriesAndDictionaries)
{
    const auto document = parseText("a 1; b { c 2; d { } } \"e+f\" g;", "text");

    const auto& root = document->nodes.front();
    ASSERT_EQ(root.entries.size(), 3u);
    EXPECT_TRUE(root.entries[1].isDictionary());
    EXPECT_EQ(document->nodes[1].path(), "b");
    EXPECT_EQ(document->nodes[2].path(), "b.d");
    EXPECT_EQ(root.numbers.count("e+f"), 1u);
}

TEST(Parser, AcceptsASemicolonAfterADictionary)
{
    EXPECT_EQ(parseText("a { }; b 1;", "text")->nodes.front().entries.size(), 2u);
}

TEST(Parser, KeepsNestedListsAsTheyAre)
{
    EXPECT_EQ(valuesOf("a table ((0 0) (1 5));", "a"), "table ( ( 0 0 ) ( 1 5 ) ) ");
    EXPECT_EQ(valuesOf("a ();", "a"), "( ) ");
}

TEST(Parser, DropsTheCountOfAList)
{
    EXPECT_EQ(valuesOf("a 3(1 2 3);", "a"), "( 1 2 3 ) ");
    EXPECT_EQ(valuesOf("a 2(2(1 2) (3 4));", "a"), "( ( 1 2 ) ( 3 4 ) ) ");
    EXPECT_EQ(valuesOf("a 3 (1 2);", "a"), "3 ( 1 2 ) ") << "a blank makes it a value";
    EXPECT_EQ(valuesOf("b 1 2; a 3(1 $b);", "a"), "( 1 1 2 ) ") << "a macro may fill the rest";
}

TEST(Parser, ReadsAValueOverSeveralLines)
{
    EXPECT_EQ(valuesOf("a\n  table\n;", "a"), "table ");
    EXPECT_EQ(valuesOf("a table\n  (\n word\n)\n ;", "a"), "table ( word ) ");
    EXPECT_EQ(valuesOf("a 1\n  2;", "a"), "1 2 ");
}

TEST(Parser, FindsAForgottenSemicolon)
{
    EXPECT_TRUE(startsWith(messageOf("a 1\nb 2;"), "missing ';' after '1'"));
    EXPECT_TRUE(startsWith(messageOf("a 1\nb;"), "missing ';' after '1'"));
    EXPECT_TRUE(startsWith(messageOf("a\nb 2;"), "missing ';' after 'a'"));
    EXPECT_TRUE(startsWith(messageOf("a 1\nb { }"), "missing ';' after '1'"));
    EXPECT_TRUE(startsWith(messageOf("a 1 // c\n\nb 2;"), "missing ';' after '1'"));
    EXPECT_TRUE(startsWith(messageOf("a { b 1 }"), "missing ';' after '1'"));
    EXPECT_TRUE(startsWith(messageOf("a 1"), "missing ';' after '1'"));
    EXPECT_TRUE(startsWith(messageOf("a 1\n#include \"b\""), "missing ';' after '1'"));
}

TEST(Parser, NamesTheDictionaryOfAFault)
{
    EXPECT_NE(messageOf("a { b { c 1; } d 2 }").find("--> text:1:19, in a\n"), std::string::npos);
    EXPECT_NE(messageOf("a ( { } { b 1 } );").find(", in a[1]\n"), std::string::npos);
}

TEST(Parser, RefusesAnUnclosedBrace)
{
    const auto message = messageOf("a\n{\n  b 1;\n");

    EXPECT_TRUE(startsWith(message, "this '{' is never closed\n  --> text:2:1"));
    EXPECT_NE(message.find("text:4:1"), std::string::npos);
}

TEST(Parser, SurvivesHostileNesting)
{
    for (const auto* opening : {"a{", "a(", "a({", "a 1(", "("}) {
        std::string text;
        for (int depth = 0; depth < 100'000; ++depth) text += opening;
        EXPECT_NE(messageOf(text), "") << opening;
    }
}

TEST(Parser, ReadsUpToTheLimitOfNesting)
{
    const auto nested = [](int depth) {
        return "a " + std::string(depth, '(') + std::string(depth, ')') + ';';
    };

    EXPECT_EQ(messageOf(nested(limits::nesting)), "");
    EXPECT_TRUE(startsWith(messageOf(nested(limits::nesting + 1)), "brackets are nested"));
}

TEST(Parser, ReadsAListOfManyDictionariesInLinearTime)
{
    std::string text = "a (";
    for (int count = 0; count < 100'000; ++count) text += "{}";
    const auto start = std::chrono::steady_clock::now();

    EXPECT_EQ(messageOf(text + ");"), "");

    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(Parser, LimitsTheNumberOfEntries)
{
    std::string text;
    for (std::size_t count = 0; count <= limits::entries; ++count)
        text += 'k' + std::to_string(count) + ";";

    EXPECT_TRUE(startsWith(messageOf(text), "there are more than 1000000 entries"));
}

TEST(Parser, RefusesATextLargerThanTheLimit)
{
    EXPECT_THROW(parseText(std::string(limits::fileBytes + 1, ' '), "text"), Error);
}

TEST(Parser, AcceptsEveryKindOfLineEndAndAByteOrderMark)
{
    const auto document = parseText("\xEF\xBB\xBF"
                                    "a 1;\r\n// x\rb 2;\nc 3;",
                                    "text");

    EXPECT_EQ(document->nodes.front().entries.size(), 3u);
}

TEST(Parser, RefusesNulAndWhatIsNotUtf8)
{
    EXPECT_TRUE(startsWith(messageOf(std::string("a b\0c;", 6)), "there is a NUL byte"));
    EXPECT_TRUE(startsWith(messageOf("a \"\xC3\x28\";"), "this byte is not UTF-8"));
    EXPECT_TRUE(startsWith(messageOf("\xFF\xFE"
                                     "a"),
                           "this byte is not UTF-8"));
}

} // namespace fpm
