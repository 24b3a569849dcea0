#include "dictionary/DictionaryText.h"

#include "dictionary/Dictionary.h"

#include <gtest/gtest.h>

#include <limits>

namespace fpm {
namespace {

TEST(DictionaryText, IsReadBackAsItWasWritten)
{
    const double third = 1.0 / 3;
    DictionaryText text("a record");
    text.string("name", "openmp, 2 threads").integer("steps", -3).number("third", third);
    text.number("short", third, 3).openList("rows");
    for (const char* name : {"a", "b"}) text.openItem().string("pair", name).closeItem();
    text.closeList().string("last", "");
    EXPECT_EQ(text.text().substr(0, 12), "// a record\n");
    const Dictionary read = Dictionary::parse(text.text());
    EXPECT_EQ(read.word("name"), "openmp, 2 threads");
    EXPECT_EQ(read.integer("steps", -9, 9), -3);
    EXPECT_EQ(read.number("third"), third);
    EXPECT_EQ(read.number("short"), 0.333);
    const std::vector<Dictionary> rows = read.subList("rows");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].word("pair") + rows[1].word("pair"), "ab");
    EXPECT_EQ(read.word("last"), "");
    EXPECT_NO_THROW(read.requireAllUsed());
}

TEST(DictionaryText, WritesNothingThatIsNotRead)
{
    DictionaryText text("a record");
    text.number("nan", std::numeric_limits<double>::quiet_NaN());
    text.number("infinite", -std::numeric_limits<double>::infinity());
    text.number("large", 1e200).number("none", std::nullopt).number("small", 1e-200);
    text.string("path", "a \"quoted\" \\ word\nand line");
    const Dictionary read = Dictionary::parse(text.text());
    EXPECT_EQ(read.keys(), (std::vector<std::string>{"small", "path"}));
    EXPECT_EQ(read.number("small"), 0);
    EXPECT_EQ(read.word("path"), "a 'quoted'   word and line");
}

TEST(DictionaryText, HoldsAnEmptyList)
{
    DictionaryText text("a record");
    text.openList("rows").closeList();
    EXPECT_TRUE(Dictionary::parse(text.text()).subList("rows").empty());
}

} // namespace
} // namespace fpm
