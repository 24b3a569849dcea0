#pragma once

#include "kernels/BlockSum.h"
#include "kernels/contact/ContactPassView.h"
#include "kernels/contact/ReferenceDisplacement.h"

namespace fpm {

// When contactors have to search again. What a search found is valid while no contactor and no face
// can have come closer by more than the reach: by the largest way of the one plus that of the other
// since the search and in the coming steps (method of Verlet). Judged for every block of contactor
// nodes, with those target nodes that were near it when the pass was searched as a whole: what is
// far from an impact does not search for its sake. ReferenceDisplacement, BlockListCheck,
// PassListCheck, ListCheckResult and StoreReferencePositions make one look; it asks the host for
// nothing but a search of a whole pass.

/// A block of contactors of a pass.
struct BlockListState {
    double displacementBefore; ///< of both sides, from its last search to the reference positions
    double displacementSince;  ///< since those
    double leastBefore, leastSince; ///< likewise, but for rounding: only this makes a list late
    Index due;                      ///< 1: it searches now
    Index steps;                    ///< for which its list lasts from now on
};

/// A pass as a whole.
struct PassListState {
    double displacementBefore;      ///< since it was arranged
    double displacementSince;       ///< since the remembered positions
    double leastBefore, leastSince; ///< as BlockListState
    std::int64_t due;               ///< blocks that search now
    std::int64_t searches;          ///< so far
    Index whole; ///< 1: all of it has to search, by the host, and to be arranged anew
    Index fresh; ///< 1: arranged at these very positions
    Index steps; ///< for which its lists last from now on
};

/// One pass as the look sees it.
struct ListCheck {
    /// Ways of both sides together, in reaches, until a pass is arranged again.
    static constexpr double rebuildDistance = 8;
    /// Half as fast again leaves room for acceleration until the next look.
    static constexpr double speedFactor = 1.5;

    double reach;
    Index blockCount;
    const Index *ownStart, *own;   ///< blocks of contact nodes of each block: its own,
    const Index *nearStart, *near; ///< those of the target near it: CSR
    Index ownCount, targetCount;   ///< of the whole pass
    const Index *allOwn, *allTarget;
    const double* displacements; ///< see ReferenceDisplacement
    BlockListState* blocks;
    PassListState* pass;
    Index* list; ///< numbers of the blocks that search now
    std::int64_t* late;
    double growth;       ///< largest ratio of successive steps
    double fixedStep;    ///< > 0: they have this size, but for one that meets a time
    Index checkInterval; ///< steps until the next look
    StepClock* clock;

    FPM_KERNEL double timePerStep() const
    {
        return speedFactor * (fixedStep > 0 ? fixedStep : growth * clock->step);
    }
    /// Square of the largest way (0), speed (1) or rounding (2) in blocks of contact nodes.
    FPM_KERNEL double
    largest(const Index* numbers, Index begin, Index end, Index stride, int which) const
    {
        double square = 0;
        for (Index k = begin; k < end; k += stride) {
            const double value =
                displacements[displacementValues * std::size_t(numbers[k]) + std::size_t(which)];
            square = value > square ? value : square;
        }
        return square;
    }
    /// The least distance that a rounded one can stand for: both its ends were rounded.
    FPM_KERNEL static double withoutRounding(double displacement, double rounding)
    {
        return displacement > 2 * rounding ? displacement - 2 * rounding : 0;
    }
    /// How many steps of a way of `each` fit into what is left; horizon at most.
    FPM_KERNEL Index stepsWithin(double left, double each) const
    {
        if (each * checkInterval <= left) return checkInterval;
        const double steps = left / each;
        return steps > 0 && steps < checkInterval ? Index(steps) : 0;
    }
};

/// What the last look decided is entered, then each block judged. One index = one block.
struct BlockListCheck {
    ListCheck check;

    FPM_KERNEL void operator()(Index number) const
    {
        const ListCheck& p = check;
        BlockListState& block = p.blocks[number];
        if (p.nearStart[number] == p.nearStart[number + 1]) { // until the pass is arranged anew
            block = {0, 0, 0, 0, 0, p.checkInterval};
            return;
        }
        if (p.clock->searched) {
            block.displacementBefore =
                block.due ? 0 : block.displacementBefore + block.displacementSince;
            block.leastBefore = block.due ? 0 : block.leastBefore + block.leastSince;
        }
        block.displacementSince = ownPlusTarget(number, 0);
        block.leastSince =
            ListCheck::withoutRounding(block.displacementSince, ownPlusTarget(number, 2));
        const double each = ownPlusTarget(number, 1) * p.timePerStep(),
                     displacement = block.displacementBefore + block.displacementSince;
        if (block.leastBefore + block.leastSince > p.reach && !p.pass->fresh)
            atomicAdd64(p.late, 1);
        block.steps = p.stepsWithin(p.reach - displacement, each);
        block.due = block.steps < p.checkInterval && !p.pass->fresh;
        if (block.due) block.steps = p.stepsWithin(p.reach, each);
    }

private:
    /// Largest of its own contact nodes plus largest of the target's near it.
    FPM_KERNEL double ownPlusTarget(Index number, int which) const
    {
        const Index *own = check.ownStart + number, *near = check.nearStart + number;
        return ::sqrt(check.largest(check.own, own[0], own[1], 1, which))
               + ::sqrt(check.largest(check.near, near[0], near[1], 1, which));
    }
};

/// Judges the pass as a whole and lists the blocks that search. One team.
struct PassListCheck {
    ListCheck check;

    static constexpr Index lanes = reductionLanes, groups = reductionGroups;
    static constexpr int sides = 2; ///< own nodes, target nodes
    static constexpr std::size_t scratch()
    {
        return lanes * (sides * displacementValues * sizeof(double) + sizeof(Index));
    }

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index) const
    {
        const ListCheck p = check;
        constexpr Index used = Team::oneThread ? 1 : lanes;
        // [side][value of ReferenceDisplacement][lane]
        double* most = reinterpret_cast<double*>(team.scratch());
        Index* least = reinterpret_cast<Index*>(most + sides * displacementValues * lanes);
        PassListState* pass = p.pass;
        team.forEach(1, [=](Index) { pass->due = 0; });
        team.barrier();
        team.forEach(used, [=](Index lane) {
            Index steps = p.checkInterval;
            for (Index b = lane; b < p.blockCount; b += used)
                if (p.blocks[b].steps < steps) steps = p.blocks[b].steps;
            least[lane] = steps;
            for (int which = 0; which < displacementValues; ++which) {
                most[which * lanes + lane] = p.largest(p.allOwn, lane, p.ownCount, used, which);
                most[(displacementValues + which) * lanes + lane] =
                    p.largest(p.allTarget, lane, p.targetCount, used, which);
            }
        });
        team.barrier();
        team.forEach(used < groups ? used : groups,
                     [=](Index group) { gather(most, least, group, groups, used); });
        team.barrier();
        team.forEach(1, [=](Index) {
            gather(most, least, 0, 1, used < groups ? used : groups);
            decide(p, most, least[0]);
        });
        team.barrier();
        team.forEach(p.blockCount, [=](Index b) {
            if (!p.blocks[b].due) return;
            if (pass->whole)
                p.blocks[b].due = 0; // the host searches it with all others
            else
                p.list[atomicAdd64(&pass->due, 1)] = b;
        });
    }

private:
    /// Into a lane, those that lie `stride` apart after it.
    FPM_KERNEL static void gather(double* most, Index* least, Index lane, Index stride, Index end)
    {
        for (Index from = lane + stride; from < end; from += stride) {
            if (least[from] < least[lane]) least[lane] = least[from];
            for (Index k = 0; k < sides * displacementValues * lanes; k += lanes)
                if (most[k + from] > most[k + lane]) most[k + lane] = most[k + from];
        }
    }
    /// Largest of the own nodes plus largest of the target's.
    FPM_KERNEL static double ownPlusTarget(const double* most, int which)
    {
        return ::sqrt(most[which * lanes]) + ::sqrt(most[(displacementValues + which) * lanes]);
    }
    /// `most`, `steps`: of all lanes.
    FPM_KERNEL static void decide(const ListCheck& p, const double* most, Index steps)
    {
        PassListState& pass = *p.pass;
        if (p.clock->searched) {
            pass.displacementBefore += pass.displacementSince;
            pass.leastBefore += pass.leastSince;
        }
        pass.displacementSince = ownPlusTarget(most, 0);
        pass.leastSince =
            ListCheck::withoutRounding(pass.displacementSince, ownPlusTarget(most, 2));
        if (pass.leastBefore + pass.leastSince > ListCheck::rebuildDistance * p.reach
            && !pass.fresh)
            atomicAdd64(p.late, 1);
        const double each = ownPlusTarget(most, 1) * p.timePerStep(),
                     left = (ListCheck::rebuildDistance - 1) * p.reach - pass.displacementBefore
                            - pass.displacementSince;
        // What is near has to be known until the next look alone.
        const Index known = p.stepsWithin(left, each), next = steps > 1 ? steps : 1;
        pass.whole = known < next && !pass.fresh;
        if (pass.fresh && known < steps) steps = known;
        pass.steps = steps;
    }
};

/// What the look found, for the clock: how many steps may follow, at least one. One index.
struct ListCheckResult {
    PassListState* passes;
    Index count; ///< one at least
    StepClock* clock;

    FPM_KERNEL void operator()(Index) const
    {
        Index steps = passes[0].steps, searched = 0, whole = 0;
        for (Index k = 0; k < count; ++k) {
            PassListState& pass = passes[k];
            steps = pass.steps < steps ? pass.steps : steps;
            whole = whole || pass.whole;
            searched = searched || pass.whole || pass.due > 0;
            pass.searches += pass.due > 0;
        }
        for (Index k = 0; k < count && !whole; ++k) passes[k].fresh = 0; // a step follows
        clock->searched = searched;
        clock->waits = whole;
        clock->listsValidUntil = clock->steps + (whole ? 0 : steps > 1 ? steps : 1);
        clock->running = clock->mayStep();
    }
};

} // namespace fpm
