#include "study/ChartReport.h"

#include "base/Format.h"
#include "probe/SvgPlot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpm {

namespace {

std::string orderText(const std::optional<double>& order)
{
    return order ? toText(*order, 3) : "-";
}

/// Rows of words as columns.
std::string aligned(const std::vector<std::vector<std::string>>& rows)
{
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i)
            text += (i == 0 ? "" : "  ") + row[i]
                    + (i + 1 < row.size() ? std::string(widths[i] - row[i].size(), ' ') : "");
        text += "\n";
    }
    return text;
}

/// "precision mixed" of a rung beside its line: what the line does not say.
std::string valueOn(const Line& line, const ChartSpec& chart, const Rung& rung)
{
    return chart.ladders[line.ladder].values[std::size_t(rung.values[line.ladder])];
}

/// In percent; not a number where there is none, or none but rounding.
double shownError(const ProbeResult& result, std::size_t rung, Measure measure)
{
    constexpr double rounding = 1e-12;
    const double error = result.error(rung, measure);
    return error > rounding ? 100 * error : std::numeric_limits<double>::quiet_NaN();
}

double leastCost(const std::vector<RungResult>& rungs)
{
    double least = std::numeric_limits<double>::infinity();
    for (const RungResult& rung : rungs)
        if (rung.cost.median > 0) least = std::min(least, rung.cost.median);
    return std::isfinite(least) ? least : 1;
}

void addLine(Plot& plot,
             const Line& line,
             const ChartSpec& chart,
             const ChartProbe& probe,
             const Plan& plan,
             const std::vector<RungResult>& rungs,
             const ProbeResult& result)
{
    PlotSeries series;
    series.label = line.label;
    for (const std::size_t rung : line.rungs) {
        const RungResult& one = rungs[rung];
        if (one.state.empty()) continue;
        PlotMark mark;
        mark.x = one.cost.median, mark.xLeast = one.cost.least, mark.xMost = one.cost.most;
        mark.y = shownError(result, rung, probe.measure);
        mark.text = valueOn(line, chart, plan.rungs[rung]);
        mark.series = plot.series.size();
        mark.hollow = !one.succeeded();
        mark.emphasised = result.front[rung];
        if (mark.hollow) mark.text += ": " + causeOf(one.state);
        if (!(mark.x > 0)) mark.x = leastCost(rungs); // failed before there was any
        series.x.push_back(mark.x);
        series.y.push_back(mark.y);
        // Without an error there is nothing to show.
        if (mark.hollow || mark.y > 0) plot.marks.push_back(mark);
    }
    plot.series.push_back(std::move(series));
}

void addFront(Plot& plot,
              const ChartProbe& probe,
              const std::vector<RungResult>& rungs,
              const ProbeResult& result)
{
    std::vector<std::pair<double, double>> front;
    for (std::size_t rung = 0; rung < rungs.size(); ++rung)
        if (result.front[rung])
            front.emplace_back(rungs[rung].cost.median, shownError(result, rung, probe.measure));
    std::sort(front.begin(), front.end());
    PlotSeries series{"Pareto front", {}, {}, SeriesStyle::dashed};
    for (const auto& [cost, error] : front) series.x.push_back(cost), series.y.push_back(error);
    if (!front.empty()) plot.series.push_back(std::move(series));
}

void addForeign(Plot& plot, const ChartSpec& chart, const ProbeResult& result)
{
    PlotSeries series{"other programs", {}, {}, SeriesStyle::points, "#6b7280"};
    for (std::size_t i = 0; i < chart.foreign.size(); ++i) {
        const ForeignPoint& point = chart.foreign[i];
        const double error = 100 * result.foreign[i];
        if (!(error > 0)) continue;
        series.x.push_back(point.cost);
        series.y.push_back(error);
        PlotMark mark;
        mark.x = point.cost, mark.y = error, mark.series = plot.series.size(), mark.hollow = true;
        mark.text = point.name + (point.note.empty() ? "" : ", " + point.note);
        plot.marks.push_back(mark);
    }
    if (!series.x.empty()) plot.series.push_back(std::move(series));
}

} // namespace

std::string chartTable(const ChartSpec& chart,
                       const Plan& plan,
                       const std::vector<RungResult>& rungs,
                       const std::vector<ProbeResult>& probes)
{
    std::vector<std::vector<std::string>> rows{{"# run", "cost", "least", "most", "wall_s", "cpu_s",
                                                "elementSteps", "nsPerElementStep", "memory_MB",
                                                "state"}};
    for (const ChartProbe& probe : chart.probes)
        for (const auto* column : {"L2", "peak", "peakTime", "final", "order", "front"})
            rows[0].push_back(probe.name + "." + column);
    for (std::size_t rung = 0; rung < rungs.size(); ++rung) {
        const RungResult& one = rungs[rung];
        std::vector<std::string> row{plan.rungs[rung].run.name,
                                     toText(one.cost.median, 5),
                                     toText(one.cost.least, 5),
                                     toText(one.cost.most, 5),
                                     toText(one.row.wall, 5),
                                     toText(one.row.cpu, 5),
                                     toText(one.row.elements * one.row.steps, 9),
                                     toText(one.row.nsPerElementStep, 4),
                                     toText(one.row.memory),
                                     one.state.empty() ? "-" : one.state};
        for (std::size_t probe = 0; probe < probes.size(); ++probe) {
            for (const auto measure :
                 {Measure::l2, Measure::peak, Measure::peakTime, Measure::final}) {
                const double error = probes[probe].error(rung, measure);
                row.push_back(std::isfinite(error) ? toText(error, 5) : "-");
            }
            row.push_back(orderText(probes[probe].orders[rung]));
            row.push_back(probes[probe].front[rung] ? "yes" : "no");
        }
        rows.push_back(std::move(row));
    }
    std::string text;
    for (std::size_t probe = 0; probe < probes.size(); ++probe)
        text += format("# {}: errors (shares of one) against {}\n", chart.probes[probe].name,
                       probes[probe].reference);
    for (std::size_t i = 0; i < chart.foreign.size(); ++i)
        for (std::size_t probe = 0; probe < probes.size(); ++probe)
            if (const double error = probes[probe].foreign[i]; std::isfinite(error))
                text += format("# other program {}: cost {}, {} {}\n", chart.foreign[i].name,
                               toText(chart.foreign[i].cost, 4), chart.probes[probe].name,
                               toText(error, 4));
    return text
           + format("# cost: {}, median, least and most of {} repeats\n", costText(chart.cost),
                    chart.settings.repeats)
           + aligned(rows);
}

std::string chartPicture(const ChartSpec& chart,
                         const ChartProbe& probe,
                         const Plan& plan,
                         const std::vector<RungResult>& rungs,
                         const ProbeResult& result)
{
    Plot plot;
    plot.title = chart.title;
    plot.x = {costText(chart.cost), {}, true};
    const bool isEstimate = probe.reference.kind == ReferenceSpec::Kind::finest;
    const auto what = result.theRung.empty()
                          ? format("{} of {}", isEstimate ? "estimated error" : "error", probe.name)
                          : format("difference of {} to {}", probe.name, result.theRung);
    plot.y = {format("{}, {} [%]", what, measureText(probe)), {}, true};
    for (const Line& line : plan.lines) addLine(plot, line, chart, probe, plan, rungs, result);
    addFront(plot, probe, rungs, result);
    addForeign(plot, chart, result);
    return svgPlot(plot);
}

} // namespace fpm
