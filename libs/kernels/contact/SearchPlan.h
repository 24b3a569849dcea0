#pragma once

#include "kernels/BlockSum.h"
#include "kernels/contact/PairView.h"
#include "kernels/contact/Travel.h"

namespace fpm {

// When contactors have to search again. What a search found is valid while no contactor and no face
// can have come closer by more than the reach: by the largest way of the one plus that of the other
// since the search and in the coming steps (method of Verlet). Judged for every block of contactor
// nodes, with those target nodes that were near it when the pass was searched as a whole: what is
// far from an impact does not search for its sake. ContactTravel, JudgeBlocks, PlanPass, PlanClock
// and RememberPositions make one look; it asks the host for nothing but a search of a whole pass.

/// A block of contactors of a pass.
struct BlockSearch {
    double way;            ///< of both sides, between its last search and the remembered positions
    double come;           ///< since those
    double sure, sureCome; ///< of both, what is not rounding: only this can make a list late
    Index due;             ///< 1: it searches now
    Index steps;           ///< for which its list lasts from now on
};

/// A pass as a whole.
struct PassSearch {
    double way;            ///< since it was arranged
    double come;           ///< since the remembered positions
    double sure, sureCome; ///< as BlockSearch
    std::int64_t due;      ///< blocks that search now
    std::int64_t searches; ///< so far
    Index whole;           ///< 1: all of it has to search, by the host, and to be arranged anew
    Index fresh;           ///< 1: arranged at these very positions
    Index steps;           ///< for which its lists last from now on
};

/// One pass as the look sees it.
struct SearchPlan {
    /// Ways of both sides together, in reaches, until a pass is arranged again.
    static constexpr double nearness = 8;
    /// Half as fast again leaves room for acceleration until the next look.
    static constexpr double haste = 1.5;

    double reach;
    Index blockCount;
    const Index *ownStart, *own;   ///< blocks of contact nodes of each block: its own,
    const Index *nearStart, *near; ///< those of the target near it: CSR
    Index ownCount, targetCount;   ///< of the whole pass
    const Index *allOwn, *allTarget;
    const double* travel; ///< see ContactTravel
    BlockSearch* blocks;
    PassSearch* pass;
    Index* list; ///< numbers of the blocks that search now
    std::int64_t* late;
    double growth;    ///< largest ratio of successive steps
    double fixedStep; ///< > 0: they have this size, but for one that meets a time
    Index horizon;    ///< steps until the next look
    StepClock* clock;

    FPM_KERNEL double timePerStep() const
    {
        return haste * (fixedStep > 0 ? fixedStep : growth * clock->step);
    }
    /// Square of the largest way (0), speed (1) or rounding (2) in blocks of contact nodes.
    FPM_KERNEL double
    largest(const Index* numbers, Index begin, Index end, Index stride, int which) const
    {
        double square = 0;
        for (Index k = begin; k < end; k += stride) {
            const double value =
                travel[travelValues * std::size_t(numbers[k]) + std::size_t(which)];
            square = value > square ? value : square;
        }
        return square;
    }
    /// The least distance that a rounded one can stand for: both its ends were rounded.
    FPM_KERNEL static double withoutRounding(double way, double rounding)
    {
        return way > 2 * rounding ? way - 2 * rounding : 0;
    }
    /// How many steps of a way of `each` fit into what is left; horizon at most.
    FPM_KERNEL Index lasting(double left, double each) const
    {
        if (each * horizon <= left) return horizon;
        const double steps = left / each;
        return steps > 0 && steps < horizon ? Index(steps) : 0;
    }
};

/// What the last look decided is entered, then each block judged. One index = one block.
struct JudgeBlocks {
    SearchPlan plan;

    FPM_KERNEL void operator()(Index number) const
    {
        const SearchPlan& p = plan;
        BlockSearch& block = p.blocks[number];
        if (p.nearStart[number] == p.nearStart[number + 1]) { // until the pass is arranged anew
            block = {0, 0, 0, 0, 0, p.horizon};
            return;
        }
        if (p.clock->searched) {
            block.way = block.due ? 0 : block.way + block.come;
            block.sure = block.due ? 0 : block.sure + block.sureCome;
        }
        block.come = both(number, 0);
        block.sureCome = SearchPlan::withoutRounding(block.come, both(number, 2));
        const double each = both(number, 1) * p.timePerStep(), way = block.way + block.come;
        if (block.sure + block.sureCome > p.reach && !p.pass->fresh) atomicAdd64(p.late, 1);
        block.steps = p.lasting(p.reach - way, each);
        block.due = block.steps < p.horizon && !p.pass->fresh;
        if (block.due) block.steps = p.lasting(p.reach, each);
    }

private:
    /// Largest of its own contact nodes plus largest of the target's near it.
    FPM_KERNEL double both(Index number, int which) const
    {
        const Index *own = plan.ownStart + number, *near = plan.nearStart + number;
        return ::sqrt(plan.largest(plan.own, own[0], own[1], 1, which))
               + ::sqrt(plan.largest(plan.near, near[0], near[1], 1, which));
    }
};

/// Judges the pass as a whole and lists the blocks that search. One team.
struct PlanPass {
    SearchPlan plan;

    static constexpr Index lanes = 256, groups = 16;
    static constexpr int sides = 2; ///< own nodes, target nodes
    static constexpr std::size_t scratch()
    {
        return lanes * (sides * travelValues * sizeof(double) + sizeof(Index));
    }

    template <class Team>
    FPM_KERNEL void operator()(const Team& team, Index) const
    {
        const SearchPlan p = plan;
        constexpr Index used = Team::oneThread ? 1 : lanes;
        // [side][value of ContactTravel][lane]
        double* most = reinterpret_cast<double*>(team.scratch());
        Index* least = reinterpret_cast<Index*>(most + sides * travelValues * lanes);
        PassSearch* pass = p.pass;
        team.forEach(1, [=](Index) { pass->due = 0; });
        team.barrier();
        team.forEach(used, [=](Index lane) {
            Index steps = p.horizon;
            for (Index b = lane; b < p.blockCount; b += used)
                if (p.blocks[b].steps < steps) steps = p.blocks[b].steps;
            least[lane] = steps;
            for (int which = 0; which < travelValues; ++which) {
                most[which * lanes + lane] = p.largest(p.allOwn, lane, p.ownCount, used, which);
                most[(travelValues + which) * lanes + lane] =
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
            for (Index k = 0; k < sides * travelValues * lanes; k += lanes)
                if (most[k + from] > most[k + lane]) most[k + lane] = most[k + from];
        }
    }
    /// Largest of the own nodes plus largest of the target's.
    FPM_KERNEL static double both(const double* most, int which)
    {
        return ::sqrt(most[which * lanes]) + ::sqrt(most[(travelValues + which) * lanes]);
    }
    /// `most`, `steps`: of all lanes.
    FPM_KERNEL static void decide(const SearchPlan& p, const double* most, Index steps)
    {
        PassSearch& pass = *p.pass;
        if (p.clock->searched) {
            pass.way += pass.come;
            pass.sure += pass.sureCome;
        }
        pass.come = both(most, 0);
        pass.sureCome = SearchPlan::withoutRounding(pass.come, both(most, 2));
        if (pass.sure + pass.sureCome > SearchPlan::nearness * p.reach && !pass.fresh)
            atomicAdd64(p.late, 1);
        const double each = both(most, 1) * p.timePerStep(),
                     left = (SearchPlan::nearness - 1) * p.reach - pass.way - pass.come;
        // What is near has to be known until the next look alone.
        const Index known = p.lasting(left, each), next = steps > 1 ? steps : 1;
        pass.whole = known < next && !pass.fresh;
        if (pass.fresh && known < steps) steps = known;
        pass.steps = steps;
    }
};

/// What the look found, for the clock: how many steps may follow, at least one. One index.
struct PlanClock {
    PassSearch* passes;
    Index count; ///< one at least
    StepClock* clock;

    FPM_KERNEL void operator()(Index) const
    {
        Index steps = passes[0].steps, searched = 0, whole = 0;
        for (Index k = 0; k < count; ++k) {
            PassSearch& pass = passes[k];
            steps = pass.steps < steps ? pass.steps : steps;
            whole = whole || pass.whole;
            searched = searched || pass.whole || pass.due > 0;
            pass.searches += pass.due > 0;
        }
        for (Index k = 0; k < count && !whole; ++k) passes[k].fresh = 0; // a step follows
        clock->searched = searched;
        clock->waits = whole;
        clock->listsLast = clock->steps + (whole ? 0 : steps > 1 ? steps : 1);
        clock->running = clock->mayStep();
    }
};

} // namespace fpm
