#include "application/Application.h"
#include "stability/CatalogueReport.h"
#include "stability/Stability.h"

#include <algorithm>
#include <thread>

/// Draws where the method fails: maps over two parameters of system/stabilityDict; or runs the
/// catalogue of scenes where contact fails, which needs no case.
int main(int argc, char** argv)
{
    const fpm::ApplicationInfo info{
        .name = "fpmStability",
        .purpose =
            "Runs a scene over two parameters and draws where it is stable and where it fails.",
        .dictionary = "system/stabilityDict",
        .options = {{"map", "<name>", "Draw this map only"},
                    {"catalogue", "", "Run the scenes where contact fails instead; needs no case"},
                    {"scenes", "<names>", "Of the catalogue only these: F1,largeFace"},
                    {"to", "<dir>", "Write the catalogue's table and picture into this folder"},
                    {"threads", "<n>", "Points run at a time; default is all cores"}},
        .locksCase = true,
        .caseless = "catalogue"};
    return fpm::runApplication(info, argc, argv, [](fpm::Run& run) {
        const int cores = std::max(1, int(std::thread::hardware_concurrency()));
        const auto threads = run.integer("threads", 1, 4096);
        const bool catalogue = run.has("catalogue");
        for (const char* option : {"scenes", "to", "map"})
            if (run.has(option) && catalogue == (std::string_view(option) == "map"))
                throw fpm::Error(
                    fpm::ExitCode::commandLine,
                    std::string("option -") + option
                        + (catalogue ? " has no meaning with -catalogue" : " needs -catalogue"));
        if (catalogue)
            fpm::runCatalogue(run.value("scenes").value_or(""), run.value("to").value_or(""),
                              int(threads.value_or(cores)), run.log);
        else
            fpm::runStability(run.theCase, run.dictionary(), run.value("map").value_or(""),
                              int(threads.value_or(cores)), run.log);
    });
}
