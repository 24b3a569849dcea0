#include "run/WaitPolicy.h"

#include <unistd.h>

#include <cstdlib>

namespace fpm {

namespace {

/// Iterations of libgomp's loop, some 30 microseconds. Threads that all run come that close
/// together; one that was put aside stays away a hundred times longer. doc/performance.md has the
/// figures.
constexpr const char* spins = "1500";

} // namespace

void shortenSpin(char** arguments)
{
    if (std::getenv("OMP_WAIT_POLICY") || std::getenv("GOMP_SPINCOUNT")) return;
    if (setenv("GOMP_SPINCOUNT", spins, 1) == 0) execv("/proc/self/exe", arguments);
}

} // namespace fpm
