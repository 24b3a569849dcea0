#include "base/ChildProcess.h"

#include <sys/resource.h>
#include <sys/wait.h>

#include <cerrno>
#include <system_error>

namespace fpm {

namespace {

double seconds(const timeval& time)
{
    return double(time.tv_sec) + 1e-6 * double(time.tv_usec);
}

} // namespace

ProcessEnd reaped(int child)
{
    int status = 0;
    rusage used{};
    while (wait4(child, &status, 0, &used) < 0)
        if (errno != EINTR)
            throw Error(ExitCode::internal,
                        "lost a child: " + std::generic_category().message(errno));
    ProcessEnd end;
    if (WIFSIGNALED(status))
        end.signal = WTERMSIG(status);
    else
        end.exitCode = WEXITSTATUS(status);
    end.cpu = seconds(used.ru_utime) + seconds(used.ru_stime);
    end.peakMemory = 1024.0 * double(used.ru_maxrss);
    return end;
}

} // namespace fpm
