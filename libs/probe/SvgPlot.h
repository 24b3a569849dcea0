#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fpm {

enum class SeriesStyle { line, dashed, points };

/// A curve of a plot: y over x, in the units of the axes.
struct PlotSeries {
    std::string label;
    std::vector<double> x, y;              ///< same length; gaps where either is not finite
    SeriesStyle style = SeriesStyle::line; ///< dashed and points mark reference data
};

struct PlotAxis {
    std::string label;
    std::optional<std::array<double, 2>> range; ///< from the data when absent
    bool logarithmic = false;                   ///< values <= 0 are left out
};

struct Plot {
    std::string title;
    PlotAxis x, y;
    std::vector<PlotSeries> series;
};

/// The plot as an SVG file 720 pixels wide: legend above the axes, so that it never covers data;
/// Okabe-Ito colours; the first reference series in black.
std::string svgPlot(const Plot& plot);

/// Indices of the points worth drawing: of each run of points in one pixel column the lowest and
/// the highest, in their order. Coordinates are in pixels and finite.
std::vector<std::size_t> decimate(const std::vector<std::pair<double, double>>& pixels);

} // namespace fpm
