#pragma once

#include "kernels/element/ElementForces.h"
#include "solver/backend/LaunchContext.h"
#include "solver/elements/ElementLaunches.h"

namespace fpm {

template <class Numbers, class Executor>
class ElementLaunchesOf final : public ElementLaunches
{
    using Work = typename Numbers::Work;
    using Position = typename Numbers::Position;
    using Motion = typename Numbers::Motion;
    using Sum = typename Numbers::Sum;

public:
    explicit ElementLaunchesOf(const LaunchContext<Executor>& context) : on_(context) {}

    void forces() override
    {
        for (std::size_t group = 0; group < on_.setUp.elements.groups.size(); ++group)
            ofGroup(group);
    }

private:
    void ofGroup(std::size_t number)
    {
        const KernelGroup& group = on_.setUp.elements.groups[number];
        const bool plastic = group.kind == PartKind::elastoplastic;
        if (group.hexahedron == HexahedronForm::selective)
            return launch<GeneralPlasticity, SelectiveIntegration>(number);
        switch (group.hourglass) {
        case HourglassForm::stiffness:
            group.general ? launch<GeneralPlasticity, StiffnessHourglass>(number)
            : plastic     ? launch<J2Plasticity, StiffnessHourglass>(number)
                          : launch<Elastic, StiffnessHourglass>(number);
            break;
        case HourglassForm::viscous:
            group.general ? launch<GeneralPlasticity, ViscousHourglass>(number)
            : plastic     ? launch<J2Plasticity, ViscousHourglass>(number)
                          : launch<Elastic, ViscousHourglass>(number);
            break;
        case HourglassForm::physical:
            group.general ? launch<GeneralPlasticity, PhysicalHourglass>(number)
            : plastic     ? launch<J2Plasticity, PhysicalHourglass>(number)
                          : launch<Elastic, PhysicalHourglass>(number);
            break;
        }
    }

    template <class Material, class Hourglass>
    void launch(std::size_t group)
    {
        ElementFields& e = on_.fields.elements;
        NodeFields& n = on_.fields.nodes;
        StepClock* clock = on_.fields.clock.clock.data();
        const NodeSetUp& nodes = on_.setUp.nodes;
        const ElementForces<Numbers, Material, Hourglass> kernel{
            .list = e.groupPatches.data() + e.groupStart[group],
            .patches = e.patches.data(),
            .materials = reinterpret_cast<const MaterialConstants<Work>*>(e.materials.data()),
            .boundaryNodes = e.boundaryNodes.data(),
            .corners = e.corners.data(),
            .cornerStarts = e.cornerStarts.data(),
            .slotCorners = e.slotCorners.data(),
            .nodes = {n.position.data<Position>(), n.velocity.data<Motion>(),
                      n.inverseMass.data<Motion>(), n.fixed.data(), std::size_t(nodes.count),
                      e.interiorForce.data<Work>(), std::size_t(nodes.interiorEnd)},
            .mass = e.mass.data<Work>(),
            .massRatio = e.massRatio.data<Work>(),
            .state = e.state.data<Work>(),
            .plasticStrain = e.plasticStrain.data<Sum>(),
            .partialForce = e.partialForce.data<Work>(),
            .patchEnergy = e.patchEnergy.data(),
            .patchStep = e.patchStep.data(),
            .clock = clock,
            .deletions = &clock->deletions,
            .strainPoint = Work(on_.settings.midStepStrain ? 0.5 : 1.0),
            .movesInterior = nodes.movedByPatches};
        const ElementSetUp& setUp = on_.setUp.elements;
        on_.executor.parallelBlocks(Index(setUp.groups[group].patches.size()),
                                    elementScratch<Work>(setUp.maxPatchNodes), kernel);
    }

    LaunchContext<Executor> on_;
};

template <class Numbers, class Executor>
std::unique_ptr<ElementLaunches> makeElementLaunches(const LaunchContext<Executor>& context)
{
    return std::make_unique<ElementLaunchesOf<Numbers, Executor>>(context);
}

} // namespace fpm
