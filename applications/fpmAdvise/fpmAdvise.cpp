#include "advise/Advise.h"
#include "application/Application.h"

/// Looks for what a scene does not need, tells what leaving it out saves and costs, and writes the
/// smaller case where asked to.
int main(int argc, char** argv)
{
    const fpm::ApplicationInfo info{
        .name = "fpmAdvise",
        .purpose = "Tells how to model less of a scene, at what price; -apply writes the new case.",
        .dictionary = "",
        .options = {{"pilot", "<share>",
                     "Run a copy up to this share of endTime for what needs results"},
                    {"measure", "",
                     "Run the case without and with each piece of advice: time and errors"},
                    {"apply", "<kinds>",
                     "Write a new case: symmetry, rigid, elastic, ...; commas between"},
                    {"to", "<dir>", "The folder of the new case; must not exist"}},
    };
    return fpm::runApplication(info, argc, argv, [](fpm::Run& run) {
        fpm::advise(run.theCase,
                    {run.value("pilot"), run.has("measure"), run.value("apply"), run.value("to")},
                    run.log);
    });
}
