#include "run/SignalWatch.h"

namespace fpm {

namespace {

/// The only thing a signal handler may touch.
volatile std::sig_atomic_t stopSignal = 0;

extern "C" void noteSignal(int signal)
{
    stopSignal = signal;
}

} // namespace

SignalWatch::SignalWatch()
{
    struct sigaction action = {};
    action.sa_handler = noteSignal;
    action.sa_flags = int(SA_RESETHAND);
    stopSignal = 0;
    sigaction(SIGINT, &action, &oldInterrupt_);
    sigaction(SIGTERM, &action, &oldTerminate_);
}

SignalWatch::~SignalWatch()
{
    sigaction(SIGINT, &oldInterrupt_, nullptr);
    sigaction(SIGTERM, &oldTerminate_, nullptr);
}

bool SignalWatch::raised() const
{
    return stopSignal != 0;
}

} // namespace fpm
