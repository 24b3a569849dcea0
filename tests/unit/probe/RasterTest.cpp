#include "probe/Raster.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace fpm;

namespace {

constexpr Colour white{255, 255, 255};

Colour byValue(double value)
{
    return {std::uint8_t(std::lround(value)), 0, 0};
}

/// Two triangles that fill the square of `size` samples at a depth, with one value.
void fillSquare(
    Raster& raster, double size, double depth, double value, const RasterEdge& edge = {})
{
    const RasterCorner a{0, 0, depth, value, 1}, b{size, 0, depth, value, 1};
    const RasterCorner c{size, size, depth, value, 1}, d{0, size, depth, value, 1};
    raster.triangle(a, b, c, edge);
    raster.triangle(a, c, d, {});
}

} // namespace

TEST(Raster, LeavesNoHoleOnTheCommonSideOfTwoTriangles)
{
    Raster raster(64, 64, 1);

    fillSquare(raster, 64, 0, 100);

    for (const Colour& pixel : raster.image(byValue).pixels) ASSERT_NEAR(pixel[0], 100, 1);
}

TEST(Raster, ShowsWhatIsNearerWhateverTheOrder)
{
    for (const bool nearFirst : {true, false}) {
        Raster raster(4, 4, 2);
        fillSquare(raster, 8, nearFirst ? 2 : 1, nearFirst ? 200 : 50);
        fillSquare(raster, 8, nearFirst ? 1 : 2, nearFirst ? 50 : 200);
        EXPECT_NEAR(raster.image(byValue).pixels[5][0], 200, 1);
    }
}

TEST(Raster, BlendsTheBorderOverTheSamplesOfAPixel)
{
    Raster raster(2, 1, 2);

    raster.triangle({0, 0, 0, 0, 1}, {3, 0, 0, 0, 1}, {3, 3, 0, 0, 1}, {});
    raster.triangle({0, 0, 0, 0, 1}, {3, 3, 0, 0, 1}, {0, 3, 0, 0, 1}, {});
    const Image image = raster.image(byValue);

    EXPECT_EQ(image.pixels[0], (Colour{0, 0, 0}));
    EXPECT_EQ(image.pixels[1][0], 128); // half its samples lie outside, on white
}

TEST(Raster, DarkensSamplesAlongTheMarkedSide)
{
    Raster raster(16, 16, 1);

    fillSquare(raster, 16, 0, 200, {1, 1});
    const Image image = raster.image(byValue);

    EXPECT_LT(image.pixels[8][0], 60); // first row: the side y = 0
    EXPECT_NEAR(image.pixels[16 * 12 + 8][0], 200, 1);
}

TEST(Raster, PassesOverTrianglesWithoutAreaAndClipsAtThePicture)
{
    Raster raster(4, 4, 1);

    raster.triangle({0, 0, 0, 9, 1}, {4, 4, 0, 9, 1}, {2, 2, 0, 9, 1}, {});
    EXPECT_EQ(raster.image(byValue).pixels[5], white);
    fillSquare(raster, 1e7, 0, 9);

    EXPECT_EQ(raster.image(byValue).pixels[5], (Colour{9, 0, 0}));
}
