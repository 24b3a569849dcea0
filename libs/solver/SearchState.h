#pragma once

#include "kernels/contact/ListCheck.h"
#include "kernels/contact/Search.h"
#include "parallel/Array.h"
#include "solver/NearBlocks.h"

namespace fpm {

/// What tells when a pass searches, in the executor's memory.
template <class Executor>
struct SearchState {
    std::size_t number; ///< among all passes
    double reach;
    Array<Index, Executor> ownStart, own, nearStart, near, allOwn, allTarget, list;
    Array<BlockListState, Executor> blocks;

    explicit SearchState(const NearBlocks::Pass& pass)
        : number(pass.number),
          reach(pass.reach),
          ownStart(pass.own.starts),
          own(pass.own.blocks),
          nearStart(pass.own.starts.size()),
          allOwn(pass.allOwn),
          allTarget(pass.allTarget),
          list(pass.own.starts.size() - 1),
          blocks(pass.own.starts.size() - 1)
    {
    }

    /// The pass was searched as a whole. True: arrays have moved, see forgetSteps.
    bool arrange(const NearBlocks::Pass& pass)
    {
        nearStart.fromHost(pass.near.starts);
        blocks.fromHost(std::vector<BlockListState>(blocks.size()));
        std::vector<Index> lists = pass.near.blocks;
        const bool grows = lists.size() > near.size();
        if (grows) near = Array<Index, Executor>(lists.size() + lists.size() / 2);
        lists.resize(near.size());
        near.fromHost(lists);
        return grows;
    }

    /// `displacements`: see ReferenceDisplacement; `checkInterval`: steps until the next look.
    ListCheck check(const double* displacements,
                    PassListState* pass,
                    std::int64_t* late,
                    const StepRules& rules,
                    Index checkInterval,
                    StepClock* clock)
    {
        return {reach,
                Index(blocks.size()),
                ownStart.data(),
                own.data(),
                nearStart.data(),
                near.data(),
                Index(allOwn.size()),
                Index(allTarget.size()),
                allOwn.data(),
                allTarget.data(),
                displacements,
                blocks.data(),
                pass,
                list.data(),
                late,
                rules.growth,
                rules.fixedStep,
                checkInterval,
                clock};
    }

    std::size_t bytes() const
    {
        std::size_t sum = blocks.bytes();
        for (const auto* array : {&ownStart, &own, &nearStart, &near, &allOwn, &allTarget, &list})
            sum += array->bytes();
        return sum;
    }
};

/// Judges all passes (plans[k] has passes + k) and tells the clock.
template <class Executor>
void checkLists(Executor& executor,
                const std::vector<ListCheck>& checks,
                PassListState* passes,
                StepClock* clock)
{
    for (const ListCheck& check : checks) {
        executor.parallelFor(check.blockCount, BlockListCheck{check});
        executor.parallelBlocks(1, PassListCheck::scratch(), PassListCheck{check});
    }
    executor.parallelFor(1, ListCheckResult{passes, Index(checks.size()), clock});
}

} // namespace fpm
