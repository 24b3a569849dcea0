#include "probe/ColourMap.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <set>

using namespace fpm;

namespace {

void expectNear(const Colour& colour, const Colour& expected, int tolerance)
{
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_LE(std::abs(int(colour[k]) - int(expected[k])), tolerance)
            << hexText(colour) << " against " << hexText(expected);
}

} // namespace

TEST(ColourMap, FollowsThePublishedTables)
{
    // entries 0, 127 and 255 of the tables by Smith and van der Walt, and of Mikhailov
    expectNear(paletteColour(Palette::viridis, 0), {68, 1, 84}, 4);
    expectNear(paletteColour(Palette::viridis, 0.5), {33, 145, 140}, 4);
    expectNear(paletteColour(Palette::viridis, 1), {253, 231, 37}, 4);
    expectNear(paletteColour(Palette::turbo, 0.5), {164, 252, 60}, 24);
}

TEST(ColourMap, HasAsManyColoursAsBands)
{
    const ColourScale scale{0, 300, 12, Palette::viridis};

    std::set<Colour> colours;
    for (int i = -10; i <= 310; ++i) colours.insert(scale.colour(i));

    EXPECT_EQ(colours.size(), 12u);
    EXPECT_EQ(scale.colour(24.9), scale.colour(-5));
    EXPECT_NE(scale.colour(24.9), scale.colour(25.1));
}

TEST(ColourMap, ShowsWhatIsNotANumberInGrey)
{
    EXPECT_EQ(ColourScale{}.colour(std::numeric_limits<double>::quiet_NaN()),
              (Colour{160, 160, 160}));
}

TEST(ColourMap, WidensLimitsToRoundSteps)
{
    const ColourScale scale = roundScale(23.6, 286.8, Palette::turbo);

    EXPECT_DOUBLE_EQ(scale.lower, 0);
    EXPECT_DOUBLE_EQ(scale.upper, 300);
    EXPECT_EQ(scale.bands, 12);
}

TEST(ColourMap, GivesAConstantFieldAScaleAroundIt)
{
    for (const double value : {0.0, 5.0, -3e-9}) {
        const ColourScale scale = roundScale(value, value, Palette::turbo);
        EXPECT_LT(scale.lower, value);
        EXPECT_GT(scale.upper, value);
    }
}

TEST(ColourMap, ChoosesBandsThatMakeRoundLimits)
{
    EXPECT_EQ(roundBands(0, 300), 12);
    EXPECT_EQ(roundBands(-14, 0), 10);
    EXPECT_EQ(roundBands(0, 1), 10);
}
