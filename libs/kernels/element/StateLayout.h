#pragma once

#include "parallel/Kernel.h"

namespace fpm {

/// How the state of one element of a part is kept: so many values in the working type, each of them
/// a tile of its patch, in the order stress of every integration point, backstress of every one,
/// hourglass forces; and in the type of sums the plastic strain of every point, then its rise of
/// temperature. Elements carry no value that their part has no use for. A deleted element
/// (Deletion.h) keeps its energy in the place of its first stress.
struct StateLayout {
    int points;    ///< integration points, 0 for a part without element work
    int hourglass; ///< generalised forces kept
    bool plastic;  ///< keeps plastic strain, also where elements may be deleted
    bool kinematic = false;
    bool heats = false;

    FPM_KERNEL constexpr int stress(int point) const { return 6 * point; }
    FPM_KERNEL constexpr int backstress(int point) const { return 6 * (points + point); }
    FPM_KERNEL constexpr int hourglassForces() const
    {
        return kinematic ? 12 * points : 6 * points;
    }
    FPM_KERNEL constexpr int size() const { return hourglassForces() + hourglass; }
    FPM_KERNEL constexpr int strains() const { return plastic ? points : 0; }
    FPM_KERNEL constexpr int temperature(int point) const { return strains() + point; }
    FPM_KERNEL constexpr int sums() const { return strains() + (heats ? points : 0); }
};

} // namespace fpm
