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
    std::string colour = {};               ///< "#6b7280"; the next of the palette where empty
};

/// A point that is marked: a text beside it, a bar for its spread in x.
struct PlotMark {
    double x = 0, y = 0; ///< y not finite: x alone is known, stated on a line of its own at the top
    std::string text;
    std::size_t series = 0;       ///< whose colour it has
    bool hollow = false;          ///< a ring in place of a dot
    bool emphasised = false;      ///< a black circle around it
    double xLeast = 0, xMost = 0; ///< no bar where they are equal
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
    std::vector<PlotMark> marks = {}; ///< drawn last; texts keep clear of one another
};

/// The plot as an SVG file 720 pixels wide: legend above the axes, so that it never covers data;
/// Okabe-Ito colours; the first reference series in black.
std::string svgPlot(const Plot& plot);

/// Indices of the points worth drawing: of each run of points in one pixel column the lowest and
/// the highest, in their order. Coordinates are in pixels and finite.
std::vector<std::size_t> decimate(const std::vector<std::pair<double, double>>& pixels);

} // namespace fpm
