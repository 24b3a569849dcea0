#pragma once

#include <string>

namespace fpm {

std::string hostName();
int processNumber();
std::string utcDate(); ///< now, as "2025-01-31T12:00:00Z"

/// Seconds of processor time of this process, all threads together.
double processorSeconds();

/// Lets a reader of our output leave without killing us, and keeps files we open from taking the
/// number of a standard stream that was closed before we started.
void protectStandardStreams();

} // namespace fpm
