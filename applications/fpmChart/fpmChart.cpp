#include "application/Application.h"
#include "study/Chart.h"
#include "study/ChartProposal.h"

/// Charts speed against accuracy of a case: runs it in the variations of system/chartDict.
int main(int argc, char** argv)
{
    const fpm::ApplicationInfo info{
        .name = "fpmChart",
        .purpose = "Charts speed against accuracy: runs a case in many variations, compares their "
                   "histories with a reference, and goes on where it was stopped.",
        .dictionary = "system/chartDict",
        .options = {{"chart", "<name>", "This chart only"},
                    {"dryRun", "", "List the runs and which are finished, then end"},
                    {"retry", "", "Run failed runs again"}},
        .locksCase = true,
        .proposal = fpm::proposedChartDict,
    };
    return fpm::runApplication(info, argc, argv, [](fpm::Run& run) {
        const fpm::ChartOptions options{run.has("dryRun"), run.has("retry"),
                                        run.value("chart").value_or("")};
        fpm::runCharts(run.theCase, run.dictionary(), options, fpm::Pipeline::beside(), run.log);
    });
}
