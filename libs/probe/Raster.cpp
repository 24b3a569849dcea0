#include "probe/Raster.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

constexpr std::array<double, 3> edgeColour{24, 28, 38};
constexpr double brightest = 1.2; ///< light factor that a stored byte of 255 stands for

std::uint8_t toByte(double value)
{
    return std::uint8_t(255 * std::clamp(value, 0.0, 1.0) + 0.5);
}

/// An affine function over the picture: value at (0, 0) and its slopes.
struct Affine {
    double origin, dx, dy;
    double at(double x, double y) const { return origin + dx * x + dy * y; }
};

/// The barycentric weight that is 1 at `corner` and 0 on the side from `p` to `q`.
Affine weightOf(const RasterCorner& corner, const RasterCorner& p, const RasterCorner& q)
{
    const double area = (q.x - p.x) * (corner.y - p.y) - (q.y - p.y) * (corner.x - p.x);
    const double dx = -(q.y - p.y) / area, dy = (q.x - p.x) / area;
    return {-dx * p.x - dy * p.y, dx, dy};
}

Affine blend(const Affine& a, const Affine& b, const Affine& c, double atA, double atB, double atC)
{
    return {a.origin * atA + b.origin * atB + c.origin * atC, a.dx * atA + b.dx * atB + c.dx * atC,
            a.dy * atA + b.dy * atB + c.dy * atC};
}

} // namespace

Raster::Raster(int width, int height, int supersampling)
    : width_(width * supersampling),
      height_(height * supersampling),
      supersampling_(supersampling),
      samples_(std::size_t(width_) * std::size_t(height_))
{
}

void Raster::triangle(const RasterCorner& a,
                      const RasterCorner& b,
                      const RasterCorner& c,
                      const RasterEdge& edge)
{
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (!(std::abs(area) > 1e-12)) return;
    const auto first = [](double low, int limit) {
        return int(std::clamp(std::ceil(low - 0.5), 0.0, double(limit)));
    };
    const int left = first(std::min({a.x, b.x, c.x}), width_);
    const int right = first(std::max({a.x, b.x, c.x}) + 1, width_);
    const int top = first(std::min({a.y, b.y, c.y}), height_);
    const int bottom = first(std::max({a.y, b.y, c.y}) + 1, height_);

    const Affine wa = weightOf(a, b, c), wb = weightOf(b, c, a), wc = weightOf(c, a, b);
    const Affine depth = blend(wa, wb, wc, a.depth, b.depth, c.depth);
    const Affine value = blend(wa, wb, wc, a.value, b.value, c.value);
    const Affine light = blend(wa, wb, wc, a.light, b.light, c.light);
    const double heightOfC = std::abs(area) / std::hypot(b.x - a.x, b.y - a.y);
    const double edgeWeight = edge.strength > 0 ? edge.halfWidth / heightOfC : -1;
    const std::uint8_t edgeByte = toByte(edge.strength);
    constexpr double inside = -1e-9; // both neighbours may claim a sample on their common side

    for (int row = top; row < bottom; ++row) {
        Sample* samples = &samples_[std::size_t(row) * std::size_t(width_)];
        const double y = row + 0.5;
        for (int column = left; column < right; ++column) {
            const double x = column + 0.5;
            const double weightC = wc.at(x, y);
            if (wa.at(x, y) < inside || wb.at(x, y) < inside || weightC < inside) continue;
            Sample& sample = samples[column];
            const float near = float(depth.at(x, y));
            if (near <= sample.depth) continue;
            sample.depth = near;
            sample.value = float(value.at(x, y));
            sample.light = toByte(light.at(x, y) / brightest);
            sample.edge = weightC < edgeWeight ? edgeByte : std::uint8_t(0);
        }
    }
}

std::array<double, 3> Raster::shaded(const Sample& sample,
                                     const std::function<Colour(double)>& colourOf) const
{
    if (sample.depth == -std::numeric_limits<float>::infinity()) return {255, 255, 255};
    const Colour colour = colourOf(double(sample.value));
    const double light = sample.light * brightest / 255, line = sample.edge / 255.0;
    std::array<double, 3> result{};
    for (std::size_t k = 0; k < 3; ++k)
        result[k] = (1 - line) * std::min(255.0, colour[k] * light) + line * edgeColour[k];
    return result;
}

Image Raster::image(const std::function<Colour(double)>& colourOf) const
{
    Image image{width_ / supersampling_, height_ / supersampling_, {}};
    image.pixels.reserve(std::size_t(image.width) * std::size_t(image.height));
    const double share = 1.0 / (supersampling_ * supersampling_);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            std::array<double, 3> sum{};
            for (int i = 0; i < supersampling_ * supersampling_; ++i) {
                const int row = y * supersampling_ + i / supersampling_;
                const int column = x * supersampling_ + i % supersampling_;
                const auto colour =
                    shaded(samples_[std::size_t(row) * std::size_t(width_) + std::size_t(column)],
                           colourOf);
                for (std::size_t k = 0; k < 3; ++k) sum[k] += share * colour[k];
            }
            Colour pixel{};
            for (std::size_t k = 0; k < 3; ++k) pixel[k] = std::uint8_t(sum[k] + 0.5);
            image.pixels.push_back(pixel);
        }
    }
    return image;
}

} // namespace fpm
