#pragma once

#include "kernels/contact/PairView.h"
#include "kernels/contact/Search.h"
#include "kernels/particle/NodePass.h"
#include "parallel/Array.h"
#include "solver/SolverData.h"

namespace fpm {

/// Copies values into another number type. Static, as all helpers here: a copy of its own for each
/// vector width, or the linker might keep one that not every processor can run.
template <class To, class From>
static std::vector<To> converted(const std::vector<From>& values)
{
    std::vector<To> out;
    out.reserve(values.size());
    for (const From& value : values) out.push_back(To(value));
    return out;
}

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
        const GeneralConstants<double>& g = m.general;
        to.general = {g.rotation,
                      Work(g.kinematicModulus),
                      Work(g.powerModulus),
                      Work(g.powerExponent),
                      g.rateLaw,
                      Work(g.referenceRate),
                      Work(g.rateCoefficient),
                      Work(g.heatPerWork),
                      Work(g.temperature),
                      Work(g.softeningExponent),
                      Work(g.roomTemperature),
                      Work(g.inverseMeltingRange),
                      Work(g.erosionStrain),
                      g.erodes,
                      g.erodesInverted,
                      g.tangentHourglass};
        for (int row = 0; row < m.rows; ++row) {
            to.strain[row] = Work(m.strain[row]);
            to.stress[row] = Work(m.stress[row]);
            to.slope[row] = Work(m.slope[row]);
        }
        out.push_back(to);
    }
    return out;
}

/// Three planes of a vector field.
template <class To>
static std::vector<To> planes(const std::vector<Point>& points)
{
    std::vector<To> out(3 * points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) out[c * points.size() + i] = To(points[i][c]);
    return out;
}

/// Arrays of one contact pair in the executor's memory.
template <class Precision, class Executor>
struct PairState {
    using Work = typename Precision::Work;
    template <class T>
    using Of = Array<T, Executor>;

    Of<Index> contactor, contactorNumber, ownFaceStart, ownFaceNode, faceNode, faceNumber,
        neighbour;
    Of<Index> target, targetFaceStart, targetFaces, face, head, next;
    Of<Work> faceStiffness, faceThickness, ownNormal, xi, eta, friction;
    Of<Work> contactorStiffness, contactorMass, faceMass;
    Of<Index> frictionFace;
    Of<double> force, spring, dissipated, dampingForce, damped, surfaceWork;
    Of<std::int64_t> released;
    std::uint32_t mask = 0;

    static bool damps(const PairData& pair) { return pair.law.normalDamping > 0; }
    /// The stored tangential force is kept in the frame of a face.
    static bool convectedFriction(const PairData& pair)
    {
        return pair.law.friction > 0 && !pair.law.paperFriction && pair.surface < 0;
    }

    explicit PairState(const PairData& pair)
        : contactor(pair.contactor),
          contactorNumber(pair.contactorNumber),
          ownFaceStart(pair.ownFaceStart),
          ownFaceNode(pair.ownFaceNode),
          faceNode(pair.faceNode),
          faceNumber(pair.faceNumber),
          neighbour(pair.neighbour),
          target(pair.target),
          targetFaceStart(pair.targetFaceStart),
          targetFaces(pair.targetFaces),
          face(std::vector<Index>(pair.contactor.size(), noFace)),
          faceStiffness(converted<Work>(pair.faceStiffness)),
          faceThickness(converted<Work>(pair.faceThickness)),
          ownNormal(3 * pair.contactor.size()),
          xi(pair.contactor.size()),
          eta(pair.contactor.size()),
          friction(pair.law.friction > 0 ? (convectedFriction(pair) ? 2 : 3) * pair.contactor.size()
                                         : 0),
          contactorStiffness(converted<Work>(pair.contactorStiffness)),
          contactorMass(damps(pair) ? converted<Work>(pair.contactorMass) : std::vector<Work>{}),
          faceMass(damps(pair) ? converted<Work>(pair.faceMass) : std::vector<Work>{}),
          frictionFace(
              std::vector<Index>(convectedFriction(pair) ? pair.contactor.size() : 0, noFace)),
          force(3 * pair.contactor.size()),
          spring(pair.contactor.size()),
          dissipated(pair.contactor.size()),
          dampingForce(damps(pair) ? pair.contactor.size() : 0),
          damped(damps(pair) ? pair.contactor.size() : 0),
          surfaceWork(pair.surface >= 0 ? pair.contactor.size() : 0),
          released(1)
    {
        const bool faces = pair.search == ContactSearch::faces;
        const std::size_t entries = faces ? 8 * pair.faceThickness.size() : pair.target.size();
        std::uint32_t size = 16;
        while (size < 2 * entries) size *= 2;
        mask = size - 1;
        head = Of<Index>(size);
        next = Of<Index>(entries);
    }

    std::size_t bytes() const
    {
        return (contactor.size() * 2 + ownFaceStart.size() + ownFaceNode.size()
                + faceNode.size() * 3 + target.size() + targetFaceStart.size() + targetFaces.size()
                + face.size() + head.size() + next.size() + frictionFace.size())
                   * sizeof(Index)
               + (faceStiffness.size() * 2 + ownNormal.size() + xi.size() * 2 + friction.size())
                     * sizeof(Work)
               + (contactorStiffness.size() + contactorMass.size() + faceMass.size()) * sizeof(Work)
               + (force.size() + spring.size() + dissipated.size() + dampingForce.size()
                  + damped.size() + surfaceWork.size())
                     * sizeof(double);
    }
};

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
    Of<Motion> velocity, inverseMass, lastForce; ///< of dynamic relaxation
    Of<std::uint8_t> fixed;
    Of<Index> conditionStart, frameOf, pressureFaceNode, pressureFaceCondition, pressureStart,
        pressureSlots;
    Of<ConditionUse> uses;
    Of<Condition> conditions;
    Of<Motion> pressureForce;
    Of<double> frames;
    BodyArrays<Executor> body;
    Of<double> amplitudeRows, patchEnergy, patchStep, blockWork, blockEnergy, relaxationSum;

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
          lastForce(data.relaxation.tolerance > 0 ? 3 * std::size_t(data.nodeCount) : 0),
          fixed(data.fixed),
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
          contactInverseMass(converted<Motion>(data.contactInverseMass)),
          contactSum(4 * data.contactNodes.size()),
          contactLimit(blocks(Index(data.contactNodes.size())) + data.body.bodies.size()),
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
            + contactInverseMass.bytes() + blockEnergy.bytes() + uses.bytes() + frameOf.bytes()
            + frames.bytes() + pressureFaceNode.bytes() + pressureFaceCondition.bytes()
            + pressureStart.bytes() + pressureSlots.bytes() + pressureForce.bytes() + body.bytes()
            + conditions.bytes() + amplitudeRows.bytes() + lastForce.bytes()
            + relaxationSum.bytes();
        for (const auto& group : groupPatches) sum += group.bytes();
        for (const auto& pair : pairs) sum += pair.bytes();
        return sum;
    }
};

} // namespace fpm
