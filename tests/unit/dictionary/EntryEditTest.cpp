#include "dictionary/EntryEdit.h"

#include "dictionary/Dictionary.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

using namespace fpm;

namespace {

class EntryEditTest : public testing::Test
{
protected:
    void write(const std::string& text, const std::string& name = "dict") const
    {
        test::writeBytes(folder_ / name, text);
    }
    EntryEdit set(const std::string& path, const std::string& value) const
    {
        return setEntry(folder_ / "dict", folder_.path(), path, value);
    }
    std::string refusal(const std::string& path) const
    {
        try {
            set(path, "1");
        } catch (const InputError& error) {
            return error.what();
        }
        return "nothing";
    }
    std::string existing(const std::string& path) const
    {
        return existingPath(folder_ / "dict", folder_.path(), path);
    }
    test::TemporaryFolder folder_;
};

} // namespace

TEST_F(EntryEditTest, ReplacesTheValuesWhereTheyStand)
{
    write("a 1; // keep\nb { c (1\n 2 3); }\nd;\n");

    EXPECT_EQ(set("a", "2").text, "a 2; // keep\nb { c (1\n 2 3); }\nd;\n");
    EXPECT_EQ(set("b.c", "(4 5)").text, "a 1; // keep\nb { c (4 5); }\nd;\n");
    EXPECT_EQ(set("d", "yes").text, "a 1; // keep\nb { c (1\n 2 3); }\nd yes;\n");
    EXPECT_EQ(set("a", "2").file, "dict");
}

TEST_F(EntryEditTest, AddsWhatIsAbsentWithoutMovingALine)
{
    write("a 1;\nb // this one\n{ // that one\n    c 2;\n}\n");

    EXPECT_EQ(set("b.e", "5").text, "a 1;\nb // this one\n{ e 5; // that one\n    c 2;\n}\n");
    EXPECT_EQ(set("x.y.z", "5").text,
              "a 1;\nb // this one\n{ // that one\n    c 2;\n}\n\nx { y { z 5; } }\n");
    const auto read = Dictionary::parse(set("x.y.z", "5").text);
    EXPECT_EQ(read.sub("x").sub("y").number("z"), 5);
}

TEST_F(EntryEditTest, ReplacesAMacroByTheValue)
{
    write("n 3;\na $n;\nb $n;\n");

    const auto read = Dictionary::parse(set("a", "4").text);
    EXPECT_EQ(read.number("a"), 4);
    EXPECT_EQ(read.number("b"), 3);
    EXPECT_EQ(Dictionary::parse(set("n", "7").text).number("b"), 7);
}

TEST_F(EntryEditTest, EditsTheIncludedFileWhereTheEntryStandsThere)
{
    write("#include \"other\"\na 1;\n");
    write("b { c 2; }\n", "other");

    const auto edit = set("b.c", "3");

    EXPECT_EQ(edit.file, "other");
    EXPECT_EQ(edit.text, "b { c 3; }\n");
    EXPECT_EQ(set("b.d", "4").file, "other");
}

TEST_F(EntryEditTest, FindsKeywordsWithDots)
{
    write("pairs { rod.1 { friction 0.1; } rod { x 1; } }");

    EXPECT_EQ(set("pairs.rod.1.friction", "0.2").text,
              "pairs { rod.1 { friction 0.2; } rod { x 1; } }");
}

TEST_F(EntryEditTest, RefusesWhatIsNoEntry)
{
    write("a 1;\nb { c 2; }\n");

    EXPECT_NE(refusal("b").find("'b' is a dictionary"), std::string::npos) << refusal("b");
    EXPECT_NE(refusal("a.x").find("'a' is no dictionary"), std::string::npos) << refusal("a.x");
    EXPECT_NE(refusal("a.x").find("dict:1:1"), std::string::npos);
}

TEST_F(EntryEditTest, TellsHowFarAPathLeads)
{
    write("a 1;\nb { c { d 2; } }\n");

    EXPECT_EQ(existing("b.c.d"), "b.c.d");
    EXPECT_EQ(existing("b.c.x.y"), "b.c");
    EXPECT_EQ(existing("q.c"), "");
}

TEST(DictionaryTexts, ItemsKeepInnerListsWhole)
{
    const auto read = Dictionary::parse("a (1 mixed (2 (3 4)) \"x y\"); b 7;");

    EXPECT_EQ(read.items("a"), (std::vector<std::string>{"1", "mixed", "(2 (3 4))", "\"x y\""}));
    EXPECT_EQ(read.items("b"), std::vector<std::string>{"7"});
}

TEST(DictionaryTexts, CanonicalTextHoldsWhatIsSaidAndNotHow)
{
    const auto text = [](const char* dictionary) {
        return Dictionary::parse(dictionary).canonicalText();
    };

    EXPECT_EQ(text("a  1; // one\nb { c (1\n2); }"),
              text("user { n 1; } a $:user.n; b { c ( 1 2 ); }"));
    EXPECT_NE(text("a 1;"), text("a 2;"));
    EXPECT_NE(text("a { b 1; } c 2;"), text("a { b 1; c 2; }"));
    EXPECT_NE(text("a ({ b 1; });"), text("a ({ b 2; });"));
}

TEST_F(EntryEditTest, TakesAnEntryOutAndLeavesANote)
{
    write("pairs\n{\n    a { friction { static 1; } /* } */ }  // first\n    b { target x; };\n"
          "    c ((0 0) (1 1)); d 1;\n}\n");
    const auto removed = [&](const std::string& path) {
        const auto edit = removeEntry(folder_ / "dict", folder_.path(), path, "gone");
        write(edit.text);
        return edit.text;
    };
    EXPECT_EQ(removed("pairs.a"), "pairs\n{\n    /* gone */  // first\n    b { target x; };\n"
                                  "    c ((0 0) (1 1)); d 1;\n}\n");
    EXPECT_EQ(removed("pairs.b"), "pairs\n{\n    /* gone */  // first\n    /* gone */\n"
                                  "    c ((0 0) (1 1)); d 1;\n}\n");
    EXPECT_EQ(removed("pairs.c"), "pairs\n{\n    /* gone */  // first\n    /* gone */\n"
                                  "    /* gone */ d 1;\n}\n");
    EXPECT_THROW(removed("pairs.e"), InputError);
}
