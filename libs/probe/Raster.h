#pragma once

#include "probe/Png.h"

#include <functional>
#include <limits>
#include <vector>

namespace fpm {

/// A corner of a triangle: position in samples (not pixels), greater depth nearer the eye, value to
/// be coloured, light as a factor on the colour.
struct RasterCorner {
    double x, y, depth, value, light;
};

/// A line along the side a-b of a triangle, drawn inside the triangle.
struct RasterEdge {
    double halfWidth = 0; ///< in samples
    double strength = 0;  ///< 0 = none ... 1 = solid
};

/// Depth-buffered triangles at `supersampling` samples a pixel and direction. Colours are looked up
/// once, for the samples that stay visible.
class Raster
{
public:
    Raster(int width, int height, int supersampling);

    /// Parts outside the picture are clipped; corners must be finite.
    void triangle(const RasterCorner& a,
                  const RasterCorner& b,
                  const RasterCorner& c,
                  const RasterEdge& edge);
    /// Mean colour of the samples of each pixel, on white.
    Image image(const std::function<Colour(double)>& colourOf) const;

private:
    struct Sample {
        float depth = -std::numeric_limits<float>::infinity();
        float value = 0;
        std::uint8_t light = 0, edge = 0;
    };
    std::array<double, 3> shaded(const Sample& sample,
                                 const std::function<Colour(double)>& colourOf) const;

    int width_, height_, supersampling_;
    std::vector<Sample> samples_;
};

} // namespace fpm
