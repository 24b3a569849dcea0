#include "study/ChartResult.h"

#include "base/Format.h"
#include "case/RunResults.h"
#include "io/Table.h"
#include "study/Expression.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpm {

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

double costOf(const RunRow& row, CostKind kind)
{
    return kind == CostKind::wall  ? row.wall
           : kind == CostKind::cpu ? row.cpu
                                   : row.elements * row.steps;
}

double medianOf(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

Curve historyOf(const ChartProbe& probe, const std::filesystem::path& folder)
{
    const auto file = folder / probe.file;
    if (!std::filesystem::exists(file)) {
        std::string found;
        const auto parent = file.parent_path();
        if (std::filesystem::is_directory(parent))
            for (const auto& entry : std::filesystem::directory_iterator(parent))
                found += (found.empty() ? "" : ", ") + entry.path().filename().string();
        throw Error(
            ExitCode::dictionary,
            format("probe {}: the run in {} has no {}", probe.name, folder.string(), probe.file),
            found.empty() ? "" : "there are " + found);
    }
    const Table table = readTable(file);
    const auto status = readStatus(folder);
    const std::string other = otherRunOf(table, status ? status->runId : "");
    if (!other.empty())
        throw Error(ExitCode::fileIo,
                    format("probe {}: {} is of run {}, but {} names run {}", probe.name,
                           file.string(), other, (folder / "status").string(), status->runId),
                    "delete the folder of this run; fpmChart makes it again");
    Curve curve{table.values(probe.x), table.values(probe.y)};
    for (double& t : curve.t) t *= probe.xScale;
    for (double& y : curve.y) y *= probe.yScale;
    if (probe.perLength) curve = perLength(curve);
    return probe.average > 0 ? averaged(curve, probe.average) : curve;
}

using Curves = std::vector<std::optional<Curve>>;

Curves
historiesOf(const ChartProbe& probe, const Study& study, const std::vector<RungResult>& rungs)
{
    Curves curves(rungs.size());
    for (std::size_t rung = 0; rung < rungs.size(); ++rung)
        if (rungs[rung].succeeded()) curves[rung] = historyOf(probe, study.folder(rung));
    return curves;
}

/// The rungs of the line along `ladder` that has the first value of all others, as far as they
/// succeeded.
std::vector<std::size_t> lineAlong(std::size_t ladder, const Plan& plan, const Curves& curves)
{
    std::vector<std::size_t> found;
    for (std::size_t rung = 0; rung < plan.rungs.size(); ++rung) {
        bool isOn = curves[rung].has_value();
        for (std::size_t i = 0; i < plan.rungs[rung].values.size(); ++i) {
            const int value = plan.rungs[rung].values[i];
            isOn = isOn && (i == ladder ? value >= 0 : value <= 0);
        }
        if (isOn) found.push_back(rung);
    }
    return found;
}

/// The last rung of the ladder, or where three rungs converge with an order, what they converge to.
std::optional<Curve> finestCurve(const ChartProbe& probe,
                                 const ChartSpec& chart,
                                 const Plan& plan,
                                 const Curves& curves,
                                 ProbeResult& result)
{
    std::string& words = result.reference;
    const std::size_t number = probe.reference.ladder;
    const Ladder& ladder = chart.ladders[number];
    const auto line = lineAlong(number, plan, curves);
    if (line.empty()) {
        words = format("no rung of {} succeeded, so there is no reference", ladder.name);
        return std::nullopt;
    }
    const auto curve = [&](std::size_t fromEnd) -> const Curve& {
        return *curves[line[line.size() - 1 - fromEnd]];
    };
    const auto label = [&](std::size_t fromEnd) {
        return ladder
            .values[std::size_t(plan.rungs[line[line.size() - 1 - fromEnd]].values[number])];
    };
    result.theRung = format("{} {}", ladder.name, label(0));
    result.isReference[line.back()] = true;
    const auto finest = "the finest rung, " + result.theRung;
    words = finest + ", whose own error is not known";
    if (line.size() < 3 || ladder.steps.empty()) return curve(0);
    std::array<double, 3> h{};
    for (std::size_t i = 0; i < 3; ++i)
        h[i] = ladder.steps[std::size_t(plan.rungs[line[line.size() - 3 + i]].values[number])];
    const auto order = h[0] > h[1] && h[1] > h[2] ? observedOrder(h, distance(curve(2), curve(1)),
                                                                  distance(curve(1), curve(0)))
                                                  : std::nullopt;
    if (!order) {
        words = finest
                + format(" (its error is not known: {} {}, {}, {} show no order)", ladder.name,
                         label(2), label(1), label(0));
        return curve(0);
    }
    result.theRung.clear();
    result.isReference[line.back()] = false;
    words = format("Richardson's estimate from {} {} and {}, observed order {} (an estimate, no "
                   "exact solution)",
                   ladder.name, label(1), label(0), toText(*order, 3));
    return extrapolated(curve(1), curve(0), h[1], h[2], *order);
}

Curve formulaAt(const std::vector<double>& times, const std::string& text)
{
    const Expression formula(text);
    Curve curve{times, {}};
    for (const double t : times) curve.y.push_back(formula(t));
    return curve;
}

bool isFinite(const CurveErrors& errors)
{
    return std::isfinite(errors.l2) && std::isfinite(errors.peak) && std::isfinite(errors.final)
           && std::isfinite(errors.peakTime);
}

double
foreignError(const ForeignPoint& point, const ChartProbe& probe, std::optional<Curve> reference)
{
    if (!point.isFor(probe)) return noNumber;
    if (!point.curve) return point.error;
    if (probe.reference.kind == ReferenceSpec::Kind::expression)
        reference = formulaAt(point.curve->t, probe.reference.expression);
    return reference ? errorsOf(*point.curve, *reference).of(probe.measure) : noNumber;
}

/// Marks the rungs of equal content as well: another ladder may have the case as it is, too.
void markSameRuns(const std::vector<RungResult>& rungs, std::vector<bool>& marked)
{
    const auto found = std::find(marked.begin(), marked.end(), true);
    if (found == marked.end()) return;
    const std::string& key = rungs[std::size_t(found - marked.begin())].row.key;
    for (std::size_t rung = 0; rung < rungs.size(); ++rung)
        if (rungs[rung].row.key == key) marked[rung] = true;
}

/// log(error / error before) / log(step / step before) along every line.
void addOrders(const ChartProbe& probe,
               const ChartSpec& chart,
               const Plan& plan,
               ProbeResult& result)
{
    for (const Line& line : plan.lines) {
        const Ladder& ladder = chart.ladders[line.ladder];
        if (ladder.steps.empty()) continue;
        for (std::size_t i = 1; i < line.rungs.size(); ++i) {
            const std::size_t before = line.rungs[i - 1], rung = line.rungs[i];
            const auto step = [&](std::size_t r) {
                return ladder.steps[std::size_t(plan.rungs[r].values[line.ladder])];
            };
            const double order =
                std::log(result.error(rung, probe.measure) / result.error(before, probe.measure))
                / std::log(step(rung) / step(before));
            if (std::isfinite(order)) result.orders[rung] = order;
        }
    }
}

} // namespace

double ProbeResult::error(std::size_t rung, Measure measure) const
{
    return errors[rung] ? errors[rung]->of(measure) : noNumber;
}

std::vector<RungResult> costsOf(const ChartSpec& chart, const Plan& plan, const Study& study)
{
    std::vector<RungResult> results;
    for (std::size_t rung = 0; rung < plan.rungs.size(); ++rung) {
        RungResult result;
        result.label = plan.rungs[rung].label;
        const auto rows = study.rows(rung);
        if (!rows.empty()) {
            result.row = rows.front();
            result.state = rows.front().state;
            std::vector<double> costs;
            // A repeat stopped by the time limit cost more than its row says.
            for (const RunRow& row : rows)
                if (row.state == result.state) costs.push_back(costOf(row, chart.cost));
            const auto [least, most] = std::minmax_element(costs.begin(), costs.end());
            result.cost = {medianOf(costs), *least, *most};
        }
        results.push_back(result);
    }
    return results;
}

std::vector<bool> paretoFront(const std::vector<double>& costs, const std::vector<double>& errors)
{
    std::vector<bool> front(costs.size());
    for (std::size_t i = 0; i < costs.size(); ++i) {
        front[i] = std::isfinite(errors[i]);
        for (std::size_t j = 0; j < costs.size(); ++j) {
            const bool noWorse = costs[j] <= costs[i] && errors[j] <= errors[i];
            const bool better = costs[j] < costs[i] || errors[j] < errors[i];
            // Of equals the first one stands for all.
            if (noWorse && (better || j < i)) front[i] = false;
        }
    }
    return front;
}

ProbeResult judge(const ChartProbe& probe,
                  const ChartSpec& chart,
                  const Plan& plan,
                  const Study& study,
                  const std::vector<RungResult>& rungs)
{
    ProbeResult result;
    result.isReference.resize(rungs.size());
    const Curves curves = historiesOf(probe, study, rungs);
    std::optional<Curve> reference = probe.reference.curve;
    result.reference = "the reference given";
    if (probe.reference.kind == ReferenceSpec::Kind::finest)
        reference = finestCurve(probe, chart, plan, curves, result);
    if (probe.reference.kind == ReferenceSpec::Kind::expression)
        result.reference = probe.reference.expression;
    markSameRuns(rungs, result.isReference);

    result.errors.resize(rungs.size());
    result.orders.resize(rungs.size());
    for (std::size_t rung = 0; rung < rungs.size(); ++rung) {
        if (!curves[rung] || !reference) continue;
        if (probe.reference.kind == ReferenceSpec::Kind::expression)
            reference = formulaAt(curves[rung]->t, probe.reference.expression);
        const CurveErrors errors = errorsOf(*curves[rung], *reference);
        if (isFinite(errors)) result.errors[rung] = errors;
    }
    for (const ForeignPoint& point : chart.foreign)
        result.foreign.push_back(foreignError(point, probe, reference));
    addOrders(probe, chart, plan, result);
    std::vector<double> costs, errors;
    for (std::size_t rung = 0; rung < rungs.size(); ++rung) {
        costs.push_back(rungs[rung].cost.median);
        errors.push_back(result.isReference[rung] ? noNumber : result.error(rung, probe.measure));
    }
    result.front = paretoFront(costs, errors);
    return result;
}

} // namespace fpm
