#pragma once

#include "model/Model.h"

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace fpm {

/// Tasks that run now, this program's one not counted, from the text of /proc/loadavg
/// ("0.5 0.4 0.3 3/512 4711": 2); 0 where it says nothing.
int otherTasks(std::string_view loadAverage);

/// Cores that this process may use.
std::vector<int> ownCores();

/// Time that `cores` were idle and, with `countsNice`, worked for programs of low priority, from
/// the text of /proc/stat [ticks]; negative where it lacks one of them.
double idleTicks(std::string_view stat, const std::vector<int>& cores, bool countsNice);

/// Threads for so many cores that are idle or ours: `now` while that fits to half a core.
int threadsFor(double available, int now, int most);

/// Whether the number of threads follows the idle cores: openmp with `threads 0`, and no
/// OMP_NUM_THREADS, which is a choice of the user's.
bool followsIdleCores(const Control& control);

/// How many threads a run should have: as many as there are cores that other programs leave idle.
/// More would wait in every step for one that is put aside.
class IdleCores
{
public:
    /// `most`: threads at most.
    explicit IdleCores(int most);
    /// Now. Reads the load four times a second, else returns what it found last.
    int threads();
    /// Mean since it was made.
    double mean() const { return seconds_ > 0 ? threadSeconds_ / seconds_ : threads_; }

private:
    using Clock = std::chrono::steady_clock;

    int most_, threads_ = 1;
    std::vector<int> cores_;
    Clock::time_point last_;
    double ticks_, processor_; ///< at the last reading
    double seconds_ = 0, threadSeconds_ = 0;
};

/// Note before the start where `others` tasks run on the cores already: with how many
/// threads a run that follows the idle cores begins, or that the requested ones will wait for each
/// other. Empty where there are cores enough.
std::string busyCoresNote(int threads, bool follows, int cores, int others);

/// The same for this machine, now; empty too where OMP_WAIT_POLICY is set: someone has chosen.
std::string busyCoresNote(const Control& control);

} // namespace fpm
