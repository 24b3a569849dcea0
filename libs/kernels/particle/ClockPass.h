#pragma once

#include "kernels/BlockSum.h"
#include "kernels/particle/StepClock.h"

namespace fpm {

/// Smallest element step and largest contact frequency of all blocks, then the next step. One team.
struct ClockPass {
    const double* patchStep;
    Index patchCount;
    const double* contactLimit;
    Index limitCount;
    StepRules rules;
    StepClock* clock;

    static constexpr std::size_t scratch() { return blockSumScratch(2) + 64; }

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index) const
    {
        double* partial = reinterpret_cast<double*>(team.scratch());
        const double *steps = patchStep, *limits = contactLimit;
        const Index patches = patchCount, contacts = limitCount;
        blockMinimum(team, patches, steps, partial);
        team.forEach(blockSumLanes, [=](Index lane) {
            double most = 0;
            for (Index i = lane; i < contacts; i += blockSumLanes)
                most = limits[i] > most ? limits[i] : most;
            partial[blockSumLanes + lane] = most;
        });
        team.barrier();
        StepClock* out = clock;
        const StepRules how = rules;
        team.forEach(1, [=](Index) {
            double contactSquare = 0;
            for (int lane = 0; lane < blockSumLanes; ++lane)
                if (partial[blockSumLanes + lane] > contactSquare)
                    contactSquare = partial[blockSumLanes + lane];
            advanceClock(*out, how, blockMinimumResult(partial), contactSquare);
        });
    }
};

} // namespace fpm
