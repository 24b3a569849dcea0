#pragma once

#include "kernels/BlockSum.h"
#include "kernels/particle/StepClock.h"
#include "parallel/LaunchSizes.h"

namespace fpm {

/// Smallest element step and largest contact frequency of all blocks, then the next step. One team.
struct StepClockUpdate {
    const double* patchStep;
    Index patchCount;
    const double* contactBound; ///< [block of contact nodes], squared frequency of the springs
    Index contactCount;
    const double* bodyBound; ///< likewise of each rigid body
    Index bodyCount;
    StepRules rules;
    StepClock* clock;

    static constexpr std::size_t scratch()
    {
        return 2 * (reductionLanes + reductionGroups) * sizeof(double);
    }

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index) const
    {
        constexpr Index lanes = Team::oneThread ? 1 : reductionLanes,
                        groups = Team::oneThread ? 1 : reductionGroups;
        double* bounds = reinterpret_cast<double*>(team.scratch());
        double* ofGroup = bounds + 2 * lanes;
        const Bounds elements{patchStep, patchCount}, contact{contactBound, contactCount},
            bodies{bodyBound, bodyCount};
        team.forEach(lanes, [=](Index lane) {
            bounds[lane] = elements.least(lane, lanes);
            const double touch = contact.most(lane, lanes), body = bodies.most(lane, lanes);
            bounds[lanes + lane] = body > touch ? body : touch;
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
