#pragma once

#include "kernels/contact/Search.h"
#include "kernels/contact/SearchPlan.h"
#include "parallel/Array.h"
#include "solver/NearBlocks.h"

namespace fpm {

/// What tells when a pass searches, in the executor's memory.
template <class Executor>
struct SearchState {
    std::size_t number; ///< among all passes
    double reach;
    Array<Index, Executor> ownStart, own, nearStart, near, allOwn, allTarget, list;
    Array<BlockSearch, Executor> blocks;

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
        blocks.fromHost(std::vector<BlockSearch>(blocks.size()));
        std::vector<Index> lists = pass.near.blocks;
        const bool grows = lists.size() > near.size();
        if (grows) near = Array<Index, Executor>(lists.size() + lists.size() / 2);
        lists.resize(near.size());
        near.fromHost(lists);
        return grows;
    }

    /// `travel`: see ContactTravel; `horizon`: steps until the next look.
    SearchPlan plan(const double* travel,
                    PassSearch* pass,
                    std::int64_t* late,
                    const StepRules& rules,
                    Index horizon,
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
                travel,
                blocks.data(),
                pass,
                list.data(),
                late,
                rules.growth,
                rules.fixedStep,
                horizon,
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
void planSearches(Executor& executor,
                  const std::vector<SearchPlan>& plans,
                  PassSearch* passes,
                  StepClock* clock)
{
    for (const SearchPlan& plan : plans) {
        executor.parallelFor(plan.blockCount, JudgeBlocks{plan});
        executor.parallelBlocks(1, PlanPass::scratch(), PlanPass{plan});
    }
    executor.parallelFor(1, PlanClock{passes, Index(plans.size()), clock});
}

} // namespace fpm
