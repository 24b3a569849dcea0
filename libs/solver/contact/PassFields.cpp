#include "solver/contact/PassFields.h"

#include "base/Error.h"
#include "base/Format.h"
#include "kernels/contact/broad/Search.h"
#include "kernels/contact/distribute/PassSums.h"

namespace fpm {

namespace {

[[noreturn]] void refuse(const FieldBase& field, Index number)
{
    throw Error(ExitCode::checkpoint,
                format("contact pass: {} in field {} leads nowhere", number, field.info().name));
}

void requireFaces(const PassFields& pass)
{
    const Index faces = Index(pass.faceThickness.size()); // or segments of edges
    for (const Field<Index>* field : {&pass.face, &pass.frictionFace})
        for (const Index number : field->toHost())
            if (number < releasedFace || number >= faces) refuse(*field, number);
    if (pass.frictionFace.size() == 0 || pass.edgeState.size() > 0) return;
    // A stored force has a face in whose frame it is kept; edges have frames of their own.
    const std::vector<Index> frames = pass.frictionFace.toHost();
    const std::vector<double> held = pass.tangentialForce.toDoubles(); // planes
    for (std::size_t i = 0; i < held.size(); ++i)
        if (const Index frame = frames[i % frames.size()]; frame < 0 && held[i] * held[i] > 0)
            refuse(pass.frictionFace, frame);
}

/// Every entry stands in one list at most, and once: so each list ends.
void requireCells(const PassFields& pass)
{
    const Index count = Index(pass.entries.size());
    const std::vector<CellEntry> all = pass.entries.toHost();
    const std::vector<Index> heads = pass.head.toHost();
    for (const Index first : heads)
        if (first < -1 || first >= count) refuse(pass.head, first);
    for (const CellEntry& entry : all)
        if (entry.next < -1 || entry.next >= count) refuse(pass.entries, entry.next);
    std::vector<bool> seen(all.size());
    const auto follow = [&](Index first) {
        for (Index at = first; at >= 0; at = all[std::size_t(at)].next) {
            if (seen[std::size_t(at)]) refuse(pass.entries, at);
            seen[std::size_t(at)] = true;
        }
    };
    // Those of levels, but for the last, mark that the level has entries.
    for (std::size_t list = 0; list <= pass.cellMask; ++list) follow(heads[list]);
    follow(heads.back());
}

} // namespace

bool hasDamping(const ContactPassSetup& pass)
{
    return pass.law.normalDamping > 0 && !pass.kinematic;
}

bool hasFriction(const ContactPassSetup& pass)
{
    return pass.law.friction > 0;
}

bool hasSlipDamping(const ContactPassSetup& pass)
{
    return hasFriction(pass) && !pass.kinematic && !pass.law.paperFriction
           && pass.law.slipDamping > 0;
}

bool hasConvectedFriction(const ContactPassSetup& pass)
{
    return hasFriction(pass) && !pass.law.paperFriction && pass.surface < 0;
}

PassFields::PassFields(const ContactPassSetup& setUp,
                       const Memory& memory,
                       const NumberTypes& numbers)
    : FieldSet("contact pass", memory, numbers)
{
    contactor.assign(setUp.contactor);
    ownFaceStart.assign(setUp.ownFaceStart);
    ownFaces.assign(setUp.ownFaces);
    ownFaceNode.assign(setUp.ownFaceNode);
    faceNode.assign(setUp.faceNode);
    nextAround.assign(setUp.nextAround);
    neighbour.assign(setUp.neighbour);
    if (setUp.search == ContactSearch::closestParticle) targetCorner.assign(setUp.targetCorner);
    excludedStart.assign(setUp.excludedStart);
    excluded.assign(setUp.excluded);
    faceComponent.assign(setUp.faceComponent);
    contactorComponent.assign(setUp.contactorComponent);
    mayMeet.assign(setUp.mayMeet);
    mirrors.assign(setUp.mirrors);
    edgeNode.assign(setUp.edgeNode);
    edgeNext.assign(setUp.edgeNext);
    firstEnds.assign(setUp.nodePasses[0].contactor);
    secondEnds.assign(setUp.nodePasses[1].contactor);
    mirrorNormal.assign(setUp.mirrorNormal);
    faceStiffness.assign(setUp.faceStiffness);
    faceThickness.assign({setUp.faceThickness.begin(), setUp.faceThickness.end()});
    contactorStiffness.assign(setUp.contactorStiffness);
    if (hasDamping(setUp) || hasSlipDamping(setUp)) contactorMass.assign(setUp.contactorMass);
    if (hasDamping(setUp)) faceMass.assign(setUp.faceMass);
    allocateState(setUp);
    allocateCells(setUp);
}

/// Values that a pass has no use for have no memory.
void PassFields::allocateState(const ContactPassSetup& setUp)
{
    const std::size_t count = setUp.contactor.size();
    const std::size_t blocks = std::size_t(NodeBlocks::blocks(Index(count)));
    const bool rough = hasFriction(setUp), convected = hasConvectedFriction(setUp),
               damping = hasDamping(setUp), analytic = setUp.surface >= 0,
               kinematic = setUp.kinematic, spring = analytic && !kinematic;
    const bool edges = setUp.ofEdges;
    ownNormal.resize(edges ? 0 : 3 * std::size_t(setUp.nodeCount));
    edgeState.resize(edges ? count : 0);
    edgePhase.resize(edges ? count : 0);
    passedOn.resize(edges ? count : 0);
    face.assign(std::vector<Index>(count, noFace));
    frictionFace.assign(std::vector<Index>(convected ? count : 0, noFace));
    around.resize(edges ? 0 : count);
    xi.resize(count);
    eta.resize(count);
    tangentialForce.resize(rough && !kinematic ? 3 * count : 0);
    slipRate.resize(hasSlipDamping(setUp) ? count : 0);
    heldStiffness.resize(setUp.unequalFaces ? count : 0);
    overlap.resize(count);
    force.resize(analytic ? 0 : BlockForce::values * blocks);
    contactorForce.resize(setUp.mayLeave ? 3 * count : 0);
    surfaceForce.resize(spring ? 3 * count : 0);
    springEnergy.resize(kinematic ? 0 : count);
    touchGap.resize(kinematic ? 0 : count);
    touchExtra.resize(kinematic ? 0 : count);
    touchSurplus.resize(kinematic ? 0 : count);
    dampingForce.resize(damping ? count : 0);
    dissipated.resize(rough ? count : 0);
    damped.resize(damping || kinematic ? count : 0);
    surfaceWork.resize(analytic ? count : 0);
    reading.resize(kinematic ? surfaceReadings * count : 0);
    injected.resize(setUp.fadeTime > 0 ? 2 * count : 0);
    counts.resize(passCounts);
    sums.resize(passSums * blocks);
}

void PassFields::requireNumbers() const
{
    requireFaces(*this);
    requireCells(*this);
}

void PassFields::allocateCells(const ContactPassSetup& setUp)
{
    const bool faces = setUp.search == ContactSearch::faces;
    entries.resize(faces ? setUp.faceThickness.size() : setUp.target.size());
    // The middles of several faces lie in one cell; of target nodes it may be one.
    const std::size_t lists = (faces ? 1 : 2) * entries.size();
    std::uint32_t size = 16;
    while (size < lists) size *= 2;
    cellMask = size - 1;
    // Empty until the first search; of a pass that has lost its contactors there is none.
    head.assign(std::vector<Index>(std::size_t(size) + std::size_t(setUp.levels) + 1, -1));
}

} // namespace fpm
