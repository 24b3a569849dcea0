#pragma once

#include "kernels/particle/NodeMotion.h"
#include "solver/backend/LaunchContext.h"

namespace fpm {

/// All nodes, as kernels see them.
template <class Numbers, class Executor>
[[gnu::always_inline]] inline NodeMotion<Numbers> nodeView(const LaunchContext<Executor>& on)
{
    using Motion = typename Numbers::Motion;
    using Work = typename Numbers::Work;
    const NodeSetUp& setUp = on.setUp.nodes;
    NodeFields& n = on.fields.nodes;
    ElementFields& e = on.fields.elements;
    ContactFields& c = on.fields.contact;
    return {.nodeCount = setUp.count,
            .list = nullptr,
            .position = n.position.data<typename Numbers::Position>(),
            .velocity = n.velocity.data<Motion>(),
            .inverseMass = n.inverseMass.data<Motion>(),
            .nodeStride = std::size_t(setUp.count),
            .interiorForce = e.interiorForce.data<Work>(),
            .interiorEnd = std::size_t(setUp.interiorEnd),
            .firstBoundaryNode = std::size_t(setUp.firstBoundaryNode),
            .partialSumsStart = n.partialSumsStart.data(),
            .partialSums = n.partialSums.data(),
            .partialForce = e.partialForce.data<Work>(),
            .fixed = n.fixed.data(),
            .contactNode = c.numberOf.data(),
            .contactForce = c.sum.data(),
            .contactScale = on.setUp.contact.scale,
            .surfaces = {c.surfaceStart.data(), c.surfaceUses.data(), c.kinematicPasses.data(),
                         n.amplitudeRows.data()},
            .conditionStart = n.conditionStart.data(),
            .uses = n.uses.data(),
            .conditions = n.conditions.data(),
            .amplitudeRows = n.amplitudeRows.data(),
            .frameOf = n.frameOf.data(),
            .frames = n.frames.data(),
            .pressureStart = n.pressureStart.data(),
            .pressureSlots = n.pressureSlots.data(),
            .pressureForce = n.pressureForce.data<Motion>(),
            .pressureStride = setUp.pressureFaceNode.size(),
            .massDamping = Motion(on.settings.massDamping),
            .ledger = on.settings.ledger,
            .blockWork = n.blockWork.data(),
            .clock = on.fields.clock.clock.data()};
}

} // namespace fpm
