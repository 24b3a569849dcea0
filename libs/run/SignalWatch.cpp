#include "run/SignalWatch.h"

namespace fpm {

namespace {

struct Caught {
    int number;
    const char* name;
};
/// Those that end a run, then those that ask for something.
constexpr std::array<Caught, 6> caught{{{SIGINT, "SIGINT"},
                                        {SIGTERM, "SIGTERM"},
                                        {SIGHUP, "SIGHUP"},
                                        {SIGXCPU, "SIGXCPU"},
                                        {SIGUSR1, "SIGUSR1"},
                                        {SIGUSR2, "SIGUSR2"}}};

/// The only things a signal handler may touch.
volatile std::sig_atomic_t endSignal = 0, checkpointAsked = 0, frameAsked = 0;

extern "C" void noteSignal(int signal)
{
    if (signal == SIGUSR1)
        checkpointAsked = 1;
    else if (signal == SIGUSR2)
        frameAsked = 1;
    else if (endSignal == 0)
        endSignal = signal;
    else { // the second one: whoever sends it does not want to wait
        struct sigaction plain = {};
        plain.sa_handler = SIG_DFL;
        sigaction(signal, &plain, nullptr);
        raise(signal);
    }
}

} // namespace

SignalWatch::SignalWatch()
{
    endSignal = 0;
    checkpointAsked = 0;
    frameAsked = 0;
    struct sigaction action = {};
    action.sa_handler = noteSignal;
    action.sa_flags = SA_RESTART; // no read or write of the run is cut short
    for (std::size_t i = 0; i < caught.size(); ++i) {
        sigaction(caught[i].number, nullptr, &old_[i]);
        if (caught[i].number == SIGHUP && old_[i].sa_handler == SIG_IGN) continue;
        sigaction(caught[i].number, &action, nullptr);
    }
}

SignalWatch::~SignalWatch()
{
    for (std::size_t i = 0; i < caught.size(); ++i) sigaction(caught[i].number, &old_[i], nullptr);
}

bool SignalWatch::asks() const
{
    return endSignal != 0 || checkpointAsked != 0 || frameAsked != 0;
}

std::string SignalWatch::end() const
{
    for (const Caught& one : caught)
        if (one.number == endSignal) return one.name;
    return "";
}

bool SignalWatch::takeCheckpoint()
{
    const bool asked = checkpointAsked != 0;
    checkpointAsked = 0;
    return asked;
}

bool SignalWatch::takeFrame()
{
    const bool asked = frameAsked != 0;
    frameAsked = 0;
    return asked;
}

void ignoreRequests()
{
    struct sigaction ignore = {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGUSR1, &ignore, nullptr);
    sigaction(SIGUSR2, &ignore, nullptr);
}

} // namespace fpm
