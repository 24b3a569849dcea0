#include "probe/Ticks.h"

#include <gtest/gtest.h>

using namespace fpm;
using Labels = std::vector<std::string>;

TEST(Ticks, StepIsOneTwoOrFiveTimesAPowerOfTen)
{
    EXPECT_DOUBLE_EQ(niceStep(10, 10), 1);
    EXPECT_DOUBLE_EQ(niceStep(0.4, 8), 0.05);
    EXPECT_DOUBLE_EQ(niceStep(1700, 8), 200);
}

TEST(Ticks, LieInsideTheAxisAtWholeMultiples)
{
    const Ticks ticks = linearTicks(-1.1, 1.1, 5);

    EXPECT_EQ(ticks.labels, (Labels{"−1.0", "−0.5", "0.0", "0.5", "1.0"}));
    EXPECT_EQ(ticks.exponent, 0);
    EXPECT_EQ(ticks.values[2], 0.0);
}

TEST(Ticks, ShareAnEngineeringExponentWhereNumbersAreSmallOrLarge)
{
    const Ticks small = linearTicks(0, 4e-4, 4), large = linearTicks(0, 3e5, 3);

    EXPECT_EQ(small.exponent, -6);
    EXPECT_EQ(small.labels, (Labels{"0", "100", "200", "300", "400"}));
    EXPECT_EQ(large.exponent, 3);
    EXPECT_EQ(large.labels.back(), "300");
    EXPECT_EQ(timesPowerOfTen(-6), "×10⁻⁶");
    EXPECT_EQ(timesPowerOfTen(0), "");
}

TEST(Ticks, OfALogarithmicAxisArePowersOfTen)
{
    const Ticks wide = decadeTicks(1e-7, 1e-2), narrow = decadeTicks(0.01, 0.2);

    EXPECT_EQ(wide.labels, (Labels{"10⁻⁷", "10⁻⁶", "10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²"}));
    EXPECT_EQ(narrow.labels, (Labels{"0.01", "0.02", "0.05", "0.1", "0.2"}));
    EXPECT_FALSE(wide.minor.empty());
}

TEST(Ticks, EndOnAnAxisWhoseSpanIsLostInRounding)
{
    EXPECT_LE(linearTicks(1e16, 1e16 + 4, 8).values.size(), 101u);
}

TEST(Ticks, OfAFractionOfADecadeAreEven)
{
    const Ticks ticks = decadeTicks(3.5, 5.5);

    EXPECT_EQ(ticks.labels, (std::vector<std::string>{"3.5", "4.0", "4.5", "5.0", "5.5"}));
}
