#include "base/Format.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fpm {

TEST(Format, ShortestTextReadsBackAsTheSameDouble)
{
    EXPECT_EQ(toText(0.1), "0.1");
    EXPECT_EQ(toText(1e-5), "1e-05");
    EXPECT_EQ(toText(5.0 / 3), "1.6666666666666667");
    EXPECT_EQ(toText(-0.0), "-0");
}

TEST(Format, HoldsTheLongestDouble)
{
    const auto text = toText(-std::numeric_limits<double>::denorm_min());

    EXPECT_EQ(text, "-5e-324");
    EXPECT_EQ(toText(-2.2250738585072014e-308), "-2.2250738585072014e-308");
}

TEST(Format, RoundsToTheSignificantDigitsAskedFor)
{
    EXPECT_EQ(toText(3.14159265, 3), "3.14");
    EXPECT_EQ(toText(1234567.0, 6), "1.23457e+06");
    EXPECT_EQ(toText(2.0, 6), "2");
    EXPECT_EQ(toText(0.1, 99), "0.10000000000000001");
    EXPECT_EQ(toText(0.16, 0), "0.2");
}

TEST(Format, NamesWhatIsNotANumber)
{
    EXPECT_EQ(toText(std::numeric_limits<double>::infinity(), 6), "inf");
    EXPECT_EQ(toText(std::nan("")), "nan");
}

TEST(Format, FillsTheBracesInOrder)
{
    EXPECT_EQ(format("{} nodes in part '{}'", 12, std::string("rod")), "12 nodes in part 'rod'");
    EXPECT_EQ(format("dt = {}", 1.0 / 3), "dt = 0.333333");
}

TEST(Format, DoesNotExpandBracesOfAValue)
{
    EXPECT_EQ(format("'{}' and '{}'", "{}", "b"), "'{}' and 'b'");
}

TEST(Format, LeavesBracesWithoutAValue)
{
    EXPECT_EQ(format("{} of {}", 1), "1 of {}");
    EXPECT_EQ(format("plain", 1), "plain");
}

} // namespace fpm
