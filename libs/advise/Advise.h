#pragma once

#include "application/Application.h"

namespace fpm {

/// The work of fpmAdvise: looks, prints what it advises, and does what the options ask for.
void advise(Run& run);

/// Its options.
std::vector<Option> adviseOptions();

} // namespace fpm
