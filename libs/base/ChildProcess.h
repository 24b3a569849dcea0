#pragma once

#include "base/Error.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace fpm {

/// How a child ended and what it took.
struct ProcessEnd {
    int exitCode = 0;      ///< of a child that ended by itself
    int signal = 0;        ///< that ended it; 0: none
    bool timedOut = false; ///< killed at the time limit
    double wall = 0;       ///< s
    double cpu = 0;        ///< s, user and system, all threads
    double peakMemory = 0; ///< bytes
    bool succeeded() const { return exitCode == 0 && signal == 0; }
};

/// Holds back Ctrl-C, SIGTERM and SIGHUP during its life, so that a row in progress is completed.
/// One at a time.
class Interrupt
{
public:
    Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;
    ~Interrupt();
    static bool raised();
};

/// Runs `command` (a path and its arguments) in `folder` with its output in `log` and waits for it.
/// It gets SIGTERM when an Interrupt is raised, and dies with this process however that ends, so
/// that no stray run writes where the next one works. It is killed after `timeLimit` seconds.
/// Throws Error(fileIo) when it cannot start.
ProcessEnd runProcess(const std::vector<std::string>& command,
                      const std::filesystem::path& folder,
                      const std::filesystem::path& log,
                      double timeLimit = std::numeric_limits<double>::infinity());

/// Work for a child process, so that a library that crashes on a hostile file takes nothing with
/// it.
struct ChildTask {
    std::string subject; ///< begins the message about a child that dies: "<subject>: rejected, ..."
    ExitCode code;       ///< and this is its code
    std::string advice;
    std::uint64_t memoryBytes = 0; ///< beyond what the parent has; 0: no limit
    std::uint64_t cpuSeconds = 0;  ///< 0: no limit
};

/// Runs `work` in a child process and returns the bytes it returned. An Error thrown by `work` is
/// thrown here again.
std::string inChild(const ChildTask& task, const std::function<std::string()>& work);

/// Waits for a child that ends by itself or has been killed.
ProcessEnd reaped(int child);

} // namespace fpm
