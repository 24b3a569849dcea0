#include "probe/SvgPlot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

using namespace fpm;

namespace {

std::size_t occurrences(const std::string& text, const std::string& part)
{
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
    return count;
}

Plot sinePlot(std::size_t points, SeriesStyle style)
{
    Plot plot{"Sine", {"time [s]", {}, false}, {"value", {}, false}, {}};
    PlotSeries series{"a", {}, {}, style};
    for (std::size_t i = 0; i < points; ++i) {
        series.x.push_back(double(i) / double(points));
        series.y.push_back(std::sin(0.01 * double(i)));
    }
    plot.series.push_back(series);
    return plot;
}

} // namespace

TEST(SvgPlot, KeepsTheLowestAndHighestOfEachPixelColumn)
{
    std::vector<std::pair<double, double>> pixels;
    for (int i = 0; i < 10000; ++i)
        pixels.emplace_back(0.01 * i, i == 5050 ? 900.0 : std::sin(double(i)));

    const auto kept = decimate(pixels);

    std::map<int, int> perColumn;
    for (const auto i : kept) ++perColumn[int(pixels[i].first)];
    for (const auto& [column, count] : perColumn) EXPECT_LE(count, 2) << "column " << column;
    EXPECT_NE(std::find(kept.begin(), kept.end(), 5050u), kept.end());
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
}

TEST(SvgPlot, LeavesALineThatTurnsBackInOrder)
{
    const std::vector<std::pair<double, double>> loop{{0, 0}, {1, 1}, {2, 2}, {1, 3}, {0, 4}};

    EXPECT_EQ(decimate(loop), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(SvgPlot, StaysSmallForAMillionPoints)
{
    const std::string svg = svgPlot(sinePlot(1000000, SeriesStyle::line));

    EXPECT_LT(svg.size(), 60000u);
    EXPECT_EQ(occurrences(svg, "<polyline"), 1u);
    EXPECT_NE(svg.find("width=\"720\""), std::string::npos);
    EXPECT_NE(svg.find(">time [s]</text>"), std::string::npos);
}

TEST(SvgPlot, BreaksTheLineAtNumbersThatAreNot)
{
    Plot plot = sinePlot(100, SeriesStyle::line);
    plot.series[0].y[50] = std::numeric_limits<double>::quiet_NaN();

    const std::string svg = svgPlot(plot);

    EXPECT_EQ(occurrences(svg, "<polyline"), 2u);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(SvgPlot, DrawsReferenceDataAsBlackMarkersOrDashes)
{
    Plot plot = sinePlot(10, SeriesStyle::points);
    plot.series.push_back(sinePlot(10, SeriesStyle::dashed).series[0]);

    const std::string svg = svgPlot(plot);

    EXPECT_EQ(occurrences(svg, "<circle"), 11u); // ten and the legend's
    EXPECT_EQ(occurrences(svg, "stroke-dasharray"), 2u);
    EXPECT_NE(svg.find("stroke=\"#1f2937\""), std::string::npos);
}

TEST(SvgPlot, ShowsEmptyAxesWhileThereIsNoData)
{
    Plot plot = sinePlot(0, SeriesStyle::line);

    const std::string svg = svgPlot(plot);

    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(SvgPlot, LeavesOutWhatALogarithmicAxisCannotShow)
{
    Plot plot = sinePlot(100, SeriesStyle::line);
    plot.x.logarithmic = plot.y.logarithmic = true;
    plot.series[0].y[0] = -1;

    const std::string svg = svgPlot(plot);

    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(SvgPlot, MakesALongTitleFit)
{
    const auto sizeOf = [](const std::string& title) {
        Plot plot;
        plot.title = title;
        const std::string svg = svgPlot(plot);
        const auto start = svg.rfind("font-size=\"", svg.rfind(">" + title + "<"));
        return std::stod(svg.substr(start + 11));
    };
    EXPECT_EQ(sizeOf("short"), 17);
    EXPECT_LT(sizeOf(std::string(100, 'm')), 8);
}

TEST(SvgPlot, KeepsTextsOffTheCurves)
{
    // A line from lower left to upper right through a mark: its text's first place, above on the
    // right, is crossed.
    Plot plot;
    plot.series = {{"s", {0, 1, 2}, {0, 1, 2}}};
    PlotMark mark;
    mark.x = 1, mark.y = 1, mark.text = "here";
    plot.marks = {mark};
    const std::string svg = svgPlot(plot);

    const auto text = svg.find(">here<");
    const auto start = svg.rfind("<text x=\"", text);
    const auto circle = svg.rfind("<circle cx=\"", text);
    const double textX = std::stod(svg.substr(start + 9)),
                 markX = std::stod(svg.substr(circle + 12));
    const double textY = std::stod(svg.substr(svg.find(" y=\"", start) + 4));
    const double markY = std::stod(svg.substr(svg.find(" cy=\"", circle) + 5));
    EXPECT_FALSE(textX > markX && textY < markY - 2) << textX - markX << " " << textY - markY;
}

TEST(SvgPlot, ShowsMarksWithTextsThatKeepClear)
{
    Plot plot = sinePlot(3, SeriesStyle::line);
    for (int i = 0; i < 3; ++i) {
        PlotMark mark;
        mark.x = 0.33 * i, mark.y = 0, mark.text = "rung " + std::to_string(i);
        mark.hollow = i == 1, mark.emphasised = i == 2;
        plot.marks.push_back(mark);
    }
    plot.marks[0].xLeast = -5, plot.marks[0].xMost = 5;
    plot.marks[1].y = std::numeric_limits<double>::quiet_NaN();

    const std::string svg = svgPlot(plot);

    for (const char* text : {"rung 0", "rung 1", "rung 2"}) EXPECT_EQ(occurrences(svg, text), 1u);
    EXPECT_EQ(occurrences(svg, "fill=\"#ffffff\" stroke=\"#0072B2\""), 1u) << "one is hollow";
    EXPECT_EQ(occurrences(svg, "r=\"6.5\""), 1u) << "one is emphasised";
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_NE(svg.find(">4<"), std::string::npos) << "the axis holds the bar";
}

TEST(SvgPlot, ATextIsNearestToItsOwnMark)
{
    Plot plot = sinePlot(3, SeriesStyle::line);
    plot.series.clear();
    for (const auto& [text, y] :
         {std::pair("lower", 0.485), {"upper", 0.515}, {"", 0.0}, {"", 1.0}}) {
        PlotMark mark;
        mark.x = 0.5, mark.y = y, mark.text = text;
        plot.marks.push_back(mark);
    }
    const std::string svg = svgPlot(plot);

    const auto heightOf = [&](const std::string& text) {
        const auto start = svg.rfind("<text", svg.find(">" + text + "<"));
        return std::stod(svg.substr(svg.find(" y=\"", start) + 4));
    };
    EXPECT_LT(heightOf("upper"), heightOf("lower"));
}
