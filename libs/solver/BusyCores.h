#pragma once

#include <string>
#include <string_view>

namespace fpm {

/// Tasks that run now, this program's one not counted, from the text of /proc/loadavg
/// ("0.5 0.4 0.3 3/512 4711": 2); 0 where it says nothing.
int otherTasks(std::string_view loadAverage);

/// What to tell before threads share cores with other tasks: they wait for each other several
/// times a step, and one that is put aside holds up all, ten times longer than it is away. Empty
/// where there are cores enough.
std::string busyCoresNote(int threads, int cores, int others);

/// The same for this machine, now; empty too where OMP_WAIT_POLICY is set: someone has chosen.
std::string busyCoresNote(int threads);

} // namespace fpm
