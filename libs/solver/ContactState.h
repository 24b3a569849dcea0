#pragma once

#include "kernels/contact/PairTouch.h"
#include "kernels/contact/PassSums.h"
#include "kernels/contact/ReferenceDisplacement.h"
#include "kernels/contact/Search.h"
#include "parallel/Array.h"
#include "solver/PenaltyData.h"

#include <array>

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

/// Three planes of a vector field.
template <class To>
static std::vector<To> planes(const std::vector<Point>& points)
{
    std::vector<To> out(3 * points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) out[c * points.size() + i] = To(points[i][c]);
    return out;
}

/// Arrays of one pass of a contact pair in the executor's memory.
template <class Numbers, class Executor>
struct ContactPassState {
    using Work = typename Numbers::Work;
    template <class T>
    using Of = Array<T, Executor>;

    Of<Index> contactor, ownFaceStart, ownFaces, ownFaceNode, faceNode, nextAround, neighbour;
    Of<Index> targetCorner, excludedStart, excluded, faceComponent, contactorComponent, face, head;
    Of<CellEntry> entries;
    Of<Index> frictionFace;
    Of<std::uint8_t> mayMeet, around, shared, mirrors;
    Of<std::int16_t> ownNormal;
    Of<Work> mirrorNormal, faceStiffness;
    Of<float> faceThickness;
    Of<Work> xi, eta, friction;
    Of<float> overlap;
    Of<Work> contactorStiffness, contactorMass, faceMass, heldStiffness;
    Of<std::int64_t> force, contactorForce; ///< of faces, see BlockForce
    Of<double> surfaceForce;                ///< of an analytic surface on each contactor
    Of<double> spring, dissipated, dampingForce, damped, surfaceWork, injected,
        sums; ///< of blocks, see PassSums
    Of<std::int64_t> counts;
    std::uint32_t mask = 0;

    static bool damps(const ContactPassSetup& pair) { return pair.law.normalDamping > 0; }
    static bool hasFriction(const ContactPassSetup& pair) { return pair.law.friction > 0; }
    /// The stored tangential force is kept in the frame of a face.
    static bool convectedFriction(const ContactPassSetup& pair)
    {
        return hasFriction(pair) && !pair.law.paperFriction && pair.surface < 0;
    }

    explicit ContactPassState(const ContactPassSetup& pair)
        : contactor(pair.contactor),
          ownFaceStart(pair.ownFaceStart),
          ownFaces(pair.ownFaces),
          ownFaceNode(pair.ownFaceNode),
          faceNode(pair.faceNode),
          nextAround(pair.nextAround),
          neighbour(pair.neighbour),
          targetCorner(pair.search == ContactSearch::closestParticle ? pair.targetCorner
                                                                     : std::vector<Index>{}),
          excludedStart(pair.excludedStart),
          excluded(pair.excluded),
          faceComponent(pair.faceComponent),
          contactorComponent(pair.contactorComponent),
          face(std::vector<Index>(pair.contactor.size(), noFace)),
          frictionFace(
              std::vector<Index>(convectedFriction(pair) ? pair.contactor.size() : 0, noFace)),
          mayMeet(pair.mayMeet),
          around(pair.contactor.size()),
          mirrors(pair.mirrors),
          ownNormal(3 * std::size_t(pair.nodeCount)),
          mirrorNormal(converted<Work>(pair.mirrorNormal)),
          faceStiffness(converted<Work>(pair.faceStiffness)),
          faceThickness(converted<float>(pair.faceThickness)),
          xi(pair.contactor.size()),
          eta(pair.contactor.size()),
          friction(hasFriction(pair) ? (convectedFriction(pair) ? 2 : 3) * pair.contactor.size()
                                     : 0),
          overlap(pair.contactor.size()),
          contactorStiffness(converted<Work>(pair.contactorStiffness)),
          contactorMass(damps(pair) ? converted<Work>(pair.contactorMass) : std::vector<Work>{}),
          faceMass(damps(pair) ? converted<Work>(pair.faceMass) : std::vector<Work>{}),
          heldStiffness(pair.unequalFaces ? pair.contactor.size() : 0),
          force(pair.surface < 0
                    ? BlockForce::values
                          * std::size_t(NodeBlocks::blocks(Index(pair.contactor.size())))
                    : 0),
          contactorForce(pair.mayLeave ? 3 * pair.contactor.size() : 0),
          surfaceForce(pair.surface >= 0 ? 3 * pair.contactor.size() : 0),
          spring(pair.contactor.size()),
          dissipated(hasFriction(pair) ? pair.contactor.size() : 0),
          dampingForce(damps(pair) ? pair.contactor.size() : 0),
          damped(damps(pair) ? pair.contactor.size() : 0),
          surfaceWork(pair.surface >= 0 ? pair.contactor.size() : 0),
          injected(pair.fadeTime > 0 ? 2 * pair.contactor.size() : 0),
          sums(passSums * std::size_t(NodeBlocks::blocks(Index(pair.contactor.size())))),
          counts(passCounts)
    {
        const bool faces = pair.search == ContactSearch::faces;
        entries = Of<CellEntry>(faces ? pair.faceThickness.size() : pair.target.size());
        // The middles of several faces lie in one cell; of target nodes it may be one.
        const std::size_t lists = (faces ? 1 : 2) * entries.size();
        std::uint32_t size = 16;
        while (size < lists) size *= 2;
        mask = size - 1;
        head = Of<Index>(std::size_t(size) + std::size_t(pair.levels) + 1);
    }

    /// What the kernels see of the pair, but for the state of the particles.
    ContactPassView<Numbers> view(const ContactPassSetup& pair)
    {
        ContactPassView<Numbers> v{};
        v.contactorCount = Index(contactor.size());
        v.faceCount = Index(faceThickness.size());
        v.targetCount = Index(targetCorner.size());
        v.nodeCount = pair.nodeCount;
        v.contactor = contactor.data();
        v.ownFaceStart = ownFaceStart.data();
        v.ownFaces = ownFaces.data();
        v.ownFaceNode = ownFaceNode.data();
        v.faceNode = faceNode.data();
        v.nextAround = nextAround.data();
        v.neighbour = neighbour.data();
        v.mirrorNormal = mirrorNormal.data();
        v.mirrors = mirrors.data();
        v.faceStiffness = faceStiffness.data();
        v.faceThickness = faceThickness.data();
        v.targetCorner = targetCorner.data();
        v.excludedStart = excludedStart.data();
        v.excluded = excluded.data();
        v.faceComponent = faceComponent.data();
        v.contactorComponent = contactorComponent.data();
        v.mayMeet = mayMeet.data();
        v.components = pair.components;
        v.ownNormal = ownNormal.data();
        v.face = face.data();
        v.xi = xi.data();
        v.eta = eta.data();
        v.around = around.data();
        v.force = force.data();
        v.contactorForce = contactorForce.data();
        v.counts = counts.data();
        v.overlap = overlap.data();
        v.heldStiffness = heldStiffness.data();
        v.injected = injected.data();
        v.fadeTime = pair.fadeTime;
        v.reach = Work(pair.reach);
        v.cold = pair.projection == ContactProjection::cold;
        v.faceMass = faceMass.data();
        v.law = law(pair);
        return v;
    }

    /// Springs, friction and damping of the pass.
    PassLaw<Work> law(const ContactPassSetup& pair)
    {
        const ContactLaw& l = pair.law;
        const double slow = l.friction, fast = l.dynamicFriction;
        return {.count = Index(contactor.size()),
                .rule = int(l.penalty),
                .contactorStiffness = contactorStiffness.data(),
                // Mass is halved there by itself.
                .mirrors = entryOf(l.penalty).byMass ? nullptr : mirrors.data(),
                .friction = {.staticCoefficient = Work(slow),
                             .dynamicCoefficient = Work(fast < 0 ? slow : fast),
                             .decay = l.frictionDecay,
                             .stiffnessRatio = Work(l.tangentialScale / l.normalScale),
                             .paper = l.paperFriction},
                .stored = friction.data(),
                .storedFace = frictionFace.data(),
                .spring = spring.data(),
                .dissipated = dissipated.data(),
                .dampingRatio = Work(l.normalDamping),
                .contactorMass = contactorMass.data(),
                .dampingForce = dampingForce.data(),
                .damped = damped.data(),
                .limitFactor = Work(dampingLimit(l))};
    }

    CellLists cells(const ContactPassSetup& pair)
    {
        return {head.data(), entries.data(), mask, pair.cellSize, pair.levels};
    }

    std::size_t bytes() const
    {
        std::size_t sum = 0;
        for (const Of<Index>* array :
             {&contactor, &ownFaceStart, &ownFaces, &ownFaceNode, &faceNode, &nextAround,
              &neighbour, &targetCorner, &excludedStart, &excluded, &faceComponent,
              &contactorComponent, &face, &head, &frictionFace})
            sum += array->bytes();
        for (const Of<Work>* array :
             {&mirrorNormal, &faceStiffness, &xi, &eta, &friction, &contactorStiffness,
              &contactorMass, &faceMass, &heldStiffness})
            sum += array->bytes();
        for (const Of<double>* array : {&surfaceForce, &spring, &dissipated, &dampingForce, &damped,
                                        &surfaceWork, &injected, &sums})
            sum += array->bytes();
        for (const Of<std::uint8_t>* array : {&mayMeet, &around, &shared, &mirrors})
            sum += array->bytes();
        for (const Of<float>* array : {&faceThickness, &overlap}) sum += array->bytes();
        return sum + force.bytes() + contactorForce.bytes() + entries.bytes() + ownNormal.bytes()
               + counts.bytes();
    }
};

/// Enters the target of a pass into its cells and finds the face of every contactor that searches.
template <class Numbers, class Executor>
void searchPass(Executor& executor,
                const ContactPassView<Numbers>& view,
                const CellLists& cells,
                bool faces,
                const NodeBlocks& blocks)
{
    Index count = view.nodeCount;
    if (blocks.due) {
        count = NodeBlocks::size * NodeBlocks::blocks(count);
        if constexpr (Executor::sharesMemory) count = NodeBlocks::size * Index(*blocks.due);
    }
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

} // namespace fpm
