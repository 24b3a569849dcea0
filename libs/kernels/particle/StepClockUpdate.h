#pragma once

#include "kernels/BlockSum.h"
#include "kernels/particle/StepClock.h"

namespace fpm {

/// Smallest element step and largest contact frequency of all blocks, then the next step. One team.
struct StepClockUpdate {
    const double* patchStep;
    Index patchCount;
    const double* contactLimit;
    Index limitCount;
    StepRules rules;
    StepClock* clock;

    /// Minimum and maximum do not depend on the order: as many lanes as there are threads.
    static constexpr Index mostLanes = 256;
    static constexpr std::size_t scratch() { return 2 * (mostLanes + 16) * sizeof(double); }

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index) const
    {
        constexpr Index lanes = Team::oneThread ? 1 : mostLanes, groups = Team::oneThread ? 1 : 16;
        double* bounds = reinterpret_cast<double*>(team.scratch());
        double* ofGroup = bounds + 2 * lanes;
        const Bounds elements{patchStep, patchCount}, contact{contactLimit, limitCount};
        team.forEach(lanes, [=](Index lane) {
            bounds[lane] = elements.least(lane, lanes);
            bounds[lanes + lane] = contact.most(lane, lanes);
        });
        team.barrier();
        team.forEach(groups, [=](Index group) {
            ofGroup[group] = Bounds{bounds, lanes}.least(group, groups);
            ofGroup[groups + group] = Bounds{bounds + lanes, lanes}.most(group, groups);
        });
        team.barrier();
        StepClock* out = clock;
        const StepRules how = rules;
        team.forEach(1, [=](Index) {
            advanceClock(*out, how, Bounds{ofGroup, groups}.least(0, 1),
                         Bounds{ofGroup + groups, groups}.most(0, 1));
        });
    }

private:
    struct Bounds {
        const double* values;
        Index count;

        /// A NaN anywhere gives -1.
        FPM_KERNEL double least(Index first, Index stride) const
        {
            double result = 1e300;
            for (Index i = first; i < count; i += stride)
                result = values[i] == values[i] ? (values[i] < result ? values[i] : result) : -1.0;
            return result;
        }
        FPM_KERNEL double most(Index first, Index stride) const
        {
            double result = 0;
            for (Index i = first; i < count; i += stride)
                result = values[i] > result ? values[i] : result;
            return result;
        }
    };
};

} // namespace fpm
