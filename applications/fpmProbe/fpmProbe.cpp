#include "application/Application.h"
#include "base/Format.h"
#include "probe/Probe.h"

/// Makes the tables, pictures and plots of system/probeDict from the results of a case.
int main(int argc, char** argv)
{
    const fpm::ApplicationInfo info{
        .name = "fpmProbe",
        .purpose = "Makes tables, pictures and plots from results; may run beside the solver.",
        .dictionary = "system/probeDict",
        .options = {{"tables", "", "Make the tables (together with the other groups named)"},
                    {"pictures", "", "Make the pictures"},
                    {"plots", "", "Make the plots; default is all three groups"},
                    {"time", "<times>",
                     "Output times: numbers, first:last, latestTime; commas between"}},
    };
    return fpm::runApplication(info, argc, argv, [](fpm::Run& run) {
        fpm::ProbeSelection selection;
        if (run.has("tables") || run.has("pictures") || run.has("plots")) {
            selection.tables = run.has("tables");
            selection.pictures = run.has("pictures");
            selection.plots = run.has("plots");
        }
        if (const auto times = run.value("time")) selection.times = fpm::parseTimes(*times);

        const auto files = fpm::runProbe(run.theCase, run.dictionary(), selection, run.log);
        run.log.line(fpm::format("{} files", files.size()));
    });
}
