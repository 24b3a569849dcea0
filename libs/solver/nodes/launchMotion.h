#pragma once

#include "kernels/particle/BodyNodes.h"
#include "kernels/particle/NodeSample.h"
#include "kernels/particle/PressureForces.h"
#include "kernels/particle/Relaxation.h"
#include "kernels/particle/StepClockUpdate.h"
#include "kernels/particle/SurfaceNodes.h"
#include "solver/nodes/MotionLaunches.h"
#include "solver/nodes/NodeView.h"

namespace fpm {

template <class Numbers, class Executor>
class MotionLaunchesOf final : public MotionLaunches
{
    using Position = typename Numbers::Position;
    using Motion = typename Numbers::Motion;

public:
    explicit MotionLaunchesOf(const LaunchContext<Executor>& context) : on_(context) {}

    void updateClock() override
    {
        const Field<double>&elements = on_.fields.elements.patchStep,
              &contact = on_.fields.contact.bound, &bodies = on_.fields.bodies.contactBound;
        const StepClockUpdate update{
            elements.data(), Index(elements.size()), contact.data(),     Index(contact.size()),
            bodies.data(),   Index(bodies.size()),   on_.settings.rules, clock()};
        on_.executor.parallelBlocks(1, StepClockUpdate::scratch(), update);
    }

    void relax() override
    {
        NodeFields& n = on_.fields.nodes;
        const Index blocks = Index(n.blocks());
        on_.executor.parallelBlocks(
            blocks, relaxationScratch(),
            RelaxationNodes<Numbers>{view(), n.lastForce.data<Motion>(), n.relaxationSum.data()});
        const RelaxationClock relaxation{n.relaxationSum.data(),
                                         blocks,
                                         on_.fields.elements.patchEnergy.data(),
                                         Index(on_.fields.elements.patchStep.size()),
                                         elementEnergies,
                                         on_.fields.bodies.bodies.data(),
                                         Index(on_.fields.bodies.bodies.size()),
                                         on_.setUp.nodes.relaxation,
                                         clock()};
        on_.executor.parallelBlocks(1, RelaxationClock::scratch(), relaxation);
    }

    void moveNodes() override
    {
        NodeMotion<Numbers> nodes = view();
        if (on_.setUp.nodes.movedByPatches) {
            nodes.list = on_.fields.nodes.listed.data();
            nodes.nodeCount = Index(on_.fields.nodes.listed.size());
        }
        const Index blocks = Index(nodeBlocks(std::size_t(nodes.nodeCount)));
        if (on_.setUp.contact.surfaceStart.empty())
            on_.executor.parallelBlocks(blocks, nodeScratch(), nodes);
        else
            on_.executor.parallelBlocks(blocks, nodeScratch(),
                                        NodeMotionOnSurfaces<Numbers>{nodes});
    }

    void moveBodies() override
    {
        NodeFields& n = on_.fields.nodes;
        BodyFields& b = on_.fields.bodies;
        const Index nodes = Index(b.nodes.size());
        on_.executor.parallelFor(Index(b.bodies.size()),
                                 BodyStep{b.bodies.data(), on_.settings.massDamping, clock()});
        on_.executor.parallelFor(
            nodes, BodyMotion<Numbers>{b.nodes.data(), b.bodyOf.data(), b.arm.data(), nodes,
                                       b.bodies.data(), n.position.data<Position>(),
                                       n.velocity.data<Motion>(),
                                       std::size_t(on_.setUp.nodes.count), clock()});
    }

    void pressures() override
    {
        NodeFields& n = on_.fields.nodes;
        const std::size_t slots = n.pressureFaceNode.size();
        on_.executor.parallelFor(
            Index(n.pressureFaceCondition.size()),
            PressureForces<Numbers>{n.pressureFaceNode.data(), n.pressureFaceCondition.data(),
                                    n.conditions.data(), n.amplitudeRows.data(),
                                    n.position.data<Position>(), std::size_t(on_.setUp.nodes.count),
                                    n.pressureForce.data<Motion>(), slots, clock()});
    }

    void bodyForces() override
    {
        NodeFields& n = on_.fields.nodes;
        BodyFields& b = on_.fields.bodies;
        on_.executor.parallelBlocks(Index(b.blocks.size()), bodyScratch(),
                                    BodyForces<Numbers>{view(), b.blocks.data(), b.loaded.data(),
                                                        b.inverseMass.data(), b.bodies.data(),
                                                        b.sums.data()});
        on_.executor.parallelBlocks(Index(b.bodies.size()), BodySum::scratch(),
                                    BodySum{b.bodies.data(), b.blockStart.data(), b.sums.data(),
                                            b.useStart.data(), b.uses.data(), n.conditions.data(),
                                            n.amplitudeRows.data(), b.contactBound.data(),
                                            clock()});
    }

    void kineticEnergy(bool reactions) override
    {
        NodeFields& n = on_.fields.nodes;
        on_.executor.parallelBlocks(
            Index(n.blocks()), nodeScratch(),
            KineticEnergy<Numbers>{view(), reactions, n.blockEnergy.data()});
    }

    void sample(const Index* list, Index count, double* out) override
    {
        on_.executor.parallelFor(count, NodeSample<Numbers>{view(), list, out, count,
                                                            on_.fields.bodies.bodyOf.data(),
                                                            on_.fields.bodies.bodies.data()});
    }

private:
    NodeMotion<Numbers> view() { return nodeView<Numbers>(on_); }
    StepClock* clock() { return on_.fields.clock.clock.data(); }

    LaunchContext<Executor> on_;
};

template <class Numbers, class Executor>
std::unique_ptr<MotionLaunches> makeMotionLaunches(const LaunchContext<Executor>& context)
{
    return std::make_unique<MotionLaunchesOf<Numbers, Executor>>(context);
}

} // namespace fpm
