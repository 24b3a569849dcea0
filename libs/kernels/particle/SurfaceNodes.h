#pragma once

#include "kernels/particle/NodeMotion.h"

namespace fpm {

/// NodeMotion of nodes that may meet analytic surfaces exactly; a kernel of its own, since the
/// correction needs many registers.
template <class Numbers>
struct NodeMotionOnSurfaces {
    NodeMotion<Numbers> nodes;

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index block) const
    {
        nodes.template advanceBlock<true>(team, block);
    }
};

/// Reads the contactors of a kinematic pass; each node is one contactor at most.
template <class Numbers>
struct ReadSurface {
    NodeMotion<Numbers> nodes;
    Index count;
    const Index* contactor;
    double* reading; ///< [surfaceReadings][count]

    FPM_KERNEL void operator()(Index i) const
    {
        for (int k = 0; k < surfaceReadings; ++k)
            reading[std::size_t(k) * std::size_t(count) + std::size_t(i)] = 0;
        nodes.reaction(std::size_t(contactor[i]), SurfaceBooks::reading);
    }
};

} // namespace fpm
