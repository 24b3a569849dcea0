#pragma once

#include "kernels/BlockSum.h"
#include "kernels/contact/distribute/ForceSum.h"
#include "kernels/particle/InteriorNodes.h"
#include "kernels/particle/StepClock.h"

namespace fpm {

/// Bound of the contact springs' squared frequency omega_c^2 in a block of contact nodes: the
/// largest sum of stiffness over mass (Gershgorin).
template <class Motion>
struct ContactLimit {
    Index count;
    const std::int64_t* sum;
    const Index* nodes;
    const Motion* inverseMass; ///< of all nodes
    const std::uint8_t* fixed; ///< as in InteriorNodes
    ForceScale scale;
    double* blockLimit;
    const StepClock* clock;

    static constexpr std::size_t scratch()
    {
        return contactBlock * sizeof(double) + blockSumScratch(1);
    }

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index number) const
    {
        if (!clock->running) return;
        double* values = reinterpret_cast<double*>(team.scratch());
        double* partial = values + contactBlock;
        const Index first = number * contactBlock,
                    size = count - first < contactBlock ? count - first : contactBlock;
        team.forEach(size, [&](Index i) {
            const std::size_t at = std::size_t(first + i), node = std::size_t(nodes[at]);
            const double inverse = fixed[node] & imposedNode ? 0 : double(inverseMass[node]);
            values[i] = -scale.toStiffness(sum[4 * at + 3]) * inverse;
        });
        team.barrier();
        blockMinimum(team, size, values, partial);
        team.barrier();
        double* out = blockLimit + number;
        team.forEach(1, [=](Index) { *out = -blockMinimumResult(partial); });
    }
};

} // namespace fpm
