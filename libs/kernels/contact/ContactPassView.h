#pragma once

#include "base/Types.h"
#include "kernels/contact/ForceSum.h"
#include "kernels/contact/Penalty.h"
#include "kernels/particle/StepClock.h"
#include "parallel/Precision.h"

namespace fpm {

/// What `face` of a contactor may say beyond a face number.
inline constexpr Index noFace = -1; ///< no target within reach
/// Let go, counted: it went deeper than the target is thick, or left it sideways while inside.
inline constexpr Index releasedFace = -2;

/// What `neighbour` of a face's edge may say beyond 4 * face + edge: the surface ends here; it does
/// not, but there is no face: the edge has no length.
inline constexpr Index freeEdge = -1;
inline constexpr Index noEdge = -2;
/// On plane k of symmetry, where the surface goes on as its own mirror image. Its own inverse.
FPM_KERNEL constexpr Index mirrorEdge(Index k)
{
    return noEdge - 1 - k;
}

/// Counts of a pair: what happened to contactors that a user ought to know.
enum PassCount {
    countReleased, ///< let go: deeper than the target is thick
    countOverEdge, ///< left the target over a free edge while in touch
    countInside,   ///< found by a search inside the target, their depth forgiven
    countMistaken, ///< found by a search to have followed a face not the nearest, by 1 %
    countCrowded,  ///< searches that found more bodies in reach of a contactor than it has slots
    countLate,     ///< looks that found lists used for longer than they lasted
    passCounts
};

/// What is in reach of a contactor. Flat: faces that differ by a degree at most, the one above
/// which it lies is the nearest. Curved: a neighbour may be nearer. Intricate: faces that turn by
/// more than 60 degrees, or across a gap, so that hops might not find the nearest.
enum Around : std::uint8_t { aroundFlat, aroundCurved, aroundIntricate };

/// Only asked which way it looks, the normal of a contactor's own faces is kept in two bytes a
/// component.
inline constexpr int ownNormalScale = 32767;

/// Bodies (parts) that one contactor may touch at once.
inline constexpr int maxSlots = 3;

/// A float that is not less than `value`, which is not negative.
template <class Work>
FPM_KERNEL float notLess(Work value)
{
    const float near = float(value);
    return Work(near) < value ? near * (1 + 0x1p-23f) : near;
}

/// One contact pair on the device: contactor nodes against quadrilateral target faces. Arrays over
/// contactors and faces. Where a node may touch several bodies at once it is several contactors.
template <class Numbers>
struct ContactPassView {
    using Position = typename Numbers::Position;
    using Motion = typename Numbers::Motion;
    using Work = typename Numbers::Work;

    Index contactorCount, faceCount, targetCount;
    Index nodeCount; ///< contactors without repetition: contactor i has the node of i % nodeCount
    const Index* contactor;     ///< node
    const Index* contactNumber; ///< of each node of the model among all contact nodes, or -1
    const Index*
        ownFaceStart; ///< faces of the contactor's own surface around it: CSR over [nodeCount]
    const Index* ownFaces;
    const Index* ownFaceNode;    ///< [4 * own face + corner], node
    const Index* faceNode;       ///< [4 * face + corner]
    const Index* nextAround;     ///< [4 * face + corner]: 4 * face + corner of the next face around
                                 ///< the same node, ascending; after the last the first
    const Index* neighbour;      ///< [4 * face + edge]: 4 * face + edge across edge i, that joins
                                 ///< corners i and i + 1
    const Work* mirrorNormal;    ///< [3 * k]: unit normals of the planes of symmetry
    const std::uint8_t* mirrors; ///< planes a contactor lies on, a bit each; null: none
    const Work* faceStiffness;   ///< k_n = s_n K A^2 / V, frozen at the start; 0: rigid
    const float* faceThickness;  ///< V / A
    const Work* faceMass;        ///< of its lightest free corner, for contact damping
    const Index* targetCorner;   ///< a corner of a face at each target node, as in nextAround: the
                                 ///< first; only for `search closestParticle`
    const Index* excludedStart;  ///< faces that are no partner of a node, ascending: CSR over
                                 ///< [nodeCount]; null: none
    const Index* excluded;
    const Index* faceComponent;      ///< body of a face; null: one body
    const Index* contactorComponent; ///< body of a node, [nodeCount]
    const std::uint8_t* mayMeet;     ///< [contactor's body * components + face's]; null: all may
    Index components;

    std::int16_t* ownNormal; ///< unit mean normal of the contactor's own faces at the last search,
                             ///< in parts of ownNormalScale
    Index* face;
    Work *xi, *eta;
    std::uint8_t* around;         ///< what the last search found around it, as Around
    std::int64_t* force;          ///< on each block of contactors this step, see BlockForce
    std::int64_t* contactorForce; ///< on each contactor, where elements may be deleted, or null
    std::int64_t* counts;         ///< as PassCount
    float* overlap;      ///< depth at which it was found, of which forgivenShare makes no force
    Work* heldStiffness; ///< k_n with which a contactor's spring closed; null: all faces have one
    double* injected;    ///< work of overlaps that fade with time; null: they do not; second half:
                         ///< gap at the last step, 0 where nothing is forgiven
    double fadeTime;     ///< > 0: over which they do

    const Position* position;
    const Motion* velocity;
    std::size_t nodeStride;
    ContactSums sums;
    const StepClock* clock;

    Work reach; ///< distance at which a face is tracked
    bool cold;  ///< projected at each step from the middle of all faces around, not tracked
    PassLaw<Work> law;

    FPM_KERNEL Vec3<Work> relative(Index node, Index origin) const
    {
        const std::size_t a = std::size_t(node), b = std::size_t(origin);
        return {difference<Work>(position[a], position[b]),
                difference<Work>(position[nodeStride + a], position[nodeStride + b]),
                difference<Work>(position[2 * nodeStride + a], position[2 * nodeStride + b])};
    }
    FPM_KERNEL FaceCorners<Work> corners(Index number, Index origin) const
    {
        const Index* nodes = faceNode + 4 * std::size_t(number);
        return {{relative(nodes[0], origin), relative(nodes[1], origin), relative(nodes[2], origin),
                 relative(nodes[3], origin)}};
    }
    FPM_KERNEL Vec3<Work> velocityOf(Index node) const
    {
        const std::size_t a = std::size_t(node);
        return {Work(velocity[a]), Work(velocity[nodeStride + a]),
                Work(velocity[2 * nodeStride + a])};
    }
    FPM_KERNEL Vec3<Work> mirror(Index k) const
    {
        return {mirrorNormal[3 * k], mirrorNormal[3 * k + 1], mirrorNormal[3 * k + 2]};
    }
    FPM_KERNEL Index mirrorsOf(Index i) const { return mirrors ? mirrors[i] : 0; }
    /// visit(face) for the faces around a corner of one, ascending, until it says false.
    template <class Visit>
    FPM_KERNEL void visitAround(Index number, int corner, const Visit& visit) const
    {
        Index last = 4 * number + corner;
        while (nextAround[last] > last) last = nextAround[last];
        Index at = last;
        do at = nextAround[at];
        while (visit(at / 4) && at != last);
    }
    FPM_KERNEL Index targetNode(Index i) const { return faceNode[targetCorner[i]]; }
    FPM_KERNEL std::size_t contactNumberAt(Index number, int corner) const
    {
        return std::size_t(contactNumber[faceNode[4 * std::size_t(number) + std::size_t(corner)]]);
    }
    /// Distance from a face at which a search finds it: within reach, or inside the target up to
    /// half its thickness, also after half a reach of the face's own way.
    FPM_KERNEL Work margin(Index number) const
    {
        const Work deep = Work(0.5) * (Work(faceThickness[number]) + reach);
        return deep > reach ? deep : reach;
    }
    /// What is left of depths that fade; all of those that are found later.
    FPM_KERNEL Work forgivenShare(double time) const
    {
        return time < fadeTime ? Work((fadeTime - time) / fadeTime) : Work(1);
    }
    FPM_KERNEL Index componentOf(Index number) const
    {
        return faceComponent ? faceComponent[number] : 0;
    }
    /// False for faces of the contactor's own surroundings, and of bodies it has no business with.
    FPM_KERNEL bool mayTouch(Index i, Index number) const
    {
        const Index base = i % nodeCount;
        if (mayMeet && !mayMeet[contactorComponent[base] * components + faceComponent[number]])
            return false;
        if (!excludedStart) return true;
        Index low = excludedStart[base], high = excludedStart[base + 1];
        while (low < high) {
            const Index middle = low + (high - low) / 2;
            if (excluded[middle] < number)
                low = middle + 1;
            else
                high = middle;
        }
        return low == excludedStart[base + 1] || excluded[low] != number;
    }
    FPM_KERNEL Vec3<Work> ownNormalOf(Index i) const
    {
        const Index base = i % nodeCount;
        const Work scale = Work(1) / Work(ownNormalScale);
        return {scale * Work(ownNormal[base]), scale * Work(ownNormal[nodeCount + base]),
                scale * Work(ownNormal[2 * nodeCount + base])};
    }
    FPM_KERNEL void setOwnNormal(Index base, const Vec3<Work>& unit) const
    {
        const Work values[3] = {unit.x, unit.y, unit.z}, scale = Work(ownNormalScale);
        for (int c = 0; c < 3; ++c)
            ownNormal[c * nodeCount + base] =
                std::int16_t(scale * values[c] + (values[c] < 0 ? Work(-0.5) : Work(0.5)));
    }
};

} // namespace fpm
