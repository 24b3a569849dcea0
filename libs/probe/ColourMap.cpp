#include "probe/ColourMap.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

using Coefficients = std::array<std::array<double, 3>, 7>; ///< [power][channel]

// Least-squares polynomials: viridis (Smith and van der Walt 2015) as fitted by Zucker, turbo
// (Mikhailov 2019) with its author's fit.
constexpr Coefficients viridisFit{{{0.2777273272, 0.0054073445, 0.3340998053},
                                   {0.1050930431, 1.4046135299, 1.3845901626},
                                   {-0.3308618287, 0.2148475595, 0.0950951630},
                                   {-4.6342304990, -5.7991009734, -19.3324409563},
                                   {6.2282699363, 14.1799333668, 56.6905526007},
                                   {4.7763849977, -13.7451453777, -65.3530326334},
                                   {-5.4354558559, 4.6458526122, 26.3124352496}}};
constexpr Coefficients turboFit{{{0.13572138, 0.09140261, 0.10667330},
                                 {4.61539260, 2.19418839, 12.64194608},
                                 {-42.66032258, 4.84296658, -60.58204836},
                                 {132.13108234, -14.18503333, 110.36276771},
                                 {-152.94239396, 4.27729857, -89.90310912},
                                 {59.28637943, 2.82956604, 27.34824973},
                                 {0, 0, 0}}};

} // namespace

Colour paletteColour(Palette palette, double position)
{
    const Coefficients& fit = palette == Palette::viridis ? viridisFit : turboFit;
    const double t = std::clamp(position, 0.0, 1.0);
    Colour colour{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        double value = 0;
        for (std::size_t power = fit.size(); power-- > 0;) value = value * t + fit[power][channel];
        colour[channel] = std::uint8_t(std::lround(255 * std::clamp(value, 0.0, 1.0)));
    }
    return colour;
}

Colour ColourScale::colour(double value) const
{
    if (std::isnan(value)) return {160, 160, 160};
    double position = std::clamp((value - lower) / (upper - lower), 0.0, 1.0);
    if (bands > 0)
        position = bands == 1
                       ? 0.5
                       : std::min<double>(bands - 1, std::floor(position * bands)) / (bands - 1);
    // the outermost tenth of turbo is so dark that mesh lines vanish in it
    return paletteColour(palette, palette == Palette::turbo ? 0.06 + 0.88 * position : position);
}

ColourScale roundScale(double lower, double upper, Palette palette)
{
    ColourScale scale;
    scale.palette = palette;
    const double size = std::max(std::abs(lower), std::abs(upper));
    if (!(upper - lower > 1e-9 * size)) {
        const double half = size > 0 ? 0.1 * size : 0.5;
        lower -= half, upper += half;
    }
    const double raw = (upper - lower) / 12, power = std::pow(10.0, std::floor(std::log10(raw)));
    double step = 10 * power;
    for (const double digit : {8.0, 6.0, 5.0, 4.0, 3.0, 2.5, 2.0, 1.5, 1.0})
        if (digit * power >= raw * (1 - 1e-9)) step = digit * power;
    const double first = std::floor(lower / step + 1e-6), last = std::ceil(upper / step - 1e-6);
    scale.lower = first * step, scale.upper = last * step;
    scale.bands = std::max(1, int(last - first));
    return scale;
}

int roundBands(double lower, double upper)
{
    for (const int bands : {12, 10, 11, 13, 14, 9, 8, 15}) {
        const double step = (upper - lower) / bands;
        const double digits = step / std::pow(10.0, std::floor(std::log10(step)) - 1);
        if (std::abs(digits - std::round(digits)) < 1e-6 * digits) return bands;
    }
    return 12;
}

Colour categoryColour(std::size_t category)
{
    // Okabe and Ito 2008, lightened so that mesh lines stay visible
    static constexpr std::array<Colour, 8> colours{{{86, 160, 211},
                                                    {240, 178, 76},
                                                    {72, 184, 148},
                                                    {226, 128, 82},
                                                    {217, 153, 189},
                                                    {138, 200, 238},
                                                    {243, 233, 122},
                                                    {165, 170, 178}}};
    return colours[category % colours.size()];
}

std::string hexText(const Colour& colour)
{
    static constexpr char digits[] = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t channel : colour) {
        text += digits[channel >> 4];
        text += digits[channel & 15];
    }
    return text;
}

} // namespace fpm
