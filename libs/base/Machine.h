#pragma once

#include <string>

namespace fpm {

std::string hostName();
int processNumber();
std::string utcDate(); ///< now, as "2025-01-31T12:00:00Z"

/// Seconds of processor time of this process, all threads together.
double processorSeconds();

} // namespace fpm
