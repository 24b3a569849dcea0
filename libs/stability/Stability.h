#pragma once

#include "case/Case.h"

namespace fpm {

/// fpmStability: draws the maps of system/stabilityDict into postProcessing/stability/. Points
/// that an earlier run has finished are kept. `only`: the map to draw; empty: all.
void runStability(const Case& theCase,
                  const Dictionary& dictionary,
                  const std::string& only,
                  int threads,
                  Log& log);

} // namespace fpm
