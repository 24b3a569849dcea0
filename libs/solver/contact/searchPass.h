#pragma once

#include "kernels/contact/broad/Search.h"
#include "kernels/contact/lists/ReferenceDisplacement.h"

namespace fpm {

/// Enters the target of a pass into its cells and finds the face of every contactor that searches.
template <class Numbers, class Executor>
void searchPass(Executor& executor,
                const ContactPassView<Numbers>& view,
                const CellLists& cells,
                bool faces,
                const NodeBlocks& blocks)
{
    Index count = view.nodeCount;
    if (blocks.due) {
        count = contactBlock * NodeBlocks::blocks(count);
        if constexpr (Executor::sharesMemory) count = contactBlock * Index(*blocks.due);
    }
    if (count == 0) return;
    const auto overNodes = [&](const auto& kernel) {
        executor.parallelFor(count, InBlocks{blocks, view.nodeCount, kernel});
    };
    const auto over = [&](Index all, const auto& kernel) {
        executor.parallelFor(all, WhereSearched{blocks, kernel});
    };
    over(Index(cells.mask) + cells.levels + 2, Fill<Index>{cells.head, Index(-1)});
    overNodes(ContactorNormal<Numbers>{view});
    if (faces) {
        over(view.faceCount, InsertFace<Numbers>{view, cells});
        overNodes(FindFace<Numbers>{view, cells});
    } else {
        over(view.targetCount, InsertTarget<Numbers>{view, cells});
        overNodes(FindClosestParticle<Numbers>{view, cells});
    }
}

} // namespace fpm
