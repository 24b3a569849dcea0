#include "dictionary/Dictionary.h"
#include "dictionary/Limits.h"

#include <gtest/gtest.h>

namespace fpm {

namespace {

std::string messageOf(const std::string& text)
{
    try {
        Dictionary::parse(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// m0 1; m1 $m0; ... up to m<depth>.
std::string chain(int depth)
{
    std::string text = "m0 1;";
    for (int number = 1; number <= depth; ++number)
        text += 'm' + std::to_string(number) + " $m" + std::to_string(number - 1) + ';';
    return text;
}

} // namespace

TEST(Macros, StandForAnEntryOfTheSameDictionary)
{
    EXPECT_EQ(Dictionary::parse("a 5; b $a;").number("b"), 5);
    EXPECT_EQ(Dictionary::parse("b $a; a 5;").number("b"), 5) << "order does not matter";
}

TEST(Macros, StandForAnEntryOfAnEnclosingDictionary)
{
    const auto top = Dictionary::parse("a 5; c 1; sub { c 2; x $a; y $c; }");

    EXPECT_EQ(top.sub("sub").number("x"), 5);
    EXPECT_EQ(top.sub("sub").number("y"), 2) << "the nearest wins";
}

TEST(Macros, ReachFromTheTopByPath)
{
    const auto top = Dictionary::parse("user { a { b 7; } } sub { x $:user.a.b; }");

    EXPECT_EQ(top.sub("sub").number("x"), 7);
}

TEST(Macros, SpliceIntoLists)
{
    const auto top = Dictionary::parse("a 1 2; b (3 4); c (0 $a); d ($b $b);");

    EXPECT_EQ(top.numbers("c"), (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(top.rows("d", 2), (std::vector<std::vector<double>>{{3, 4}, {3, 4}}));
}

TEST(Macros, OfTheirOwnNameMeanTheEnclosingOne)
{
    EXPECT_EQ(Dictionary::parse("a 5; sub { a $a; }").sub("sub").number("a"), 5);
    EXPECT_NE(messageOf("a $a;"), "");
}

TEST(Macros, CountAsUseOfWhatTheyName)
{
    const auto top = Dictionary::parse("a 5; b $a;");
    top.number("b");

    EXPECT_NO_THROW(top.requireAllUsed());
}

TEST(Macros, RefuseCycles)
{
    EXPECT_NE(messageOf("a $b; b $a;").find("'$a' leads back to itself"), std::string::npos);
    EXPECT_NE(messageOf("a ($b); b $c; c 1 $a;").find("leads back"), std::string::npos);
    EXPECT_NE(messageOf("a { x $:b.y; } b { y $:a.x; }").find("leads back"), std::string::npos);
}

TEST(Macros, ReachTheLimitOfDepthInAnyOrder)
{
    EXPECT_EQ(messageOf(chain(limits::macroDepth)), "");
    EXPECT_NE(messageOf(chain(limits::macroDepth + 1)).find("32 deep"), std::string::npos);
    EXPECT_NE(messageOf("z $m40;" + chain(40)).find("32 deep"), std::string::npos);
    EXPECT_NE(messageOf("z $m100000;" + chain(100000)).find("32 deep"), std::string::npos);
}

TEST(Macros, AreBoundInSize)
{
    std::string text = "m0 \"0123456789abcdef\";";
    for (int number = 1; number < 12; ++number) {
        text += 'm' + std::to_string(number) + " (";
        for (int count = 0; count < 10; ++count) text += " $m" + std::to_string(number - 1);
        text += ");";
    }

    EXPECT_NE(messageOf(text).find("macros expand to more than 8388608 bytes"), std::string::npos);
}

TEST(Macros, DoNotReadTheEnvironment)
{
    EXPECT_NE(messageOf("a $HOME;").find("environment variables are not read"), std::string::npos);
}

TEST(Macros, DoNotStandForDictionaries)
{
    EXPECT_NE(messageOf("a { } b $a;"), "");
    EXPECT_NE(messageOf("a ( { b $a; } );").find("names a dictionary"), std::string::npos);
}

} // namespace fpm
