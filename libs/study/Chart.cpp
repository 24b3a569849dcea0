#include "study/Chart.h"

#include "base/Format.h"
#include "dictionary/Suggestion.h"
#include "study/ChartAdvice.h"
#include "study/ChartReport.h"

#include <algorithm>
#include <set>

namespace fpm {

namespace {

std::vector<StudyRun> runsOf(const Plan& plan, const std::vector<CaseChange>& fixed)
{
    std::vector<StudyRun> runs;
    for (const Rung& rung : plan.rungs) {
        runs.push_back(rung.run);
        auto& changes = runs.back().changes;
        changes.insert(changes.begin(), fixed.begin(), fixed.end());
    }
    return runs;
}

void warnOfHosts(const std::vector<RungResult>& rungs, Log& log)
{
    std::set<std::string> hosts;
    for (const RungResult& rung : rungs)
        if (!rung.row.host.empty()) hosts.insert(rung.row.host);
    if (hosts.size() > 1)
        log.warning(
            format("these runs come from {} machines: their times do not compare", hosts.size()));
}

void writeResults(const ChartSpec& chart,
                  const Plan& plan,
                  const Study& study,
                  const OutputFolder& folder,
                  Log& log)
{
    const auto rungs = costsOf(chart, plan, study);
    warnOfHosts(rungs, log);
    std::vector<ProbeResult> probes;
    for (const ChartProbe& probe : chart.probes)
        probes.push_back(judge(probe, chart, plan, study, rungs));
    const auto write = [&](const std::string& file, const std::string& text) {
        folder.write(file, text);
        log.line(format("wrote {}", folder.path(file).string()));
    };
    write("chart.dat", chartTable(chart, plan, rungs, probes));
    for (std::size_t i = 0; i < probes.size(); ++i) {
        const ChartProbe& probe = chart.probes[i];
        write(probe.name + ".svg", chartPicture(chart, probe, plan, rungs, probes[i]));
    }
    for (std::size_t i = 0; i < probes.size(); ++i)
        log.line(conclusion(chart, chart.probes[i], plan, rungs, probes[i]));
}

void runChart(const Case& theCase,
              ChartSpec& chart,
              const ChartOptions& options,
              const Pipeline& pipeline,
              Log& log)
{
    const std::string folder = "postProcessing/chart/" + chart.name;
    const Plan plan = chart.product ? productOf(chart.ladders) : eachOf(chart.ladders);
    chart.settings.retry = options.retry;
    Study study(theCase, folder, runsOf(plan, chart.fixed), chart.settings, pipeline);
    log.line(format("chart {}: {} runs in {}", chart.name, study.total(),
                    theCase.path(folder).string()));
    if (options.dryRun) return study.list(log);
    study.run(log);
    writeResults(chart, plan, study, theCase.output().inner(folder), log);
}

} // namespace

void runCharts(const Case& theCase,
               const Dictionary& dictionary,
               const ChartOptions& options,
               const Pipeline& pipeline,
               Log& log)
{
    auto charts = readChartDict(dictionary, theCase);
    std::vector<std::string> names;
    for (const ChartSpec& chart : charts) names.push_back(chart.name);
    const bool isKnown =
        options.only.empty() || std::find(names.begin(), names.end(), options.only) != names.end();
    if (!isKnown)
        throw Error(ExitCode::commandLine, format("there is no chart '{}'", options.only),
                    suggestion(options.only, names));
    for (ChartSpec& chart : charts)
        if (options.only.empty() || options.only == chart.name)
            runChart(theCase, chart, options, pipeline, log);
}

} // namespace fpm
