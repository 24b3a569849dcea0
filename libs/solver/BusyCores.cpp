#include "solver/BusyCores.h"

#include "base/Format.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace fpm {

int otherTasks(std::string_view loadAverage)
{
    std::istringstream words{std::string(loadAverage)};
    double average = 0;
    int running = 0;
    words >> average >> average >> average >> running;
    return words ? std::max(0, running - 1) : 0;
}

std::string busyCoresNote(int threads, int cores, int others)
{
    if (threads < 2 || threads + others <= cores) return {};
    return format(
        "{} threads, and {} other tasks run on the {} cores of this machine: threads wait "
        "for each other in every step; use -threads {}, or OMP_WAIT_POLICY=passive in the "
        "environment",
        threads, others, cores, std::max(1, cores - others));
}

std::string busyCoresNote(int threads)
{
    if (std::getenv("OMP_WAIT_POLICY")) return {};
    std::ifstream file("/proc/loadavg");
    std::string text;
    std::getline(file, text);
    return busyCoresNote(threads, int(std::max(1u, std::thread::hardware_concurrency())),
                         otherTasks(text));
}

} // namespace fpm
