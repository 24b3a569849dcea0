#pragma once

#include "kernels/contact/distribute/ForceSum.h"
#include "kernels/particle/StepClock.h"
#include "parallel/Precision.h"

namespace fpm {

/// Number of values of ReferenceDisplacement per block of contact nodes.
inline constexpr int displacementValues = 3;

/// Upper bounds of the displacement of the contact nodes from their reference positions, of their
/// speed, and of the rounding error in the former: the largest square in each block of nodes. One
/// team = one block; the result does not depend on the order. Reference positions are kept as the
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

    static constexpr std::size_t scratch()
    {
        return displacementValues * (contactBlock + reductionGroups) * sizeof(double);
    }

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index block) const
    {
        constexpr Index lanes = Team::oneThread ? 1 : contactBlock,
                        groups = Team::oneThread ? 1 : reductionGroups;
        double* ofLane = reinterpret_cast<double*>(team.scratch()); // [value][lane]
        double* ofGroup = ofLane + displacementValues * lanes;
        const Index first = contactBlock * block,
                    last = first + contactBlock < count ? first + contactBlock : count;
        team.forEach(lanes, [&](Index lane) {
            double most[displacementValues] = {};
            for (Index i = first + lane; i < last; i += lanes) include(i, block, most);
            for (int k = 0; k < displacementValues; ++k) ofLane[k * lanes + lane] = most[k];
        });
        team.barrier();
        team.forEach(displacementValues * groups, [=](Index k) {
            ofGroup[k] = largest(ofLane + k / groups * lanes, k % groups, lanes, groups);
        });
        team.barrier();
        double* out = travel + displacementValues * std::size_t(block);
        team.forEach(displacementValues,
                     [=](Index k) { out[k] = largest(ofGroup + k * groups, 0, groups, 1); });
    }

private:
    FPM_KERNEL void include(Index i, Index block, double (&most)[displacementValues]) const
    {
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
        most[0] = d2 > most[0] ? d2 : most[0];
        most[1] = v2 > most[1] ? v2 : most[1];
        most[2] = r2 > most[2] ? r2 : most[2];
    }
    FPM_KERNEL static double largest(const double* values, Index first, Index end, Index stride)
    {
        double most = 0;
        for (Index i = first; i < end; i += stride) most = values[i] > most ? values[i] : most;
        return most;
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
