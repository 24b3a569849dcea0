#include "solver/backend/IdleCores.h"

#include "base/Format.h"
#include "base/Machine.h"
#include "solver/Solver.h"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace fpm {

namespace {

std::string textOf(const char* file)
{
    std::ifstream stream(file);
    std::ostringstream text;
    if (stream) text << stream.rdbuf();
    return text.str();
}

/// Idle ticks of this machine. Nicer programs than ours yield to it; were we as nice, our own time
/// would be among theirs.
double idleTicksNow(const std::vector<int>& cores)
{
    return idleTicks(textOf("/proc/stat"), cores, getpriority(PRIO_PROCESS, 0) <= 0);
}

double secondsBetween(std::chrono::steady_clock::time_point begin,
                      std::chrono::steady_clock::time_point end)
{
    return std::chrono::duration<double>(end - begin).count();
}

} // namespace

int otherTasks(std::string_view loadAverage)
{
    std::istringstream words{std::string(loadAverage)};
    double average = 0;
    int running = 0;
    words >> average >> average >> average >> running;
    return words ? std::max(0, running - 1) : 0;
}

std::vector<int> ownCores()
{
    std::vector<int> cores;
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0)
        for (int core = 0; core < CPU_SETSIZE; ++core)
            if (CPU_ISSET(core, &set)) cores.push_back(core);
    return cores;
}

double idleTicks(std::string_view stat, const std::vector<int>& cores, bool countsNice)
{
    std::istringstream lines{std::string(stat)};
    std::size_t found = 0;
    double sum = 0;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("cpu") || line.starts_with("cpu ")) continue;
        std::istringstream words(line.substr(3));
        int core = 0;
        double user = 0, nice = 0, system = 0, idle = 0, waits = 0;
        words >> core >> user >> nice >> system >> idle >> waits;
        if (!words || !std::binary_search(cores.begin(), cores.end(), core)) continue;
        ++found;
        sum += idle + waits + (countsNice ? nice : 0);
    }
    return found > 0 && found == cores.size() ? sum : -1;
}

int threadsFor(double available, int now, int most)
{
    if (available >= now - 0.5 && available <= now + 0.6) return std::min(now, most);
    return std::clamp(int(std::lround(available)), 1, most);
}

bool followsIdleCores(const Control& control)
{
    return control.backend == "openmp" && control.threads == 0 && !std::getenv("OMP_NUM_THREADS");
}

IdleCores::IdleCores(int most)
    : most_(most),
      cores_(ownCores()),
      last_(Clock::now()),
      ticks_(idleTicksNow(cores_)),
      processor_(processorSeconds())
{
    threads_ = std::clamp(int(cores_.size()) - otherTasks(textOf("/proc/loadavg")), 1, most_);
}

int IdleCores::threads()
{
    constexpr double interval = 0.25;
    const auto now = Clock::now();
    const double seconds = secondsBetween(last_, now);
    if (seconds < interval) return threads_;
    seconds_ += seconds;
    threadSeconds_ += seconds * threads_;
    const double ticks = idleTicksNow(cores_), processor = processorSeconds();
    if (ticks >= 0 && ticks_ >= 0) {
        const double idle = (ticks - ticks_) / double(sysconf(_SC_CLK_TCK));
        threads_ = threadsFor((idle + processor - processor_) / seconds, threads_, most_);
    }
    last_ = now;
    ticks_ = ticks;
    processor_ = processor;
    return threads_;
}

std::string busyCoresNote(int threads, bool follows, int cores, int others)
{
    if (threads < 2 || threads + others <= cores) return {};
    const int idle = std::max(1, cores - others);
    if (follows)
        return format("threads 0: {} other tasks run on the {} cores of this machine; it begins "
                      "with {} of {} and follows the cores that are idle",
                      others, cores, idle, threads);
    return format("{} threads, and {} other tasks run on the {} cores of this machine: threads "
                  "wait for each other in every step; use -threads {}, or threads 0, which "
                  "follows the cores that are idle",
                  threads, others, cores, idle);
}

std::string busyCoresNote(const Control& control)
{
    if (std::getenv("OMP_WAIT_POLICY")) return {};
    return busyCoresNote(threadCount(control), followsIdleCores(control), int(ownCores().size()),
                         otherTasks(textOf("/proc/loadavg")));
}

} // namespace fpm
