#pragma once

#include <csignal>

namespace fpm {

/// Catches SIGINT and SIGTERM while it lives; the second one ends the program at once.
class SignalWatch
{
public:
    SignalWatch();
    ~SignalWatch();
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;
    bool raised() const;

private:
    struct sigaction oldInterrupt_ = {}, oldTerminate_ = {};
};

} // namespace fpm
