#include "probe/PictureSheet.h"

#include "base/Format.h"
#include "probe/Png.h"
#include "probe/Svg.h"
#include "probe/Ticks.h"

#include <algorithm>
#include <cmath>

namespace fpm {

namespace {

constexpr double marginLeft = 20, headHeight = 66, sideWidth = 168, footerHeight = 16;
constexpr double barWidth = 20, triadSize = 34, triadHeight = 104;
constexpr const char* dark = "#111827";

void drawBar(SvgDrawing& svg, Pixel at, double height, const ColourScale& scale)
{
    const int steps = scale.bands > 0 ? scale.bands : 128;
    for (int step = 0; step < steps; ++step) {
        const double value = scale.lower + (step + 0.5) / steps * (scale.upper - scale.lower);
        const double top = at.y + height * (1 - double(step + 1) / steps);
        // a hair of overlap hides the seams between neighbours
        svg.rectangle({at.x, top}, barWidth, height / steps + (step > 0 ? 0.4 : 0),
                      "fill=\"" + hexText(scale.colour(value)) + "\"");
    }
    svg.rectangle(at, barWidth, height, "fill=\"none\" stroke=\"#374151\" stroke-width=\"0.8\"");
}

/// A true minus, as wide as the digits, for the hyphen of a number.
std::string numberText(double value)
{
    std::string text = toText(value, 4);
    for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos; at += 3)
        text.replace(at, 1, "\u2212");
    return text;
}

/// Limits of the bands, thinned until their labels have room.
Ticks barTicks(const ColourScale& scale, double height)
{
    if (scale.bands == 0) return linearTicks(scale.lower, scale.upper, int(height / 40));
    const int room = std::max(1, int(height / 17));
    int stride = 1;
    while ((scale.bands + stride - 1) / stride > room || scale.bands % stride != 0) ++stride;
    const double step = (scale.upper - scale.lower) / scale.bands;
    std::vector<double> values;
    for (int band = 0; band <= scale.bands; band += stride)
        values.push_back(band == scale.bands ? scale.upper : scale.lower + band * step);
    // limits like 0, 1/12, 2/12 have no end: three significant digits of the step will do
    const double digit = std::pow(10.0, std::floor(std::log10(step)) - 2);
    return labelled(std::move(values), std::round(stride * step / digit) * digit);
}

void drawScale(SvgDrawing& svg, Pixel at, double height, const PictureNotes& notes)
{
    const ColourScale& scale = notes.scale;
    svg.text({at.x, at.y - 14}, notes.quantity, {13, Anchor::start, dark, true});
    drawBar(svg, at, height, scale);
    const Ticks ticks = barTicks(scale, height);
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double y =
            at.y + height * (scale.upper - ticks.values[i]) / (scale.upper - scale.lower);
        svg.line({at.x + barWidth, y}, {at.x + barWidth + 4, y}, "stroke=\"#374151\"");
        svg.text({at.x + barWidth + 9, y + 4}, ticks.labels[i], {12});
    }
    svg.text({at.x + textWidth(notes.quantity, 14.5) + 6, at.y - 14},
             timesPowerOfTen(ticks.exponent), {12});
    svg.text({at.x, at.y + height + 24}, "max  " + numberText(notes.largest), {12});
    svg.text({at.x, at.y + height + 41}, "min  " + numberText(notes.smallest), {12});
}

void drawCategories(SvgDrawing& svg, Pixel at, const PictureNotes& notes)
{
    svg.text({at.x, at.y - 14}, notes.quantity, {13, Anchor::start, dark, true});
    double y = at.y;
    for (const auto& [name, colour] : notes.categories) {
        svg.rectangle({at.x, y}, 14, 14,
                      "fill=\"" + hexText(colour) + "\" stroke=\"#374151\" stroke-width=\"0.8\"");
        svg.text({at.x + 22, y + 11.5}, name, {12});
        y += 21;
    }
}

void drawTriad(SvgDrawing& svg, Pixel centre, const std::array<Point, 3>& axes)
{
    static constexpr std::array<const char*, 3> colours{"#c0392b", "#1e8449", "#1f5fa8"};
    static constexpr std::array<const char*, 3> names{"x", "y", "z"};
    std::array<std::size_t, 3> order{0, 1, 2}; // those pointing away first
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return axes[a][2] < axes[b][2]; });
    for (const std::size_t k : order) {
        const double right = axes[k][0], down = -axes[k][1], length = std::hypot(right, down);
        if (length < 0.08) continue; // seen end on
        const Pixel tip{centre.x + triadSize * right, centre.y + triadSize * down};
        const double ux = right / length, uy = down / length;
        const std::string colour = std::string("\"") + colours[k] + "\"";
        svg.line(centre, tip, "stroke=" + colour + " stroke-width=\"2\" stroke-linecap=\"round\"");
        const double head = std::min(7.0, triadSize * length);
        const auto corner = [&](double along, double across) {
            return svgNumber(tip.x + along * ux - across * uy) + ","
                   + svgNumber(tip.y + along * uy + across * ux) + " ";
        };
        svg.element("<polygon points=\"" + corner(4, 0) + corner(4 - head, 3.4)
                    + corner(4 - head, -3.4) + "\" fill=" + colour + "/>");
        svg.text({tip.x + 13 * ux, tip.y + 13 * uy + 4}, names[k],
                 {13, Anchor::middle, colours[k], true});
    }
}

} // namespace

std::string pictureSheet(std::span<const std::uint8_t> png,
                         double width,
                         double height,
                         const PictureNotes& notes)
{
    const double pageWidth = marginLeft + width + sideWidth;
    SvgDrawing svg(pageWidth, headHeight + height + footerHeight,
                   notes.title + ", " + notes.subtitle);
    svg.text({marginLeft, 29}, notes.title, {17, Anchor::start, dark, true});
    svg.text({marginLeft, 50}, notes.subtitle, {13});
    svg.element("<image x=\"" + svgNumber(marginLeft) + "\" y=\"" + svgNumber(headHeight)
                + "\" width=\"" + svgNumber(width) + "\" height=\"" + svgNumber(height)
                + "\" href=\"data:image/png;base64," + base64(png) + "\"/>");
    const Pixel side{marginLeft + width + 30, headHeight};
    if (notes.categories.empty())
        drawScale(svg, side, std::clamp(height - triadHeight - 56, 120.0, 420.0), notes);
    else
        drawCategories(svg, side, notes);
    drawTriad(svg, {side.x + 48, headHeight + height - triadHeight / 2 + 6}, notes.axes);
    return svg.str();
}

} // namespace fpm
