#pragma once

#include "application/Application.h"

namespace fpm {

/// fpmStability: draws the maps of system/stabilityDict into postProcessing/stability/. Points
/// that an earlier run has finished are kept. `only`: the map to draw; empty: all.
void runStability(Run& run, const std::string& only, int threads);

} // namespace fpm
