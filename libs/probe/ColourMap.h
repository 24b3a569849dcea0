#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace fpm {

using Colour = std::array<std::uint8_t, 3>; ///< red, green, blue in sRGB

enum class Palette {
    viridis, ///< perceptually uniform, reads in grey and for every kind of colour vision
    turbo    ///< rainbow without false edges: more hues, for fields with much detail
};

/// Colour at `position` in 0..1 (clamped).
Colour paletteColour(Palette palette, double position);

/// Colours of numbers between two limits, in `bands` steps or smooth.
struct ColourScale {
    double lower = 0, upper = 1;
    int bands = 12; ///< 0 = smooth
    Palette palette = Palette::turbo;

    /// Values outside the limits take the end colours; NaN is grey.
    Colour colour(double value) const;
};

/// Widens [lower, upper] to round limits and picks 8 to 13 bands of a round step.
ColourScale roundScale(double lower, double upper, Palette palette);
/// Number of bands, near 12, whose limits between the given ends have two significant digits.
int roundBands(double lower, double upper);
/// Colour of a category (a part), distinct for the first eight.
Colour categoryColour(std::size_t category);
/// "#1f77b4".
std::string hexText(const Colour& colour);

} // namespace fpm
