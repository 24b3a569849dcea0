#pragma once

#include "kernels/contact/broad/Search.h"
#include "kernels/contact/distribute/ContactStatus.h"
#include "kernels/contact/edges/EdgeForce.h"
#include "kernels/contact/edges/EdgeStatus.h"
#include "solver/contact/ContactLaunches.h"
#include "solver/contact/EdgeView.h"

namespace fpm {

template <class Numbers, class Executor>
void launchEdges(const LaunchContext<Executor>& on, std::size_t pass, EdgeLaunch what)
{
    PassFields& fields = *on.fields.contact.passes[pass];
    const Index count = Index(fields.contactor.size());
    const EdgePassView<Numbers> edges = edgeView<Numbers>(on, pass);
    switch (what) {
    case EdgeLaunch::forces:
        on.executor.parallelFor(count, TrackEdges<Numbers>{edges});
        on.executor.parallelFor(count, PassEdgesOn<Numbers>{edges});
        on.executor.parallelFor(count, EnterEdges<Numbers>{edges, nodesAtEdges<Numbers>(on, pass)});
        on.executor.parallelBlocks(NodeBlocks::blocks(count), 0, EdgeForce<Numbers>{edges});
        return;
    case EdgeLaunch::measureOverlaps:
        on.executor.parallelFor(count,
                                MeasureEdgeOverlap<Numbers>{edges, nodesAtEdges<Numbers>(on, pass),
                                                            fields.overlap.data()});
        return;
    case EdgeLaunch::status:
        using Sums = StatusSums<EdgeStatus<Numbers>>;
        on.executor.parallelBlocks(NodeBlocks::blocks(count), Sums::scratch(),
                                   Sums{count, {edges}, fields.status.data()});
    }
}

} // namespace fpm
