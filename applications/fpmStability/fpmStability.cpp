#include "application/Application.h"
#include "stability/Stability.h"

#include <algorithm>
#include <thread>

/// Draws where the method fails: maps over two parameters of system/stabilityDict.
int main(int argc, char** argv)
{
    const fpm::ApplicationInfo info{
        .name = "fpmStability",
        .purpose =
            "Runs a scene over two parameters and draws where it is stable and where it fails.",
        .dictionary = "system/stabilityDict",
        .options = {{"map", "<name>", "Draw this map only"},
                    {"threads", "<n>", "Points run at a time; default is all cores"}},
        .locksCase = true};
    return fpm::runApplication(info, argc, argv, [](fpm::Run& run) {
        const int cores = std::max(1, int(std::thread::hardware_concurrency()));
        const auto threads = run.integer("threads", 1, 4096);
        fpm::runStability(run, run.value("map").value_or(""), int(threads.value_or(cores)));
    });
}
