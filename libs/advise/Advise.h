#pragma once

#include "case/Case.h"

#include <optional>
#include <string>

namespace fpm {

/// Options of fpmAdvise, as on its command line.
struct AdviseOptions {
    std::optional<std::string> pilot; ///< share of endTime, in (0, 1]: run a copy for results
    bool measure = false;             ///< run the case without and with each piece of advice
    std::optional<std::string> apply; ///< kinds of advice with commas between: write a new case
    std::optional<std::string> to;    ///< its folder; goes with `apply`
};

/// Examines the case, prints the advice, and carries out what the options demand. Throws
/// Error(commandLine) for options that mean nothing.
void advise(const Case& theCase, const AdviseOptions& options, Log& log);

} // namespace fpm
