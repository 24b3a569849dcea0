#include "stability/MapChart.h"

#include "base/Format.h"
#include "probe/Svg.h"
#include "stability/MapReport.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fpm {

namespace {

constexpr double width = 720, left = 84, right = 694, frameHeight = 380;
/// From harmless to lost; distinct in grey too.
constexpr std::array<const char*, outcomeCount> colours{"#cfe8d5", "#f6d776", "#c9b6e4", "#8ecae6",
                                                        "#3a6ea5", "#d98032", "#8f1d21"};

struct Frame {
    double top, bottom;
    const StabilityMap& map;
    std::size_t columns() const { return map.spec.x.values.size(); }
    std::size_t rows() const { return map.spec.y.values.size(); }
    double x(double column) const { return left + column * (right - left) / double(columns()); }
    double y(double row) const { return bottom - row * (bottom - top) / double(rows()); }

    double columnOf(double value) const { return cellOf(map.spec.x, value); }
    double rowOf(double value) const { return cellOf(map.spec.y, value); }

private:
    /// Where a value lies among the cells of an axis, whose centres are its values.
    static double cellOf(const MapAxis& axis, double value)
    {
        const std::vector<double>& v = axis.values;
        const auto place = [&](double at) { return axis.logarithmic ? std::log(at) : at; };
        if (v.size() < 2) return 0.5;
        std::size_t i = 0;
        while (i + 2 < v.size() && value > v[i + 1]) ++i;
        const double share = (place(value) - place(v[i])) / (place(v[i + 1]) - place(v[i]));
        return std::clamp(double(i) + share + 0.5, 0.0, double(v.size()));
    }
};

void drawCells(SvgDrawing& svg, const Frame& at)
{
    for (std::size_t k = 0; k < at.map.points.size(); ++k) {
        const double column = double(k % at.columns()), row = double(k / at.columns());
        const Pixel corner{at.x(column), at.y(row + 1)};
        const double w = at.x(column + 1) - corner.x, h = at.y(row) - corner.y;
        const auto& point = at.map.points[k];
        const std::string fill =
            point ? colours[std::size_t(int(point->result.outcome))] : "#f3f4f6";
        svg.rectangle(corner, w, h, "fill=\"" + fill + "\" stroke=\"#ffffff\"");
        if (point && point->predictedStable)
            svg.rectangle({corner.x + w / 2 - 2, corner.y + h / 2 - 2}, 4, 4, "fill=\"#374151\"");
    }
}

using BoundOf = double Bounds::*;

/// A bound of each row as a line of steps.
void drawBound(
    SvgDrawing& svg, const Frame& at, BoundOf bound, const char* colour, const char* dash)
{
    std::string points;
    for (std::size_t j = 0; j < at.rows(); ++j) {
        if (!at.map.rows[j] || !((*at.map.rows[j]).*bound > 0)) continue;
        const std::string x = svgNumber(at.x(at.columnOf((*at.map.rows[j]).*bound)));
        points += x + "," + svgNumber(at.y(double(j))) + " " + x + ","
                  + svgNumber(at.y(double(j) + 1)) + " ";
    }
    if (points.empty()) return;
    points.pop_back();
    svg.element("<polyline points=\"" + points + "\" fill=\"none\" stroke=\"" + colour
                + "\" stroke-width=\"2\" stroke-dasharray=\"" + dash + "\"/>");
}

/// Labels every so many values, so that they do not run into one another.
void drawAxes(SvgDrawing& svg, const Frame& at)
{
    const auto stride = [](std::size_t count, std::size_t most) {
        return (count + most - 1) / most;
    };
    const std::vector<double>&x = at.map.spec.x.values, &y = at.map.spec.y.values;
    for (std::size_t i = 0; i < x.size(); i += stride(x.size(), 12))
        svg.text({at.x(double(i) + 0.5), at.bottom + 18}, toText(x[i], 3), {12, Anchor::middle});
    for (std::size_t j = 0; j < y.size(); j += stride(y.size(), 16))
        svg.text({left - 8, at.y(double(j) + 0.5) + 4}, toText(y[j], 3), {12, Anchor::end});
    svg.text({(left + right) / 2, at.bottom + 42}, at.map.spec.x.parameter, {13, Anchor::middle});
    svg.text({20, (at.top + at.bottom) / 2}, at.map.spec.y.parameter,
             {13, Anchor::middle, "#374151", false, -90});
}

struct LegendLine {
    BoundOf bound;
    std::string label;
    const char *colour, *dash;
};

/// What fails below its line is not called a bound.
std::array<LegendLine, 3> boundLines(const StabilityMap& map)
{
    std::string contact = "bound from elements and contact";
    if (const auto onset = onsetOfContact(map); onset && !onset->isBound())
        contact = format("from elements and contact, fails at {} of it", toText(onset->least, 3));
    return {{{&Bounds::withContact, contact, "#111827", "none"},
             {&Bounds::quality, "omega_c dt = 0.8", "#111827", "6 4"},
             {&Bounds::eigenvalue, "largest eigenvalue", "#c2185b", "2 3"}}};
}

/// A ring with a dot in it, on any colour.
void drawOwn(SvgDrawing& svg, const Pixel& at)
{
    const std::string centre =
        format("<circle cx=\"{}\" cy=\"{}\" ", svgNumber(at.x), svgNumber(at.y));
    svg.element(centre + "r=\"7\" fill=\"#ffffff\" stroke=\"#111827\" stroke-width=\"2\"/>");
    svg.element(centre + "r=\"2.5\" fill=\"#111827\"/>");
}

/// Draws the legend and returns where it ends.
double drawLegend(SvgDrawing& svg, const StabilityMap& map, bool bounds)
{
    double x = left, y = 52;
    const auto place = [&](const std::string& label) {
        const double entry = 22 + textWidth(label, 12) + 18;
        if (x + entry > right + 10 && x > left) x = left, y += 20;
        const Pixel start{x, y};
        x += entry;
        svg.text({start.x + 20, start.y}, label, {12});
        return start;
    };
    for (int i = 0; i < outcomeCount; ++i) {
        const bool there = std::any_of(map.points.begin(), map.points.end(), [&](const auto& p) {
            return p && int(p->result.outcome) == i;
        });
        if (!there) continue;
        const Pixel at = place(nameOf(Outcome(i)));
        svg.rectangle({at.x, at.y - 11}, 14, 14,
                      "fill=\"" + std::string(colours[std::size_t(i)]) + "\" stroke=\"#9ca3af\"");
    }
    const Pixel dot = place("predicted stable");
    svg.rectangle({dot.x + 5, dot.y - 6}, 4, 4, "fill=\"#374151\"");
    if (map.own) {
        const Pixel at = place("this case");
        drawOwn(svg, {at.x + 7, at.y - 4});
    }
    for (const LegendLine& line : boundLines(map)) {
        const bool there = std::any_of(map.rows.begin(), map.rows.end(), [&](const auto& row) {
            return row && (*row).*line.bound > 0;
        });
        if (!bounds || !there) continue;
        const Pixel at = place(line.label);
        svg.line({at.x, at.y - 4}, {at.x + 16, at.y - 4},
                 format("stroke=\"{}\" stroke-width=\"2\" stroke-dasharray=\"{}\"", line.colour,
                        line.dash));
    }
    return y + 18;
}

} // namespace

std::string mapChart(const StabilityMap& map, const std::string& title)
{
    const bool bounds = map.spec.x.parameter == parameter::timeStep;
    SvgDrawing scratch(width, 100, "");
    const double top = drawLegend(scratch, map, bounds);
    const Frame frame{top, top + frameHeight, map};
    SvgDrawing svg(width, frame.bottom + 60, title);
    svg.text({left, 28}, title, {17, Anchor::start, "#111827", true});
    drawLegend(svg, map, bounds);
    drawCells(svg, frame);
    if (bounds)
        for (const LegendLine& line : boundLines(map))
            drawBound(svg, frame, line.bound, line.colour, line.dash);
    if (map.own)
        drawOwn(svg, {frame.x(frame.columnOf(map.own->x)), frame.y(frame.rowOf(map.own->y))});
    drawAxes(svg, frame);
    return svg.str();
}

} // namespace fpm
