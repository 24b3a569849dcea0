#include "dictionary/Dictionary.h"

#include <gtest/gtest.h>

namespace fpm {

namespace {

template <class Action>
std::string messageOf(Action action)
{
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

bool holds(const std::string& text, const std::string& part)
{
    return text.find(part) != text.npos;
}

} // namespace

TEST(Dictionary, ReadsNumbersWithinTheirRange)
{
    const auto dict = Dictionary::parse("a -1.5e-3; b 1; c 0;");

    EXPECT_EQ(dict.number("a"), -1.5e-3);
    EXPECT_EQ(dict.numberOr("b", 7, between(0, 1)), 1);
    EXPECT_EQ(dict.numberOr("absent", 7), 7);
    EXPECT_THROW(dict.number("c", positive()), InputError);
    EXPECT_EQ(dict.number("c", nonNegative()), 0);
    EXPECT_THROW(dict.number("a", nonNegative()), InputError);
}

TEST(Dictionary, TellsAKeyThatStandsAlone)
{
    const auto dict = Dictionary::parse("bare; valued 1; sub { a 1; }");

    EXPECT_TRUE(dict.isBare("bare"));
    EXPECT_FALSE(dict.isBare("valued"));
    EXPECT_FALSE(dict.isBare("sub"));
    EXPECT_FALSE(dict.isBare("absent"));
}

TEST(Dictionary, ReadsIntegers)
{
    const auto dict = Dictionary::parse("a 12; b 1e3;");

    EXPECT_EQ(dict.integer("a", 0, 20), 12);
    EXPECT_EQ(dict.integerOr("absent", 3, 0, 20), 3);
    EXPECT_THROW(dict.integer("a", 13, 20), InputError);
    EXPECT_TRUE(holds(messageOf([&] { dict.integer("b", 0, 2000); }), "write it in plain digits"));
}

TEST(Dictionary, ReadsAllSixSwitches)
{
    const auto dict = Dictionary::parse("a yes; b on; c true; d no; e off; f false; g y;");

    for (const auto* key : {"a", "b", "c"}) EXPECT_TRUE(dict.switchOr(key, false));
    for (const auto* key : {"d", "e", "f"}) EXPECT_FALSE(dict.switchOr(key, true));
    EXPECT_TRUE(dict.switchOr("absent", true));
    EXPECT_THROW(dict.switchOr("g", true), InputError);
}

TEST(Dictionary, ReadsWordsAndChoices)
{
    const auto dict = Dictionary::parse("a rod; b \"two words\"; c faces;");

    EXPECT_EQ(dict.word("a"), "rod");
    EXPECT_EQ(dict.word("b"), "two words");
    EXPECT_EQ(dict.wordOr("absent", "x"), "x");
    EXPECT_EQ(dict.choice("c", {"faces", "closestParticle"}), "faces");
    EXPECT_EQ(dict.choiceOr("absent", "faces", {"faces"}), "faces");
    EXPECT_THROW(dict.choice("a", {"faces"}), InputError);
}

TEST(Dictionary, ReadsVectorsAndLists)
{
    const auto dict = Dictionary::parse("v (1 2 3); n (); w (a \"b c\"); s a; r ((0 1) (2 3));");

    EXPECT_EQ(dict.vector("v"), (Point{1, 2, 3}));
    EXPECT_EQ(dict.vectorOr("absent", {4, 5, 6}), (Point{4, 5, 6}));
    EXPECT_TRUE(dict.numbers("n").empty());
    EXPECT_EQ(dict.words("w"), (std::vector<std::string>{"a", "b c"}));
    EXPECT_EQ(dict.words("s"), std::vector<std::string>{"a"});
    EXPECT_EQ(dict.rows("r", 2), (std::vector<std::vector<double>>{{0, 1}, {2, 3}}));
    EXPECT_THROW(dict.rows("r", 3), InputError);
    EXPECT_THROW(dict.numbers("r"), InputError);
    EXPECT_THROW(dict.vector("n"), InputError);
}

TEST(Dictionary, ReadsAWordWithWhatFollows)
{
    const auto dict =
        Dictionary::parse("a table ((0 0) (1 5)); c constant 5; b box ((0 0 0) (1 1 1));"
                          "d cylinder ((0 0 0) (0 0 1) 3); e smooth;");

    EXPECT_EQ(dict.leadingWord("a"), "table");
    EXPECT_EQ(dict.tailRows("a", 2), (std::vector<std::vector<double>>{{0, 0}, {1, 5}}));
    EXPECT_EQ(dict.tailNumbers("c"), std::vector<double>{5});
    EXPECT_EQ(dict.tailRows("b", 3).size(), 2u);
    EXPECT_EQ(dict.tailNumbers("d"), (std::vector<double>{0, 0, 0, 0, 0, 1, 3}));
    EXPECT_EQ(dict.leadingWord("e"), "smooth");
    EXPECT_THROW(dict.tailNumbers("e"), InputError);
    EXPECT_THROW(dict.tailRows("c", 2), InputError);
}

TEST(Dictionary, RefusesValuesAfterAList)
{
    const auto dict = Dictionary::parse("v (1 2 3) 4; r ((0 0)) ((1 1)); t table ((0 0)) 2;");

    EXPECT_THROW(dict.vector("v"), InputError);
    EXPECT_THROW(dict.rows("r", 2), InputError);
    EXPECT_THROW(dict.tailRows("t", 2), InputError);
}

TEST(Dictionary, OpensSubDictionaries)
{
    const auto dict = Dictionary::parse("pairs { a { friction 0.1; } }");

    EXPECT_EQ(dict.sub("pairs").sub("a").number("friction"), 0.1);
    EXPECT_EQ(dict.sub("pairs").sub("a").name(), "text, in pairs.a");
    EXPECT_TRUE(dict.subOrEmpty("absent").keys().empty());
    EXPECT_EQ(dict.subOrEmpty("absent").numberOr("x", 4), 4);
    EXPECT_THROW(dict.sub("absent"), InputError);
    EXPECT_THROW(dict.number("pairs"), InputError);
    EXPECT_TRUE(dict.isDictionary("pairs"));
    EXPECT_FALSE(dict.isDictionary("absent"));
}

TEST(Dictionary, OpensListsOfDictionaries)
{
    const auto blocks = Dictionary::parse("blocks ( { x 1; } named { x 2; } );").subList("blocks");

    ASSERT_EQ(blocks.size(), 2u);
    EXPECT_EQ(blocks[1].number("x"), 2);
    EXPECT_EQ(blocks[1].name(), "text, in blocks[1]");
}

TEST(Dictionary, OutlivesTheOneItCameFrom)
{
    const auto sub = Dictionary::parse("a { b { x 1; } }").sub("a").sub("b");

    EXPECT_EQ(sub.number("x"), 1);
}

TEST(Dictionary, NamesTheOpeningBraceWhereAKeyIsMissing)
{
    const auto dict = Dictionary::parse("a\n{\n    x 1;\n}\n");

    EXPECT_EQ(messageOf([&] { dict.sub("a").number("y"); }),
              "missing entry 'y'\n  --> text:2:1, in a\n   |\n 2 | {\n   | ^");
    EXPECT_EQ(messageOf([&] { dict.number("y"); }), "missing entry 'y'\n  --> text");
    EXPECT_TRUE(holds(messageOf([&] { dict.sub("a").subOrEmpty("b").number("y"); }),
                      "--> text:2:1, in a.b"));
}

TEST(Dictionary, PointsAtAnUnreadKeyThatMayBeTheMissingOne)
{
    const auto dict = Dictionary::parse("fricton 0.3;");

    EXPECT_TRUE(holds(messageOf([&] { dict.number("friction"); }),
                      "is 'fricton' at text:1:1 meant for it?"));
}

TEST(Dictionary, FailsAtTheValueOfAKey)
{
    const auto dict = Dictionary::parse("a 1; times (0 1);");

    EXPECT_EQ(messageOf([&] { dict.fail("times", "times must rise", "sort them"); }),
              "times must rise\n  --> text:1:12\n   |\n 1 | a 1; times (0 1);\n"
              "   |            ^^^^^\n   = sort them");
}

TEST(Dictionary, RefusesWhatNobodyRead)
{
    const auto dict = Dictionary::parse("friction 1; fricton 2;");
    dict.number("friction");

    EXPECT_TRUE(holds(messageOf([&] { dict.requireAllUsed(); }),
                      "unknown keyword 'fricton'\n  --> text:1:13\n"));
    EXPECT_TRUE(holds(messageOf([&] { dict.requireAllUsed(); }),
                      "did you mean 'friction'?  valid here: friction"));
}

TEST(Dictionary, RefusesWhatNobodyReadInOpenedDictionaries)
{
    const auto dict = Dictionary::parse("a { b { x 1; y 2; } } c ( { x 1; } );");
    dict.sub("a").sub("b").number("x");
    EXPECT_TRUE(holds(messageOf([&] { dict.requireAllUsed(); }), "unknown keyword 'y'"));
    dict.sub("a").sub("b").number("y");
    EXPECT_TRUE(holds(messageOf([&] { dict.requireAllUsed(); }), "unknown keyword 'c'"));
    const auto item = dict.subList("c").front();
    EXPECT_TRUE(holds(messageOf([&] { dict.requireAllUsed(); }), "unknown keyword 'x'"));
    item.number("x");

    EXPECT_NO_THROW(dict.requireAllUsed());
}

TEST(Dictionary, ListsAbsentKeysAsValidToo)
{
    const auto dict = Dictionary::parse("z 1;");
    dict.numberOr("safety", 1);
    dict.numberOr("safety", 1);
    dict.has("threads");

    EXPECT_TRUE(holds(messageOf([&] { dict.requireAllUsed(); }), "valid here: safety, threads"));
}

TEST(Dictionary, LeavesUserAndHeaderFree)
{
    const auto dict =
        Dictionary::parse("FoamFile { version 2.0; } user { anything { goes 1; } } a 1;");
    dict.number("a");

    EXPECT_NO_THROW(dict.requireAllUsed());
    EXPECT_EQ(dict.keys(), std::vector<std::string>{"a"});
    EXPECT_EQ(dict.keyPaths(), std::vector<std::string>{"a"});
}

TEST(Dictionary, ChecksUserBelowTheTop)
{
    const auto dict = Dictionary::parse("a { user { x 1; } }");
    dict.sub("a");

    EXPECT_THROW(dict.requireAllUsed(), InputError);
}

TEST(Dictionary, ListsKeysInFileOrder)
{
    const auto dict = Dictionary::parse("z 1; \"a+b\" 2; m { y 3; x { w 4; } }");

    EXPECT_EQ(dict.keys(), (std::vector<std::string>{"z", "a+b", "m"}));
    EXPECT_EQ(dict.keyPaths(), (std::vector<std::string>{"z", "a+b", "m.y", "m.x.w"}));
}

TEST(Dictionary, AcceptsAnEmptyText)
{
    const auto dict = Dictionary::parse("");

    EXPECT_TRUE(dict.keys().empty());
    EXPECT_NO_THROW(dict.requireAllUsed());
}

TEST(Range, SaysWhatItAllows)
{
    EXPECT_EQ(anyNumber().text(), "");
    EXPECT_EQ(positive().text(), "> 0");
    EXPECT_EQ(nonNegative().text(), ">= 0");
    EXPECT_EQ(between(0, 1).text(), "between 0 and 1");
    EXPECT_EQ((Range{-1, 0.5, true, true}).text(), "> -1 and < 0.5");
    EXPECT_FALSE((Range{-1, 0.5, true, true}).holds(0.5));
    EXPECT_TRUE(between(0, 1).holds(1));
}

} // namespace fpm
