#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace fpm {

/// How a program ended and what it took.
struct ProcessEnd {
    int exitCode = 0;      ///< of a program that ended by itself
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

} // namespace fpm
