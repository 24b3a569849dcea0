#include "probe/ProbeDict.h"

#include <algorithm>

namespace fpm {

namespace {

/// Names become file names: the safe set of characters only.
void requireFileName(const Dictionary& dictionary, const std::string& name)
{
    const bool safe = std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')
               || std::string_view("_.+-").find(c) != std::string_view::npos;
    });
    if (name.empty() || name.size() > 64 || name.front() == '.' || !safe)
        dictionary.fail(name, "'" + name + "' cannot be a file name",
                        "use up to 64 letters, digits and _ . + -, no leading dot");
}

std::optional<std::array<double, 2>> rangeOf(const Dictionary& dictionary, std::string_view key)
{
    if (!dictionary.has(key)) return std::nullopt;
    const std::vector<double> ends = dictionary.numbers(key);
    if (ends.size() != 2 || !(ends[0] < ends[1]))
        dictionary.fail(key, "expected two numbers, the smaller first", "for example (0 300)");
    return std::array<double, 2>{ends[0], ends[1]};
}

Point direction(const Dictionary& dictionary, std::string_view key, const Point& preset)
{
    const Point vector = dictionary.vectorOr(key, preset);
    if (!(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2] > 0))
        dictionary.fail(key, "a direction of length zero", "for example (1 -1.2 0.8)");
    return vector;
}

PlotAxis readAxis(const Dictionary& dictionary, const std::string& letter)
{
    PlotAxis axis;
    axis.label = dictionary.wordOr(letter + "Label", "");
    axis.logarithmic =
        dictionary.choiceOr(letter + "Axis", "linear", {"linear", "logarithmic"}) != "linear";
    axis.range = rangeOf(dictionary, letter + "Range");
    if (axis.logarithmic && axis.range && (*axis.range)[0] <= 0)
        dictionary.fail(letter + "Range", "a logarithmic axis has positive ends only");
    return axis;
}

SeriesSpec readSeries(const Dictionary& dictionary, const std::string& name, const Case& theCase)
{
    SeriesSpec series;
    series.name = name;
    series.label = dictionary.wordOr("label", name);
    series.file = dictionary.word("file");
    series.path = theCase.inside(series.file);
    series.xColumn = dictionary.word("x");
    series.yColumn = dictionary.word("y");
    series.xScale = dictionary.numberOr("xScale", 1);
    series.yScale = dictionary.numberOr("yScale", 1);
    series.xOffset = dictionary.numberOr("xOffset", 0);
    series.yOffset = dictionary.numberOr("yOffset", 0);
    const std::string style = dictionary.choiceOr("style", "line", {"line", "dashed", "points"});
    series.style = style == "points"   ? SeriesStyle::points
                   : style == "dashed" ? SeriesStyle::dashed
                                       : SeriesStyle::line;
    return series;
}

PlotSpec readPlot(const Dictionary& dictionary, const std::string& name, const Case& theCase)
{
    PlotSpec plot;
    plot.name = name;
    plot.title = dictionary.wordOr("title", "");
    plot.x = readAxis(dictionary, "x");
    plot.y = readAxis(dictionary, "y");
    const Dictionary series = dictionary.sub("series");
    for (const std::string& key : series.keys())
        plot.series.push_back(readSeries(series.sub(key), key, theCase));
    if (plot.series.empty())
        dictionary.fail("series", "a plot needs at least one series",
                        "name { file ...; x ...; y ...; }");
    return plot;
}

MirrorPlanes readMirror(const Dictionary& dictionary)
{
    MirrorPlanes mirror;
    mirror.origin = dictionary.vectorOr("mirrorOrigin", {0, 0, 0});
    if (!dictionary.has("mirror")) return mirror;
    for (const std::string& axis : dictionary.words("mirror")) {
        if (axis != "x" && axis != "y" && axis != "z")
            dictionary.fail("mirror", "expected x, y or z, got '" + axis + "'",
                            "for example (x y)");
        mirror.used[std::size_t(axis[0] - 'x')] = true;
    }
    return mirror;
}

PictureSpec readPicture(const Dictionary& dictionary, const std::string& name)
{
    PictureSpec picture;
    picture.name = name;
    picture.title = dictionary.wordOr("title", "");
    picture.field = {dictionary.word("field"), dictionary.wordOr("component", "")};
    if (dictionary.has("times")) picture.times = dictionary.numbers("times");
    picture.warp = dictionary.numberOr("warp", 1);
    picture.view = direction(dictionary, "view", picture.view);
    picture.up = direction(dictionary, "up", picture.up);
    picture.perspective = dictionary.switchOr("perspective", false);
    if (dictionary.has("parts")) picture.parts = dictionary.words("parts");
    picture.mirror = readMirror(dictionary);
    picture.range = rangeOf(dictionary, "range");
    if (dictionary.has("bands")) picture.bands = int(dictionary.integer("bands", 0, 64));
    picture.colours = dictionary.choiceOr("colours", "turbo", {"turbo", "viridis"}) == "viridis"
                          ? Palette::viridis
                          : Palette::turbo;
    picture.edges = dictionary.switchOr("edges", true);
    return picture;
}

TableSpec readTableSpec(const Dictionary& dictionary, const std::string& name)
{
    using Kind = TableSpec::Kind;
    TableSpec table;
    table.name = name;
    const std::string type =
        dictionary.choice("type", {"point", "section", "extrema", "sum", "profile"});
    table.field.field = dictionary.word("field");
    requireFileName(dictionary, table.field.field);
    if (type == "point") {
        table.kind = Kind::point;
        table.part = dictionary.wordOr("part", "");
        table.position = dictionary.vector("position");
    } else if (type == "section") {
        table.kind = Kind::section;
        table.set = dictionary.word("set");
        const std::string operation =
            dictionary.choiceOr("operation", "mean", {"mean", "sum", "min", "max"});
        table.operation = operation == "sum"   ? TableSpec::Operation::sum
                          : operation == "min" ? TableSpec::Operation::min
                          : operation == "max" ? TableSpec::Operation::max
                                               : TableSpec::Operation::mean;
    } else if (type == "extrema") {
        table.kind = Kind::extrema;
        table.part = dictionary.wordOr("part", "");
        table.field.component = dictionary.wordOr("component", "");
    } else if (type == "profile") {
        table.kind = Kind::profile;
        table.set = dictionary.word("set");
        const std::string axis = dictionary.choiceOr("axis", "x", {"x", "y", "z"});
        table.axis = std::size_t(axis[0] - 'x');
    } else {
        table.kind = Kind::sum;
        table.set = dictionary.wordOr("set", "");
        table.part = dictionary.wordOr("part", "");
        if (!table.set.empty() && !table.part.empty())
            dictionary.fail("part", "a sum is over a set or over a part, not both");
    }
    return table;
}

} // namespace

ProbeDict readProbeDict(const Dictionary& dictionary, const Case& theCase)
{
    ProbeDict probes;
    const Dictionary tables = dictionary.subOrEmpty("tables");
    for (const std::string& name : tables.keys()) {
        requireFileName(tables, name);
        probes.tables.push_back(readTableSpec(tables.sub(name), name));
    }
    const Dictionary pictures = dictionary.subOrEmpty("pictures");
    for (const std::string& name : pictures.keys()) {
        requireFileName(pictures, name);
        probes.pictures.push_back(readPicture(pictures.sub(name), name));
    }
    const Dictionary plots = dictionary.subOrEmpty("plots");
    for (const std::string& name : plots.keys()) {
        requireFileName(plots, name);
        probes.plots.push_back(readPlot(plots.sub(name), name, theCase));
    }
    dictionary.requireAllUsed();
    return probes;
}

} // namespace fpm
