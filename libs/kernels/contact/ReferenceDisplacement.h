#pragma once

#include "kernels/contact/ForceSum.h"
#include "kernels/particle/StepClock.h"
#include "parallel/Precision.h"

namespace fpm {

/// Number of values of ReferenceDisplacement per block of contact nodes.
inline constexpr int displacementValues = 3;

/// Upper bounds of the displacement of the contact nodes from their reference positions, of their
/// speed, and of the rounding error in the former: the largest square in each block of nodes. One
/// index = one block; the result does not depend on the order. Reference positions are kept as the
/// position of the block's first node plus float offsets from it; the rounding of the offsets is
/// added to the displacement. It is large where a block holds nodes of bodies that lie a million
/// element sizes apart.
template <class Numbers>
struct ReferenceDisplacement {
    Index count;
    const Index* nodes;
    const typename Numbers::Position* position;
    const typename Numbers::Motion* velocity;
    std::size_t nodeStride;
    const double* referenceOrigin; ///< [block][3]
    const float* referenceOffset;  ///< three planes of `count`
    double* travel; ///< [block][displacementValues]: displacement, speed, rounding of the former,
                    ///< squared

    /// Relative rounding of a double kept as a float, and of the subtractions around it.
    static constexpr double rounding = 6e-8;

    FPM_KERNEL void operator()(Index block) const
    {
        double distance = 0, speed = 0, most = 0;
        const Index first = contactBlock * block,
                    last = first + contactBlock < count ? first + contactBlock : count;
        for (Index i = first; i < last; ++i) {
            double d2 = 0, v2 = 0, r2 = 0;
            for (int c = 0; c < 3; ++c) {
                const std::size_t at = c * nodeStride + std::size_t(nodes[i]);
                const double offset = double(referenceOffset[c * std::size_t(count) + i]),
                             displacement =
                                 double(position[at]) - referenceOrigin[3 * block + c] - offset,
                             r = rounding * magnitude(offset), d = magnitude(displacement) + r;
                const double v = double(velocity[at]);
                d2 += d * d;
                v2 += v * v;
                r2 += r * r;
            }
            distance = d2 > distance ? d2 : distance;
            speed = v2 > speed ? v2 : speed;
            most = r2 > most ? r2 : most;
        }
        double* out = travel + displacementValues * std::size_t(block);
        out[0] = distance;
        out[1] = speed;
        out[2] = most;
    }
};

/// Stores the reference positions of the contact nodes at a search that the last list check
/// demanded.
template <class Numbers>
struct StoreReferencePositions {
    Index count;
    const Index* nodes;
    const typename Numbers::Position* position;
    std::size_t nodeStride;
    double* referenceOrigin;
    float* referenceOffset;
    const StepClock* clock; ///< null: store unconditionally

    FPM_KERNEL void operator()(Index i) const
    {
        if (clock && !clock->searched) return;
        const Index block = i / contactBlock, first = contactBlock * block;
        for (int c = 0; c < 3; ++c) {
            const typename Numbers::Position* plane = position + c * nodeStride;
            const double origin = double(plane[nodes[first]]);
            referenceOffset[c * std::size_t(count) + i] = float(double(plane[nodes[i]]) - origin);
            if (i == first) referenceOrigin[3 * block + c] = origin;
        }
    }
};

/// Clears the force sums of the contact nodes before contact forces are added; a clock that stands
/// still keeps the forces of its time.
struct ClearContactSum {
    std::int64_t* sum;
    const StepClock* clock;
    FPM_KERNEL void operator()(Index i) const
    {
        if (clock->running) sum[i] = 0;
    }
};

/// values[i] = value.
template <class T>
struct Fill {
    T* values;
    T value;
    FPM_KERNEL void operator()(Index i) const { values[i] = value; }
};

} // namespace fpm
