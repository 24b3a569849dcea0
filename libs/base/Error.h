#pragma once

#include <stdexcept>
#include <string>

namespace fpm {

/// What a utility returns to the shell. 0 only on success, so that `a && b` stops where it should.
enum class ExitCode {
    success = 0,
    commandLine = 2,
    dictionary = 3,
    mesh = 4,
    checkpoint = 5,
    fileIo = 6,
    caseLocked = 7,
    device = 8,
    deviceLost = 9,
    numericalStop = 10,
    unhealthy = 11, ///< fpmExplicit -strict: finished, but a verdict on the run is bad
    memory = 12,
    internal = 70,
    stopped = 75
};

/// A failure the user can act on: what happened, where, and what to do. Caught once, in
/// runApplication.
class Error : public std::runtime_error
{
public:
    Error(ExitCode code, const std::string& message, const std::string& advice = "");
    ExitCode code() const { return code_; }
    /// One hint, may be empty; printed on its own line after the message.
    const std::string& advice() const { return advice_; }

private:
    ExitCode code_;
    std::string advice_;
};

} // namespace fpm
