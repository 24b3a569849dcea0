#include "base/ChildProcess.h"
#include "base/Error.h"
#include "base/Format.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>

namespace fpm {

namespace {

constexpr std::array watched{SIGINT, SIGTERM, SIGHUP};
constexpr int cannotStart = 127;

// A signal handler reaches nothing but such a variable.
volatile std::sig_atomic_t interruption = 0;
std::array<struct sigaction, watched.size()> previous;

extern "C" void noteInterruption(int signal)
{
    interruption = signal;
}

/// Only what is allowed between fork and exec.
[[noreturn]] void become(char* const* arguments, const char* folder, int log, pid_t parent)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent || chdir(folder) != 0) _exit(cannotStart);
    const int nothing = open("/dev/null", O_RDONLY);
    if (nothing < 0 || dup2(nothing, STDIN_FILENO) < 0 || dup2(log, STDOUT_FILENO) < 0
        || dup2(log, STDERR_FILENO) < 0)
        _exit(cannotStart);
    execv(arguments[0], arguments);
    _exit(cannotStart);
}

/// Until it ends, or kills it at the deadline: then true.
bool waitUntil(pid_t child, std::chrono::steady_clock::time_point deadline)
{
    const int watch = int(syscall(SYS_pidfd_open, child, 0));
    if (watch < 0)
        throw Error(ExitCode::internal,
                    "cannot watch a child: " + std::generic_category().message(errno));
    bool passedOn = false, timedOut = false;
    for (pollfd one{watch, POLLIN, 0}; !timedOut;) {
        if (Interrupt::raised() && !passedOn) {
            kill(child, SIGTERM);
            passedOn = true;
        }
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(
            deadline - std::chrono::steady_clock::now());
        // An interruption just before the wait is seen after it.
        constexpr long long longest = 1000;
        const int ready = poll(&one, 1, int(std::clamp<long long>(left.count(), 0, longest)));
        if (ready > 0) break;
        timedOut = ready == 0 && std::chrono::steady_clock::now() >= deadline;
    }
    if (timedOut) kill(child, SIGKILL);
    close(watch);
    return timedOut;
}

} // namespace

Interrupt::Interrupt()
{
    interruption = 0;
    struct sigaction action = {};
    action.sa_handler = noteInterruption;
    for (std::size_t i = 0; i < watched.size(); ++i) sigaction(watched[i], &action, &previous[i]);
}

Interrupt::~Interrupt()
{
    for (std::size_t i = 0; i < watched.size(); ++i) sigaction(watched[i], &previous[i], nullptr);
}

bool Interrupt::raised()
{
    return interruption != 0;
}

ProcessEnd runProcess(const std::vector<std::string>& command,
                      const std::filesystem::path& folder,
                      const std::filesystem::path& log,
                      double timeLimit)
{
    const int output =
        open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (output < 0)
        throw Error(ExitCode::fileIo, format("cannot write {}: {}", log.string(),
                                             std::generic_category().message(errno)));
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const std::string place = folder.string();

    const auto start = std::chrono::steady_clock::now();
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child == 0) become(arguments.data(), place.c_str(), output, parent);
    close(output);
    if (child < 0)
        throw Error(ExitCode::memory,
                    "no further process: " + std::generic_category().message(errno));
    // A month is as good as never, and no overflow of the clock.
    const auto allowed = std::chrono::duration<double>(std::min(timeLimit, 2.6e6));
    const bool late = waitUntil(
        child, start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(allowed));
    ProcessEnd end = reaped(child);
    end.timedOut = late && end.signal == SIGKILL;
    end.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (end.exitCode == cannotStart)
        throw Error(ExitCode::fileIo, format("cannot start {}", command.front()));
    return end;
}

} // namespace fpm
