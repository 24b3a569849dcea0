#include "study/ChartDict.h"

#include "base/Format.h"
#include "dictionary/Suggestion.h"
#include "io/Table.h"
#include "study/Expression.h"

#include <algorithm>
#include <stdexcept>

namespace fpm {

namespace {

void requireFileName(const Dictionary& dictionary, const std::string& name)
{
    if (name.find(':') != name.npos)
        dictionary.fail(name, format("'{}' cannot be a file name", name),
                        "use letters, digits and _ . + -");
}

/// Ascending times, or a complaint at `key`.
Curve curveOf(const Dictionary& entry, std::string_view key, Curve curve)
{
    if (curve.t.size() < 2) entry.fail(key, "a reference needs at least two rows");
    if (std::adjacent_find(curve.t.begin(), curve.t.end(), std::greater_equal<>()) != curve.t.end())
        entry.fail(key, "the times of a reference must ascend");
    return curve;
}

Curve curveOfFile(const Dictionary& entry, const Case& theCase)
{
    const auto name = entry.word("file");
    const auto file = theCase.inside(name);
    if (!theCase.hasFile(name)) entry.fail("file", format("the case has no file '{}'", name));
    const Table table = readTable(file);
    const auto column = [&](const std::string& key, double scale) {
        const auto wanted = entry.word(key);
        if (std::find(table.columns.begin(), table.columns.end(), wanted) == table.columns.end())
            entry.fail(key, format("{} has no column '{}'", name, wanted),
                       suggestion(wanted, table.columns));
        auto values = table.values(wanted);
        for (double& value : values) value *= scale;
        return values;
    };
    const double xScale = entry.numberOr("xScale", 1), yScale = entry.numberOr("yScale", 1);
    return curveOf(entry, "file", {column("x", xScale), column("y", yScale)});
}

ReferenceSpec
readReference(const Dictionary& probe, const Case& theCase, const std::vector<Ladder>& ladders)
{
    const auto entry = probe.sub("reference");
    ReferenceSpec reference;
    int kinds = 0;
    for (const auto* key : {"file", "table", "expression", "finest"}) kinds += entry.has(key);
    if (kinds != 1)
        probe.fail("reference", "a reference is one of file, table, expression and finest");
    if (entry.has("file")) {
        reference.curve = curveOfFile(entry, theCase);
    } else if (entry.has("table")) {
        Curve curve;
        for (const auto& row : entry.rows("table", 2)) {
            curve.t.push_back(row[0]);
            curve.y.push_back(row[1]);
        }
        reference.curve = curveOf(entry, "table", curve);
    } else if (entry.has("expression")) {
        reference.kind = ReferenceSpec::Kind::expression;
        reference.expression = entry.word("expression");
        try {
            const Expression formula(reference.expression);
        } catch (const std::invalid_argument& error) {
            entry.fail("expression", error.what());
        }
    } else {
        reference.kind = ReferenceSpec::Kind::finest;
        std::vector<std::string> names;
        for (const auto& ladder : ladders) names.push_back(ladder.name);
        const auto name = entry.choice("finest", names);
        reference.ladder = std::size_t(std::find(names.begin(), names.end(), name) - names.begin());
    }
    return reference;
}

std::vector<std::string> keysOf(const Case& theCase, const std::string& file, const char* group)
{
    if (!theCase.hasFile(file)) return {};
    const auto dictionary = theCase.dictionary(file);
    return dictionary.isDictionary(group) ? dictionary.sub(group).keys()
                                          : std::vector<std::string>();
}

/// Whether the file comes from a table of probeDict; refuses files that no history writes.
bool isFromTable(const Dictionary& entry, const std::string& file, const Case& theCase)
{
    const std::string top = "postProcessing/";
    if (!file.starts_with(top) || file.find("..") != file.npos)
        entry.fail("file", "a probe is a file in postProcessing",
                   "for example \"postProcessing/tip/0/displacement.dat\"");
    const auto object = file.substr(top.size(), file.find('/', top.size()) - top.size());
    auto names = keysOf(theCase, "system/controlDict", "functions");
    const auto tables = keysOf(theCase, "system/probeDict", "tables");
    const auto isIn = [&](const auto& list) {
        return std::find(list.begin(), list.end(), object) != list.end();
    };
    if (isIn(names)) return false;
    if (isIn(tables)) return true;
    names.insert(names.end(), tables.begin(), tables.end());
    entry.fail(
        "file",
        format("neither 'functions' of controlDict nor 'tables' of probeDict has '{}'", object),
        suggestion(object, names));
}

ChartProbe
readProbe(const Dictionary& entry, const std::string& name, const Case& theCase, ChartSpec& chart)
{
    ChartProbe probe;
    probe.name = name;
    probe.file = entry.word("file");
    if (isFromTable(entry, probe.file, theCase)) chart.settings.tables = true;
    probe.x = entry.wordOr("x", "time");
    probe.y = entry.word("y");
    probe.xScale = entry.numberOr("xScale", 1, positive());
    probe.yScale = entry.numberOr("yScale", 1);
    probe.perLength = entry.switchOr("perLength", false);
    probe.average = entry.numberOr("average", 0, nonNegative());
    const auto measure = entry.choiceOr("measure", "L2", {"L2", "peak", "peakTime", "final"});
    probe.measure = measure == "peak"       ? Measure::peak
                    : measure == "peakTime" ? Measure::peakTime
                    : measure == "final"    ? Measure::final
                                            : Measure::l2;
    probe.reference = readReference(entry, theCase, chart.ladders);
    return probe;
}

/// One point, or with 'errors' one a probe.
void readForeign(const Dictionary& entry,
                 const std::string& name,
                 const Case& theCase,
                 ChartSpec& chart)
{
    ForeignPoint point;
    point.name = name;
    point.cost = entry.number("cost", positive());
    point.note = entry.wordOr("note", "");
    std::vector<std::string> probes;
    for (const auto& probe : chart.probes) probes.push_back(probe.name);
    if (int(entry.has("error")) + int(entry.has("errors")) + int(entry.has("file")) != 1)
        entry.fail("cost", "another program has one of error, errors and file");
    if (entry.has("errors")) {
        const auto errors = entry.sub("errors");
        for (const auto& probe : probes) {
            if (!errors.has(probe)) continue;
            point.probe = probe;
            point.error = errors.number(probe, positive());
            chart.foreign.push_back(point);
        }
        return;
    }
    const bool isCurve = entry.has("file");
    if (isCurve)
        point.curve = curveOfFile(entry, theCase);
    else
        point.error = entry.number("error", positive());
    if (isCurve || entry.has("probe")) point.probe = entry.choice("probe", probes);
    chart.foreign.push_back(point);
}

void requireFewRuns(const Dictionary& entry, const ChartSpec& chart)
{
    constexpr double most = 10'000;
    double runs = chart.product ? 1 : 0;
    for (const auto& ladder : chart.ladders) {
        if (chart.product)
            runs *= double(ladder.values.size());
        else
            runs += double(ladder.values.size());
    }
    if (runs > most)
        entry.fail("ladders", format("these ladders make {} runs, more than {}", runs, most),
                   "use fewer values, or combine each;");
}

ChartSpec readChart(const Dictionary& entry, const std::string& name, const Case& theCase)
{
    ChartSpec chart;
    chart.name = name;
    chart.title = entry.wordOr("title", "");
    chart.product = entry.choiceOr("combine", "each", {"each", "product"}) == "product";
    chart.settings.repeats = int(entry.integerOr("repeats", 1, 1, 1000));
    chart.settings.timeLimit = entry.numberOr("runTimeLimit", 0, nonNegative());
    chart.settings.keepFields = entry.switchOr("keepFields", false);
    const auto cost = entry.choiceOr("cost", "wall", {"wall", "cpu", "elementSteps"});
    chart.cost = cost == "cpu"            ? CostKind::cpu
                 : cost == "elementSteps" ? CostKind::elementSteps
                                          : CostKind::wall;
    chart.tolerance = entry.numberOr("tolerance", 0.01, positive());
    chart.fixed = readFixed(entry.subOrEmpty("fixed"), theCase);
    chart.ladders = readLadders(entry.sub("ladders"), theCase, chart.fixed);
    if (chart.ladders.empty()) entry.fail("ladders", "a chart needs at least one ladder");
    requireFewRuns(entry, chart);
    const auto probes = entry.sub("probes");
    for (const auto& key : probes.keys()) {
        requireFileName(probes, key);
        chart.probes.push_back(readProbe(probes.sub(key), key, theCase, chart));
    }
    if (chart.probes.empty()) entry.fail("probes", "a chart needs at least one probe");
    const auto foreign = entry.subOrEmpty("foreign");
    for (const auto& key : foreign.keys()) readForeign(foreign.sub(key), key, theCase, chart);
    return chart;
}

} // namespace

std::vector<ChartSpec> readChartDict(const Dictionary& dictionary, const Case& theCase)
{
    std::vector<ChartSpec> charts;
    const auto entries = dictionary.sub("charts");
    for (const auto& name : entries.keys()) {
        requireFileName(entries, name);
        charts.push_back(readChart(entries.sub(name), name, theCase));
    }
    dictionary.requireAllUsed();
    if (charts.empty()) dictionary.fail("charts", "there is no chart here");
    return charts;
}

std::string measureText(const ChartProbe& probe)
{
    switch (probe.measure) {
    case Measure::l2:
        return "L2 over " + probe.x;
    case Measure::peak:
        return "peak";
    case Measure::peakTime:
        return probe.x + " of the peak";
    default:
        return "final value";
    }
}

std::string costText(CostKind cost)
{
    return cost == CostKind::wall  ? "wall time [s]"
           : cost == CostKind::cpu ? "CPU time [s]"
                                   : "element-steps";
}

} // namespace fpm
