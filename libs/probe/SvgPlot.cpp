#include "probe/SvgPlot.h"

#include "probe/PlotMarks.h"
#include "probe/Svg.h"
#include "probe/Ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpm {

namespace {

constexpr double width = 720, frameHeight = 340;
constexpr double tickSize = 12, labelSize = 13, legendSize = 12.5, titleSize = 17;
constexpr std::size_t sparse = 12; ///< a line through so few points shows them as dots
constexpr const char* ink = "#374151";

// Okabe and Ito 2008; black is kept for reference data. Brown and violet of ColorBrewer follow, and
// an olive; yellow, weak on white, comes last.
constexpr std::array<const char*, 10> palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                              "#E69F00", "#56B4E9", "#8C510A", "#7B3294",
                                              "#8A9A00", "#F0E442"};
constexpr const char* referenceColour = "#1f2937";

struct Look {
    std::string colour;
    int marker = 0;
};

/// An axis laid out: data bounds, pixels of the bounds, ticks.
struct Scale {
    double lower = 0, upper = 1, from = 0, to = 1;
    bool logarithmic = false;
    Ticks ticks;

    double pixel(double value) const
    {
        const double position = logarithmic ? std::log(value / lower) / std::log(upper / lower)
                                            : (value - lower) / (upper - lower);
        // far outside the frame only the direction matters; huge numbers upset viewers
        return std::clamp(from + position * (to - from), -2e4, 2e4);
    }
    bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }
};

/// Where everything goes, in pixels.
struct Layout {
    double left, right, top, bottom, height;
    std::vector<Pixel> legend; ///< start of each entry
};

using Values = std::vector<double> PlotSeries::*;

/// Lines on top for marks whose y is not known.
void makeRoom(const Plot& plot, Scale& scale)
{
    const auto count = std::count_if(plot.marks.begin(), plot.marks.end(),
                                     [](const PlotMark& mark) { return !std::isfinite(mark.y); });
    const double share = std::min(0.5, double(count) * unknownLine / frameHeight);
    if (scale.logarithmic)
        scale.upper *= std::pow(scale.upper / scale.lower, share / (1 - share));
    else
        scale.upper += (scale.upper - scale.lower) * share / (1 - share);
}

Scale makeScale(const Plot& plot, const PlotAxis& axis, Values values, double padding, int count)
{
    Scale scale;
    scale.logarithmic = axis.logarithmic;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto include = [&](double value) {
        if (scale.shows(value)) low = std::min(low, value), high = std::max(high, value);
    };
    for (const PlotSeries& series : plot.series)
        for (const double value : series.*values) include(value);
    for (const PlotMark& mark : plot.marks) {
        include(values == &PlotSeries::x ? mark.x : mark.y);
        if (values == &PlotSeries::x && mark.xLeast < mark.xMost)
            include(mark.xLeast), include(mark.xMost);
    }
    if (low > high) low = axis.logarithmic ? 0.1 : 0, high = 1;
    if (axis.logarithmic) {
        const double grow = std::max(std::pow(high / low, padding), 1.15);
        scale.lower = low / grow, scale.upper = high * grow;
    } else {
        if (!(high - low > 1e-12 * std::max(std::abs(low), std::abs(high)))) {
            const double half = low == 0 ? 1 : 0.1 * std::abs(low);
            low -= half, high += half;
        }
        const double pad = padding * (high - low);
        // an axis that starts or ends at zero keeps doing so
        scale.lower = low >= 0 && low <= pad ? 0 : low - pad;
        scale.upper = high <= 0 && high >= -pad ? 0 : high + pad;
    }
    if (values == &PlotSeries::y) makeRoom(plot, scale);
    if (axis.range) scale.lower = (*axis.range)[0], scale.upper = (*axis.range)[1];
    scale.ticks = axis.logarithmic ? decadeTicks(scale.lower, scale.upper)
                                   : linearTicks(scale.lower, scale.upper, count);
    return scale;
}

std::vector<Look> makeLooks(const Plot& plot)
{
    std::vector<Look> looks;
    std::size_t colours = 0;
    int markers = 0;
    bool blackTaken = false;
    for (const PlotSeries& series : plot.series) {
        Look look;
        if (series.style == SeriesStyle::points) look.marker = markers++ % 4;
        if (!series.colour.empty())
            look.colour = series.colour;
        else if (series.style != SeriesStyle::line && !blackTaken)
            look.colour = referenceColour, blackTaken = true;
        else
            look.colour = palette[colours++ % palette.size()];
        looks.push_back(look);
    }
    return looks;
}

Layout makeLayout(const Plot& plot, const Scale& yScale)
{
    Layout layout{};
    double widest = 0;
    for (const std::string& label : yScale.ticks.labels)
        widest = std::max(widest, textWidth(label, tickSize));
    layout.left = std::max(52.0, widest + (plot.y.label.empty() ? 22 : 44));
    layout.right = width - 26;
    double y = plot.title.empty() ? 14 : 40;
    double x = layout.left;
    bool any = false;
    for (const PlotSeries& series : plot.series) {
        const double entry = 34 + textWidth(series.label, legendSize) + 20;
        if (any && x + entry > layout.right + 20) x = layout.left, y += 20;
        layout.legend.push_back({x, y + 8});
        x += entry;
        any = true;
    }
    if (any) y += 24;
    layout.top = y + (yScale.ticks.exponent != 0 ? 20 : 8);
    layout.bottom = layout.top + frameHeight;
    const bool below = !plot.x.label.empty();
    layout.height = layout.bottom + (below ? 56 : 34);
    return layout;
}

void drawAxes(SvgDrawing& svg, const Plot& plot, const Layout& at, const Scale& x, const Scale& y)
{
    const auto grid = [&](double value, const Scale& scale, bool vertical, const char* colour) {
        const double p = scale.pixel(value);
        svg.line(vertical ? Pixel{p, at.top} : Pixel{at.left, p},
                 vertical ? Pixel{p, at.bottom} : Pixel{at.right, p},
                 std::string("stroke=\"") + colour + "\"");
    };
    for (const double value : x.ticks.minor) grid(value, x, true, "#f3f4f6");
    for (const double value : y.ticks.minor) grid(value, y, false, "#f3f4f6");
    for (const double value : x.ticks.values) grid(value, x, true, "#eceef1");
    for (const double value : y.ticks.values)
        grid(value, y, false, value == 0 && y.lower < 0 ? "#9ca3af" : "#e3e6ea");

    const std::string stroke = std::string("stroke=\"") + ink + "\"";
    svg.line({at.left, at.bottom}, {at.right, at.bottom}, stroke);
    svg.line({at.left, at.top}, {at.left, at.bottom}, stroke);
    for (std::size_t i = 0; i < x.ticks.values.size(); ++i) {
        const double p = x.pixel(x.ticks.values[i]);
        svg.line({p, at.bottom}, {p, at.bottom + 5}, stroke);
        svg.text({p, at.bottom + 19}, x.ticks.labels[i], {tickSize, Anchor::middle});
    }
    for (std::size_t i = 0; i < y.ticks.values.size(); ++i) {
        const double p = y.pixel(y.ticks.values[i]);
        svg.line({at.left - 5, p}, {at.left, p}, stroke);
        svg.text({at.left - 9, p + 4}, y.ticks.labels[i], {tickSize, Anchor::end});
    }
    const double centre = (at.left + at.right) / 2, middle = (at.top + at.bottom) / 2;
    svg.text({centre, at.bottom + 43}, plot.x.label, {labelSize, Anchor::middle});
    svg.text({20, middle}, plot.y.label, {labelSize, Anchor::middle, ink, false, -90});
    svg.text({at.right, at.bottom + 37}, timesPowerOfTen(x.ticks.exponent),
             {tickSize, Anchor::end});
    svg.text({at.left - 5, at.top - 9}, timesPowerOfTen(y.ticks.exponent), {tickSize});
}

std::string markerXml(Pixel at, const Look& look)
{
    const auto point = [&](double dx, double dy) {
        return svgNumber(at.x + dx) + "," + svgNumber(at.y + dy) + " ";
    };
    const std::string end = "\"/>";
    if (look.marker == 0)
        return "<circle cx=\"" + svgNumber(at.x) + "\" cy=\"" + svgNumber(at.y) + "\" r=\"3.6"
               + end;
    if (look.marker == 1)
        return "<polygon points=\"" + point(-3.3, -3.3) + point(3.3, -3.3) + point(3.3, 3.3)
               + point(-3.3, 3.3) + end;
    if (look.marker == 2)
        return "<polygon points=\"" + point(0, -4.6) + point(4.6, 0) + point(0, 4.6)
               + point(-4.6, 0) + end;
    return "<polygon points=\"" + point(0, -4.3) + point(4.1, 3.1) + point(-4.1, 3.1) + end;
}

std::string dotXml(Pixel at, const Look& look)
{
    return "<circle cx=\"" + svgNumber(at.x) + "\" cy=\"" + svgNumber(at.y)
           + "\" r=\"3.2\" stroke=\"none\" fill=\"" + look.colour + "\"/>";
}

std::string strokeOf(const Look& look, SeriesStyle style)
{
    std::string text =
        "fill=\"none\" stroke=\"" + look.colour + "\" stroke-width=\"2\" stroke-linejoin=\"round\"";
    if (style == SeriesStyle::dashed) text += " stroke-dasharray=\"7 4\"";
    if (style == SeriesStyle::points)
        text = "fill=\"#ffffff\" fill-opacity=\"0.85\" stroke=\"" + look.colour
               + "\" stroke-width=\"1.5\"";
    return text;
}

void drawPolyline(SvgDrawing& svg, const std::vector<std::pair<double, double>>& pixels)
{
    if (pixels.empty()) return;
    std::string points;
    for (const std::size_t i : decimate(pixels))
        points += svgNumber(pixels[i].first) + "," + svgNumber(pixels[i].second) + " ";
    points.pop_back();
    svg.element("<polyline points=\"" + points + "\"/>");
}

void drawSeries(
    SvgDrawing& svg, const PlotSeries& series, const Look& look, const Scale& x, const Scale& y)
{
    svg.element("<g " + strokeOf(look, series.style) + ">");
    const std::size_t count = std::min(series.x.size(), series.y.size());
    // hundreds of markers would smear into a band: keep them a marker apart
    const double apart = series.style == SeriesStyle::points && count > 60 ? 9 : 0;
    const bool dots = series.style == SeriesStyle::line && count <= sparse;
    std::vector<std::pair<double, double>> run;
    Pixel last{-1e9, -1e9};
    for (std::size_t i = 0; i < count; ++i) {
        if (!x.shows(series.x[i]) || !y.shows(series.y[i])) {
            drawPolyline(svg, run);
            run.clear();
            continue;
        }
        const Pixel at{x.pixel(series.x[i]), y.pixel(series.y[i])};
        if (series.style != SeriesStyle::points) {
            run.emplace_back(at.x, at.y);
            if (dots) svg.element(dotXml(at, look));
        } else if (std::hypot(at.x - last.x, at.y - last.y) >= apart) {
            svg.element(markerXml(at, look));
            last = at;
        }
    }
    drawPolyline(svg, run);
    svg.element("</g>");
}

/// The lines of all series, as far as both ends of a piece are shown.
std::vector<Stroke> strokesOf(const Plot& plot, const Scale& x, const Scale& y)
{
    std::vector<Stroke> strokes;
    for (const PlotSeries& series : plot.series) {
        if (series.style == SeriesStyle::points) continue;
        const auto shown = [&](std::size_t i) {
            return x.shows(series.x[i]) && y.shows(series.y[i]);
        };
        const auto at = [&](std::size_t i) {
            return Pixel{x.pixel(series.x[i]), y.pixel(series.y[i])};
        };
        for (std::size_t i = 1; i < std::min(series.x.size(), series.y.size()); ++i)
            if (shown(i - 1) && shown(i)) strokes.push_back({at(i - 1), at(i)});
    }
    return strokes;
}

void drawPlotMarks(SvgDrawing& svg,
                   const Plot& plot,
                   const std::vector<Look>& looks,
                   const Layout& at,
                   const Scale& x,
                   const Scale& y)
{
    std::vector<PlacedMark> placed;
    for (const PlotMark& mark : plot.marks) {
        if (!x.shows(mark.x)) continue;
        PlacedMark one{mark, {x.pixel(mark.x), at.top + 12}, 0, 0, ""};
        if (y.shows(mark.y)) one.at.y = y.pixel(mark.y);
        one.barFrom = mark.xLeast < mark.xMost ? x.pixel(mark.xLeast) : one.at.x;
        one.barTo = mark.xLeast < mark.xMost ? x.pixel(mark.xMost) : one.at.x;
        one.colour = mark.series < looks.size() ? looks[mark.series].colour : ink;
        placed.push_back(one);
    }
    if (placed.empty()) return;
    drawMarks(svg, placed, strokesOf(plot, x, y), {at.left, at.top}, {at.right, at.bottom});
}

void drawLegend(SvgDrawing& svg, const Plot& plot, const std::vector<Look>& looks, const Layout& at)
{
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const PlotSeries& series = plot.series[i];
        const Pixel start = at.legend[i];
        svg.element("<g " + strokeOf(looks[i], series.style) + ">");
        if (series.style == SeriesStyle::points)
            svg.element(markerXml({start.x + 13, start.y - 4}, looks[i]));
        else
            svg.line({start.x, start.y - 4}, {start.x + 26, start.y - 4}, "");
        if (series.style == SeriesStyle::line && !series.x.empty() && series.x.size() <= sparse)
            svg.element(dotXml({start.x + 13, start.y - 4}, looks[i]));
        svg.element("</g>");
        svg.text({start.x + 33, start.y}, series.label, {legendSize});
    }
}

} // namespace

std::vector<std::size_t> decimate(const std::vector<std::pair<double, double>>& pixels)
{
    std::vector<std::size_t> kept;
    for (std::size_t begin = 0, end = 0; begin < pixels.size(); begin = end) {
        std::size_t low = begin, high = begin;
        const double column = std::floor(pixels[begin].first);
        for (end = begin; end < pixels.size() && std::floor(pixels[end].first) == column; ++end) {
            if (pixels[end].second < pixels[low].second) low = end;
            if (pixels[end].second > pixels[high].second) high = end;
        }
        if (low == high && end - begin > 1) high = end - 1; // a level run keeps both its ends
        kept.push_back(std::min(low, high));
        if (low != high) kept.push_back(std::max(low, high));
    }
    return kept;
}

std::string svgPlot(const Plot& plot)
{
    const bool markers = std::any_of(plot.series.begin(), plot.series.end(),
                                     [](const auto& s) { return s.style == SeriesStyle::points; });
    Scale x = makeScale(plot, plot.x, &PlotSeries::x, markers || !plot.marks.empty() ? 0.02 : 0, 8);
    Scale y = makeScale(plot, plot.y, &PlotSeries::y, 0.05, 6);
    const Layout layout = makeLayout(plot, y);
    x.from = layout.left, x.to = layout.right;
    y.from = layout.bottom, y.to = layout.top;

    SvgDrawing svg(width, layout.height, plot.title.empty() ? plot.y.label : plot.title);
    // As large as it fits; bold letters are a twelfth wider.
    const double wide = 13. / 12 * textWidth(plot.title, titleSize);
    const double fit = std::min(1.0, (width - layout.left - 6) / std::max(wide, 1.0));
    svg.text({layout.left, 28}, plot.title, {fit * titleSize, Anchor::start, "#111827", true});
    const std::vector<Look> looks = makeLooks(plot);
    drawLegend(svg, plot, looks, layout);
    drawAxes(svg, plot, layout, x, y);

    svg.element("<clipPath id=\"frame\"><rect x=\"" + svgNumber(layout.left - 5) + "\" y=\""
                + svgNumber(layout.top - 5) + "\" width=\""
                + svgNumber(layout.right - layout.left + 10) + "\" height=\""
                + svgNumber(frameHeight + 10) + "\"/></clipPath>");
    svg.element("<g clip-path=\"url(#frame)\">");
    // reference data last: they are the thinner sign and must stay visible
    for (const SeriesStyle style : {SeriesStyle::line, SeriesStyle::dashed, SeriesStyle::points})
        for (std::size_t i = 0; i < plot.series.size(); ++i)
            if (plot.series[i].style == style) drawSeries(svg, plot.series[i], looks[i], x, y);
    svg.element("</g>");
    drawPlotMarks(svg, plot, looks, layout, x, y);
    return svg.str();
}

} // namespace fpm
