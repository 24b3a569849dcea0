#pragma once

#include "dictionary/Dictionary.h"
#include "stability/TrialRun.h"

namespace fpm {

/// One side of a map.
struct MapAxis {
    std::string parameter;
    std::vector<double> values; ///< ascending
    bool logarithmic = false;
};

/// One map of system/stabilityDict.
struct MapSpec {
    std::string name;
    std::string scene; ///< of probeScenes(), or case
    MapAxis x, y;
    Setting fixed; ///< what the other parameters are
    TrialLimits limits;
    bool eigenvalue = false; ///< draw the largest eigenvalue's bound
};

/// Reads and checks all maps; unknown words are answered with those that are known. Throws
/// InputError.
std::vector<MapSpec> readStabilityDict(const Dictionary& dictionary);

} // namespace fpm
