#pragma once

#include "kernels/particle/NodeMotion.h"
#include "solver/ContactState.h"
#include "solver/SearchState.h"

namespace fpm {

template <class Work>
static std::vector<MaterialConstants<Work>>
convertedMaterials(const std::vector<MaterialConstants<double>>& from)
{
    std::vector<MaterialConstants<Work>> out;
    for (const MaterialConstants<double>& m : from) out.push_back(m.converted<Work>());
    return out;
}

/// Rigid bodies in the executor's memory; empty without.
template <class Executor>
struct BodyArrays {
    template <class T>
    using Of = Array<T, Executor>;

    Of<RigidBody> bodies;
    Of<Index> bodyOf, nodes, useStart, blockStart, loaded;
    Of<ConditionUse> uses;
    Of<BodyBlock> blocks;
    Of<double> arm, inverseMass, sums;

    explicit BodyArrays(const BodyData& data)
        : bodies(data.bodies),
          bodyOf(data.bodyOf),
          nodes(data.nodes),
          useStart(data.useStart),
          blockStart(data.blockStart),
          loaded(data.loaded),
          uses(data.uses),
          blocks(data.blocks),
          arm(planes<double>(data.arm)),
          inverseMass(data.inverseMass),
          sums(bodySums * data.blocks.size())
    {
    }
    std::size_t bytes() const
    {
        return bodies.bytes() + bodyOf.bytes() + nodes.bytes() + useStart.bytes()
               + blockStart.bytes() + loaded.bytes() + uses.bytes() + blocks.bytes() + arm.bytes()
               + inverseMass.bytes() + sums.bytes();
    }
};

/// All arrays of a run in the executor's memory; allocated once.
template <class Numbers, class Executor>
struct DeviceState {
    using Work = typename Numbers::Work;
    using Position = typename Numbers::Position;
    using Motion = typename Numbers::Motion;
    using Sum = typename Numbers::Sum;
    template <class T>
    using Of = Array<T, Executor>;

    Of<PatchHeader> patches;
    Of<MaterialConstants<Work>> materials;
    std::vector<Of<Index>> groupPatches;
    Of<std::uint16_t> corners, cornerStarts, slotCorners;
    Of<Index> boundaryNodes, partialSumsStart, partialSums;
    Of<Work> elementMass, massRatio, state, interiorForce, partialForce;
    Of<Sum> plasticStrain;
    Of<Position> position;
    Of<Motion> velocity, inverseMass, lastForce; ///< of dynamic relaxation
    Of<std::uint8_t> fixed;
    Of<Index> listedNodes, conditionStart, frameOf, pressureFaceNode, pressureFaceCondition,
        pressureStart, pressureSlots;
    Of<ConditionUse> uses;
    Of<Condition> conditions;
    Of<Motion> pressureForce;
    Of<double> frames;
    BodyArrays<Executor> body;
    Of<double> amplitudeRows, patchEnergy, patchStep, blockWork, blockEnergy, relaxationSum;

    Of<Index> contactNodes, contactNumber;
    Of<std::int64_t> contactSum;
    Of<double> contactLimit, referenceDisplacement, referenceOrigin;
    Of<float> referenceOffset;
    std::vector<ContactPassState<Numbers, Executor>> passes;
    std::vector<SearchState<Executor>> searches; ///< of the passes whose lists last
    Of<PassListState> passLists;
    Of<StepClock> clock;

    DeviceState(const SolverData& data, const std::vector<Point>& points)
        : patches(data.patches),
          materials(convertedMaterials<Work>(data.materials)),
          corners(data.corners),
          cornerStarts(data.cornerStarts),
          slotCorners(data.slotCorners),
          boundaryNodes(data.boundaryNodes),
          partialSumsStart(data.partialSumsStart),
          partialSums(data.partialSums),
          elementMass(converted<Work>(data.elementMass)),
          massRatio(converted<Work>(data.massRatio)),
          state(data.stateSize),
          interiorForce(3 * std::size_t(data.interiorEnd)),
          partialForce(3 * std::size_t(data.partialSumCount)),
          plasticStrain(data.strainCount),
          position(planes<Position>(points)),
          velocity(planes<Motion>(data.velocity)),
          inverseMass(inverses(data.nodeMass)),
          lastForce(data.relaxation.tolerance > 0 ? 3 * std::size_t(data.nodeCount) : 0),
          fixed(data.fixed),
          listedNodes(data.listedNodes),
          conditionStart(data.conditionStart),
          frameOf(data.frameOf),
          pressureFaceNode(data.pressureFaceNode),
          pressureFaceCondition(data.pressureFaceCondition),
          pressureStart(data.pressureStart),
          pressureSlots(data.pressureSlots),
          uses(data.uses),
          conditions(data.conditions),
          pressureForce(3 * data.pressureFaceNode.size()),
          frames(data.frames),
          body(data.body),
          amplitudeRows(data.amplitudeRows),
          patchEnergy(data.patches.size() * elementEnergies),
          patchStep(data.patches.size()),
          blockWork(blocks(data.nodeCount) * nodeWorks),
          blockEnergy(2 * blocks(data.nodeCount)),
          relaxationSum(data.relaxation.tolerance > 0 ? relaxationSums * blocks(data.nodeCount)
                                                      : 0),
          contactNodes(data.contactNodes),
          contactNumber(data.contactNumber),
          contactSum(4 * data.contactNodes.size()),
          contactLimit(blocks(Index(data.contactNodes.size())) + data.body.bodies.size()),
          referenceDisplacement(displacementValues * blocks(Index(data.contactNodes.size()))),
          referenceOrigin(3 * blocks(Index(data.contactNodes.size()))),
          referenceOffset(3 * data.contactNodes.size()),
          clock(std::vector<StepClock>(1))
    {
        for (const KernelGroup& group : data.groups) groupPatches.emplace_back(group.patches);
        for (const ContactPassSetup& pair : data.passes) passes.emplace_back(pair);
        // Patches of rigid parts are never worked: no bound comes from them.
        patchStep.fromHost(std::vector<double>(data.patches.size(), 1e30));
    }

    void setSearches(const NearBlocks& near)
    {
        searches.clear();
        for (const NearBlocks::Pass& pass : near.passes()) searches.emplace_back(pass);
        passLists = Of<PassListState>(searches.size());
    }
    static std::size_t blocks(Index count)
    {
        return (std::size_t(count) + nodeBlock - 1) / nodeBlock;
    }
    static std::vector<Motion> inverses(const std::vector<double>& masses)
    {
        std::vector<Motion> out;
        // A rigid part may have no density: its nodes are driven, whatever pulls at them.
        for (const double mass : masses) out.push_back(Motion(mass > 0 ? 1 / mass : 0));
        return out;
    }

    std::size_t bytes() const
    {
        std::size_t sum =
            patches.bytes() + materials.bytes() + corners.bytes() + slotCorners.bytes()
            + cornerStarts.bytes() + boundaryNodes.bytes() + partialSumsStart.bytes()
            + partialSums.bytes() + elementMass.bytes() + massRatio.bytes() + state.bytes()
            + interiorForce.bytes() + partialForce.bytes() + plasticStrain.bytes()
            + position.bytes() + velocity.bytes() + inverseMass.bytes() + fixed.bytes()
            + listedNodes.bytes() + conditionStart.bytes() + patchEnergy.bytes() + patchStep.bytes()
            + blockWork.bytes() + contactNumber.bytes() + contactSum.bytes()
            + referenceOrigin.bytes() + referenceOffset.bytes() + contactNodes.bytes()
            + contactLimit.bytes() + referenceDisplacement.bytes() + blockEnergy.bytes()
            + uses.bytes() + frameOf.bytes() + frames.bytes() + pressureFaceNode.bytes()
            + pressureFaceCondition.bytes() + pressureStart.bytes() + pressureSlots.bytes()
            + pressureForce.bytes() + body.bytes() + conditions.bytes() + amplitudeRows.bytes()
            + lastForce.bytes() + relaxationSum.bytes();
        for (const auto& group : groupPatches) sum += group.bytes();
        for (const auto& pair : passes) sum += pair.bytes();
        for (const auto& search : searches) sum += search.bytes();
        return sum + passLists.bytes();
    }
};

} // namespace fpm
