#pragma once

#include "parallel/Kernel.h"

namespace fpm {

/// How the state of one element of a part is kept: so many values in the working type, each of them
/// a tile of its patch, in the order stress of every integration point, hourglass forces; and
/// plastic strains in the type of sums. Elements carry no value that their part has no use for.
struct StateLayout {
    int points;    ///< integration points, 0 for a part without element work
    int hourglass; ///< generalised forces kept
    bool plastic;

    FPM_KERNEL constexpr int stress(int point) const { return 6 * point; }
    FPM_KERNEL constexpr int hourglassForces() const { return 6 * points; }
    FPM_KERNEL constexpr int size() const { return hourglassForces() + hourglass; }
    FPM_KERNEL constexpr int strains() const { return plastic ? points : 0; }
};

} // namespace fpm
