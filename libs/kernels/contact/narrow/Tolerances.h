#pragma once

#include "parallel/Kernel.h"

namespace fpm {

/// All tolerances of the narrow phase. Lengths are relative: to natural coordinates, to the
/// diagonal of a face or to a distance.
template <class Work>
struct ContactTolerances {
    static constexpr bool isDouble = sizeof(Work) == 8;

    /// Border of a face in natural coordinates: wider than rounding, but no wider, or a contactor
    /// would be kept on a face although the next one is nearer.
    static constexpr Work border = Work(isDouble ? 1e-12 : 1e-5);
    /// Newton's method has converged: the next step would have the order of the square of this one.
    static constexpr Work projected = Work(isDouble ? 1e-7 : 1e-4);
    /// Square of the ratio of a distance to a face's diagonal below which its direction is
    /// rounding.
    static constexpr Work noDirection = Work(isDouble ? 1e-20 : 1e-8);
    /// Square of the sine of the angle between a point's offset and an edge's inward tangent, above
    /// which a point inside the face is nearer.
    static constexpr Work inwards = Work(isDouble ? 1e-16 : 1e-8);
    /// Factor of a squared distance: what is nearer by no more than this is as near.
    static constexpr Work nearer = Work(1) - Work(isDouble ? 1e-12 : 1e-5);
    /// Deviation from symmetry up to which two distances count as equal: larger than what rounding
    /// makes of a symmetric model during a run. With the square of the rounding of positions.
    static constexpr Work symmetric = Work(isDouble ? 1e-5 : 1e-4);
    static constexpr Work positionSquare = Work(isDouble ? 1e-20 : 1e-12);
    /// Distance of projection points, to the diagonal, from which on they are two.
    static constexpr Work distinct = Work(isDouble ? 1e-13 : 1e-6);
    /// Square of the sine of the angle between neighbours below which they are one plane.
    static constexpr Work bend = Work(isDouble ? 1e-20 : 1e-10);
    /// Shares of a ridge's faces are found.
    static constexpr Work shares = Work(isDouble ? 1e-13 : 1e-6);

    /// Faces meet at a sharp edge where n_1 . n_2 is below this, 60 degrees.
    static constexpr Work sharp = Work(0.5);
    /// A contactor that comes over a sharp edge no lower than this fraction of the width of the
    /// face below it is lifted, not stopped (EdgeLift).
    static constexpr Work lift = Work(0.05);
    /// Faces oppose a contactor where n . n_c is below this.
    static constexpr Work opposing = Work(-0.01);
    /// Fraction of half the face's width by which a contactor may lie beyond a free edge and stay
    /// in contact: wider than rounding and the chords of a round rim.
    static constexpr Work beyondEdge = Work(0.02);
};

} // namespace fpm
