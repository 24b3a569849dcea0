#pragma once

#include "application/Application.h"

namespace fpm {

/// The work of fpmAdvise: examines the case, prints the advice, and carries out what the options
/// demand.
void advise(Run& run);

/// Its options.
std::vector<Option> adviseOptions();

} // namespace fpm
