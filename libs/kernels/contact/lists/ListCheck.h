#pragma once

#include "kernels/BlockSum.h"
#include "kernels/contact/ContactPassView.h"
#include "kernels/contact/lists/ReferenceDisplacement.h"

namespace fpm {

// List check: decides when the Verlet lists of faces per contactor have to be rebuilt. A list stays
// valid while the largest displacement of the contactors plus that of the faces, since the list was
// built and over the steps until the next check, does not exceed the skin (`reach`), as then no
// pair outside the list can have come into contact (Verlet 1967). Each block of contactor nodes is
// checked against the target nodes that were near it when the lists of the whole pass were built:
// contactors far from an impact need no rebuild because of it. One check consists of
// ReferenceDisplacement, BlockListCheck, PassListCheck, ListCheckResult and
// StoreReferencePositions, all on the device; the host is needed only to rebuild all lists of a
// pass.

/// List state of a block of contactors of a pass.
struct BlockListState {
    double displacementBefore; ///< of both sides, from the block's last search to the reference
                               ///< positions
    double displacementSince;  ///< since the reference positions
    double leastBefore, leastSince; ///< lower bounds of the two without rounding: only these count
                                    ///< a list as late
    Index due;                      ///< 1: its lists are rebuilt now
    Index steps;                    ///< steps for which its lists stay valid
};

/// List state of a whole pass.
struct PassListState {
    double displacementBefore;      ///< since its lists were built
    double displacementSince;       ///< since the reference positions
    double leastBefore, leastSince; ///< as in BlockListState
    std::int64_t due;               ///< number of blocks whose lists are rebuilt now
    std::int64_t searches;          ///< number of rebuilds so far
    Index rebuild;                  ///< 1: the host has to rebuild all lists of the pass
    Index rebuilt;                  ///< 1: all lists were built at the present positions
    Index steps;                    ///< steps for which its lists stay valid
};

/// List check of one pass.
struct ListCheck {
    /// Displacement of both sides, in skins, after which all lists of a pass are rebuilt.
    static constexpr double rebuildDistance = 8;
    /// Safety factor on the speed, for acceleration until the next check.
    static constexpr double speedFactor = 1.5;

    double reach;
    Index blockCount;
    const Index *ownStart, *own;   ///< blocks of contact nodes of each block: of its own
                                   ///< contactors,
    const Index *nearStart, *near; ///< and of the target nodes near it: CSR
    Index ownCount, targetCount;   ///< of the whole pass
    const Index *allOwn, *allTarget;
    const double* displacements; ///< as of ReferenceDisplacement
    BlockListState* blocks;
    PassListState* pass;
    Index* list; ///< numbers of the blocks whose lists are rebuilt now
    std::int64_t* late;
    double growth;       ///< largest ratio of successive steps
    double fixedStep;    ///< > 0: all steps have this size, except one that ends at a given time
    Index checkInterval; ///< steps until the next check
    StepClock* clock;

    FPM_KERNEL double timePerStep() const
    {
        return speedFactor * (fixedStep > 0 ? fixedStep : growth * clock->step);
    }
    /// Square of the largest displacement (0), speed (1) or rounding (2) in blocks of contact
    /// nodes.
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
    /// Lower bound of a displacement whose two ends were rounded.
    FPM_KERNEL static double withoutRounding(double displacement, double rounding)
    {
        return displacement > 2 * rounding ? displacement - 2 * rounding : 0;
    }
    /// Number of steps, at most checkInterval, in which a displacement of `each` per step does not
    /// exceed `left`.
    FPM_KERNEL Index stepsWithin(double left, double each) const
    {
        if (each * checkInterval <= left) return checkInterval;
        const double steps = left / each;
        return steps > 0 && steps < checkInterval ? Index(steps) : 0;
    }
};

/// Enters the decision of the last check, then checks the lists of one block. One index = one
/// block.
struct BlockListCheck {
    ListCheck check;

    FPM_KERNEL void operator()(Index number) const
    {
        const ListCheck& p = check;
        BlockListState& block = p.blocks[number];
        if (p.nearStart[number] == p.nearStart[number + 1]) { // no target near: valid until the
                                                              // pass is rebuilt
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
        if (block.leastBefore + block.leastSince > p.reach && !p.pass->rebuilt)
            atomicAdd64(p.late, 1);
        block.steps = p.stepsWithin(p.reach - displacement, each);
        block.due = block.steps < p.checkInterval && !p.pass->rebuilt;
        if (block.due) block.steps = p.stepsWithin(p.reach, each);
    }

private:
    /// Largest value of the block's own contact nodes plus largest of the target nodes near it.
    FPM_KERNEL double ownPlusTarget(Index number, int which) const
    {
        const Index *own = check.ownStart + number, *near = check.nearStart + number;
        return ::sqrt(check.largest(check.own, own[0], own[1], 1, which))
               + ::sqrt(check.largest(check.near, near[0], near[1], 1, which));
    }
};

/// Checks the lists of a whole pass and collects the blocks whose lists are rebuilt. One team.
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
            if (pass->rebuild)
                p.blocks[b].due = 0; // the host rebuilds it with all others
            else
                p.list[atomicAdd64(&pass->due, 1)] = b;
        });
    }

private:
    /// Reduces into a lane the values of the lanes that lie `stride` apart after it.
    FPM_KERNEL static void gather(double* most, Index* least, Index lane, Index stride, Index end)
    {
        for (Index from = lane + stride; from < end; from += stride) {
            if (least[from] < least[lane]) least[lane] = least[from];
            for (Index k = 0; k < sides * displacementValues * lanes; k += lanes)
                if (most[k + from] > most[k + lane]) most[k + lane] = most[k + from];
        }
    }
    /// Largest value of the pass's own nodes plus largest of its target nodes.
    FPM_KERNEL static double ownPlusTarget(const double* most, int which)
    {
        return ::sqrt(most[which * lanes]) + ::sqrt(most[(displacementValues + which) * lanes]);
    }
    /// `most`, `steps`: reduced over all lanes.
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
            && !pass.rebuilt)
            atomicAdd64(p.late, 1);
        const double each = ownPlusTarget(most, 1) * p.timePerStep(),
                     left = (ListCheck::rebuildDistance - 1) * p.reach - pass.displacementBefore
                            - pass.displacementSince;
        // The neighbourhood of blocks has to stay complete only until the next check.
        const Index known = p.stepsWithin(left, each), next = steps > 1 ? steps : 1;
        pass.rebuild = known < next && !pass.rebuilt;
        if (pass.rebuilt && known < steps) steps = known;
        pass.steps = steps;
    }
};

/// Result of the check for the clock: how many steps may follow, at least one. One index.
struct ListCheckResult {
    PassListState* passes;
    Index count; ///< at least one
    StepClock* clock;

    FPM_KERNEL void operator()(Index) const
    {
        Index steps = passes[0].steps, searched = 0, rebuild = 0;
        for (Index k = 0; k < count; ++k) {
            PassListState& pass = passes[k];
            steps = pass.steps < steps ? pass.steps : steps;
            rebuild = rebuild || pass.rebuild;
            searched = searched || pass.rebuild || pass.due > 0;
            pass.searches += pass.due > 0;
        }
        for (Index k = 0; k < count && !rebuild; ++k) passes[k].rebuilt = 0; // a step follows
        clock->searched = searched;
        clock->waits = rebuild;
        clock->listsValidUntil = clock->steps + (rebuild ? 0 : steps > 1 ? steps : 1);
        clock->running = clock->mayStep();
    }
};

} // namespace fpm
