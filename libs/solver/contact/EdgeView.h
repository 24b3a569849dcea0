#pragma once

#include "kernels/contact/edges/EdgeTracking.h"
#include "solver/contact/PassView.h"

namespace fpm {

/// A pass of sharp edges as kernels see it.
template <class Numbers, class Executor>
[[gnu::always_inline]] inline EdgePassView<Numbers> edgeView(const LaunchContext<Executor>& on,
                                                             std::size_t pass)
{
    const ContactPassSetup& setUp = on.setUp.contact.passes[pass];
    PassFields& f = *on.fields.contact.passes[pass];
    EdgePassView<Numbers> v{};
    v.pass = passView<Numbers>(on, pass);
    v.node = f.edgeNode.data();
    v.next = f.edgeNext.data();
    v.firstTarget = setUp.firstTarget;
    v.queryHalf = typename Numbers::Work(setUp.queryHalf);
    v.state = f.edgeState.data();
    v.phase = f.edgePhase.data();
    v.passedOn = f.passedOn.data();
    return v;
}

/// The passes of nodes against faces beside a pass of edges.
template <class Numbers, class Executor>
[[gnu::always_inline]] inline NodesAtEdges<Numbers> nodesAtEdges(const LaunchContext<Executor>& on,
                                                                 std::size_t pass)
{
    const ContactPassSetup& setUp = on.setUp.contact.passes[pass];
    PassFields& f = *on.fields.contact.passes[pass];
    NodesAtEdges<Numbers> nodes{};
    const Index* ends[2] = {f.firstEnds.data(), f.secondEnds.data()};
    for (std::size_t k = 0; k < 2; ++k)
        if (const Index number = setUp.nodePasses[k].number; number >= 0)
            nodes.side[k] = {ends[k], passView<Numbers>(on, std::size_t(number))};
    return nodes;
}

} // namespace fpm
