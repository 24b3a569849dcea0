#pragma once

#include "study/ChartDict.h"

#include <string>

namespace fpm {

struct ChartOptions {
    bool dryRun = false; ///< list the runs, run nothing
    bool retry = false;  ///< run failed runs again
    std::string only;    ///< one chart; all where empty
};

/// The work of fpmChart: reads `dictionary`, does the runs that are still to be done, and writes
/// postProcessing/chart/<name>/: runs.dat, chart.dat, <probe>.svg. Ends with a sentence a probe.
/// Throws InputError before anything runs, Error(stopped) when interrupted.
void runCharts(const Case& theCase,
               const Dictionary& dictionary,
               const ChartOptions& options,
               const Pipeline& pipeline,
               Log& log);

} // namespace fpm
