#pragma once

#include <array>
#include <csignal>
#include <string>

namespace fpm {

/// Catches signals while it lives. SIGINT, SIGTERM, SIGHUP, SIGXCPU ask for the end of the run: a
/// second one ends the program at once. SIGUSR1 asks for a checkpoint, SIGUSR2 for a frame. SIGHUP
/// that was ignored before (nohup) stays ignored.
class SignalWatch
{
public:
    SignalWatch();
    ~SignalWatch();
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;

    /// Something is asked for that is not answered yet.
    bool asks() const;
    /// Name of the signal that asks for the end; empty: none does.
    std::string end() const;
    /// Whether it was asked for since the last time.
    bool takeCheckpoint();
    bool takeFrame();

private:
    std::array<struct sigaction, 6> old_ = {};
};

/// Until a SignalWatch lives, SIGUSR1 and SIGUSR2 mean nothing rather than the end: a run that is
/// being set up has no state yet.
void ignoreRequests();

} // namespace fpm
