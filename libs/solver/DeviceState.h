#pragma once

#include "kernels/particle/NodePass.h"
#include "solver/ContactState.h"

namespace fpm {

template <class Work>
static std::vector<MaterialConstants<Work>>
convertedMaterials(const std::vector<MaterialConstants<double>>& from)
{
    std::vector<MaterialConstants<Work>> out;
    for (const MaterialConstants<double>& m : from) {
        MaterialConstants<Work> to{Work(m.lambda),
                                   Work(m.twoMu),
                                   Work(m.threeMu),
                                   Work(m.pressureWaveModulus),
                                   Work(m.young),
                                   Work(m.poisson),
                                   Work(m.waveSpeed),
                                   Work(m.linearViscosity),
                                   Work(m.quadraticViscosity),
                                   Work(m.hourglass),
                                   Work(m.coupledHourglass),
                                   m.rows,
                                   {},
                                   {},
                                   {},
                                   {}};
        to.general.rotation = m.general.rotation;
        for (int row = 0; row < m.rows; ++row) {
            to.strain[row] = Work(m.strain[row]);
            to.stress[row] = Work(m.stress[row]);
            to.slope[row] = Work(m.slope[row]);
        }
        out.push_back(to);
    }
    return out;
}

/// All arrays of a run in the executor's memory; allocated once.
template <class Precision, class Executor>
struct DeviceState {
    using Work = typename Precision::Work;
    using Position = typename Precision::Position;
    using Motion = typename Precision::Motion;
    using Sum = typename Precision::Sum;
    template <class T>
    using Of = Array<T, Executor>;

    Of<PatchHeader> patches;
    Of<MaterialConstants<Work>> materials;
    std::vector<Of<Index>> groupPatches;
    Of<std::uint16_t> corners, slotCorners;
    Of<Index> slotNode, slotCornerStart, nodeSlotStart, nodeSlots;
    Of<Work> elementMass, state, slotForce;
    Of<Sum> plasticStrain;
    Of<Position> position;
    Of<Motion> velocity, inverseMass;
    Of<std::uint8_t> fixed;
    Of<Index> conditionStart, conditionOf;
    Of<Condition> conditions;
    Of<double> amplitudeRows, patchEnergy, patchStep, blockWork, blockEnergy;

    Of<Index> contactNodes, contactNumber;
    Of<Motion> contactInverseMass;
    Of<std::int64_t> contactSum;
    Of<double> contactLimit, contactTravel, searchPosition;
    std::vector<PairState<Precision, Executor>> pairs;
    Of<StepClock> clock;

    DeviceState(const SolverData& data, const std::vector<Point>& points)
        : patches(data.patches),
          materials(convertedMaterials<Work>(data.materials)),
          corners(data.corners),
          slotCorners(data.slotCorners),
          slotNode(data.slotNode),
          slotCornerStart(data.slotCornerStart),
          nodeSlotStart(data.nodeSlotStart),
          nodeSlots(data.nodeSlots),
          elementMass(converted<Work>(data.elementMass)),
          state(data.stateSize),
          slotForce(3 * std::size_t(data.slotCount)),
          plasticStrain(data.strainCount),
          position(planes<Position>(points)),
          velocity(planes<Motion>(data.velocity)),
          inverseMass(inverses(data.nodeMass)),
          fixed(data.fixed),
          conditionStart(data.conditionStart),
          conditionOf(data.conditionOf),
          conditions(data.conditions),
          amplitudeRows(data.amplitudeRows),
          patchEnergy(data.patches.size() * elementEnergies),
          patchStep(data.patches.size()),
          blockWork(blocks(data.nodeCount) * nodeWorks),
          blockEnergy(2 * blocks(data.nodeCount)),
          contactNodes(data.contactNodes),
          contactNumber(data.contactNumber),
          contactInverseMass(converted<Motion>(data.contactInverseMass)),
          contactSum(4 * data.contactNodes.size()),
          contactLimit(blocks(Index(data.contactNodes.size()))),
          contactTravel(2 * blocks(Index(data.contactNodes.size()))),
          searchPosition(3 * data.contactNodes.size()),
          clock(std::vector<StepClock>(1))
    {
        for (const KernelGroup& group : data.groups) groupPatches.emplace_back(group.patches);
        for (const PairData& pair : data.pairs) pairs.emplace_back(pair);
        // Patches of rigid parts are never worked: no bound comes from them.
        patchStep.fromHost(std::vector<double>(data.patches.size(), 1e30));
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
            + slotNode.bytes() + slotCornerStart.bytes() + nodeSlotStart.bytes() + nodeSlots.bytes()
            + elementMass.bytes() + state.bytes() + slotForce.bytes() + plasticStrain.bytes()
            + position.bytes() + velocity.bytes() + inverseMass.bytes() + fixed.bytes()
            + conditionStart.bytes() + patchEnergy.bytes() + patchStep.bytes() + blockWork.bytes()
            + contactNumber.bytes() + contactSum.bytes() + searchPosition.bytes()
            + contactNodes.bytes() + contactLimit.bytes() + contactTravel.bytes()
            + contactInverseMass.bytes() + blockEnergy.bytes() + conditionOf.bytes()
            + conditions.bytes() + amplitudeRows.bytes();
        for (const auto& group : groupPatches) sum += group.bytes();
        for (const auto& pair : pairs) sum += pair.bytes();
        return sum;
    }
};

} // namespace fpm
