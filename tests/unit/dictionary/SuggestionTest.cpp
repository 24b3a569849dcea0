#include "dictionary/Suggestion.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fpm {

TEST(Suggestion, CountsEdits)
{
    EXPECT_EQ(editDistance("friction", "friction"), 0u);
    EXPECT_EQ(editDistance("fricton", "friction"), 1u);
    EXPECT_EQ(editDistance("firction", "friction"), 1u) << "a swap of neighbours is one edit";
    EXPECT_EQ(editDistance("", "abc"), 3u);
    EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
}

TEST(Suggestion, FindsTheNearestName)
{
    EXPECT_EQ(nearest("fricton", {"contactor", "friction", "fraction"}), "friction");
    EXPECT_EQ(nearest("backand", {"backend"}), "backend");
}

TEST(Suggestion, OffersNothingFarAway)
{
    EXPECT_EQ(nearest("colour", {"friction", "contactor"}), std::nullopt);
    EXPECT_EQ(nearest("type", {"tpey"}), std::nullopt) << "two edits are too many in four letters";
    EXPECT_EQ(nearest("ab", {"ac"}), std::nullopt);
    EXPECT_EQ(nearest("abc", {}), std::nullopt);
}

TEST(Suggestion, PrefersTheFirstOfEquals)
{
    EXPECT_EQ(nearest("xMon", {"xMin", "xMan"}), "xMin");
}

TEST(Suggestion, ListsWhatIsValid)
{
    EXPECT_EQ(suggestion("tipe", {"type", "set"}), "did you mean 'type'?  valid here: type, set");
    EXPECT_EQ(suggestion("colour", {"type"}), "valid here: type");
    EXPECT_EQ(suggestion("colour", {}), "");
}

TEST(Suggestion, CutsALongList)
{
    const auto text = listed(std::vector<std::string>(100, "key"));

    EXPECT_TRUE(text.ends_with(", key, ..."));
    EXPECT_EQ(std::count(text.begin(), text.end(), 'k'), 48);
}

} // namespace fpm
