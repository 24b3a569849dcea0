#pragma once

#include "kernels/contact/broad/Search.h"
#include "kernels/contact/edges/EdgeSearch.h"
#include "kernels/contact/lists/ReferenceDisplacement.h"

namespace fpm {

/// Nodes or segments of a pass to launch a search for.
template <class Executor>
Index searched(Index nodeCount, const NodeBlocks& blocks)
{
    if (!blocks.due) return nodeCount;
    if constexpr (Executor::sharesMemory) return contactBlock * Index(*blocks.due);
    return contactBlock * NodeBlocks::blocks(nodeCount);
}

/// Enters the target of a pass into its cells and finds the face of every contactor that searches.
template <class Numbers, class Executor>
void searchPass(Executor& executor,
                const ContactPassView<Numbers>& view,
                const CellLists& cells,
                bool faces,
                const NodeBlocks& blocks)
{
    const Index count = searched<Executor>(view.nodeCount, blocks);
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

/// The same for the segments of a pass of sharp edges.
template <class Numbers, class Executor>
void searchEdges(Executor& executor,
                 const EdgePassView<Numbers>& view,
                 const CellLists& cells,
                 const NodeBlocks& blocks)
{
    const Index count = searched<Executor>(view.pass.nodeCount, blocks);
    if (count == 0) return;
    executor.parallelFor(Index(cells.mask) + cells.levels + 2,
                         WhereSearched{blocks, Fill<Index>{cells.head, Index(-1)}});
    executor.parallelFor(view.pass.faceCount,
                         WhereSearched{blocks, InsertEdge<Numbers>{view, cells}});
    executor.parallelFor(count,
                         InBlocks{blocks, view.pass.nodeCount, FindEdges<Numbers>{view, cells}});
}

} // namespace fpm
