#pragma once

#include "base/Types.h"
#include "kernels/contact/distribute/ForceSum.h"
#include "kernels/contact/law/Penalty.h"
#include "kernels/particle/StepClock.h"
#include "parallel/Precision.h"

namespace fpm {

/// Values of `face` of a contactor that are no face number.
inline constexpr Index noFace = -1; ///< no target within reach
/// Released and counted: the contactor went deeper than the target is thick, or left it over an
/// edge while inside.
inline constexpr Index releasedFace = -2;

/// Values of `neighbour` of a face's edge that are no 4 * face + edge: a free edge, where the
/// surface ends; an edge of zero length, across which there is no face.
inline constexpr Index freeEdge = -1;
inline constexpr Index noEdge = -2;
/// Edge on symmetry plane k, where the surface continues as its mirror image. The function is its
/// own inverse.
FPM_KERNEL constexpr Index mirrorEdge(Index k)
{
    return noEdge - 1 - k;
}

/// Planes beyond which a contactor meets images of faces, at most.
inline constexpr Index mostMirrors = 3;

/// Counters of a pass: events of contactors that a user should know.
enum PassCount {
    countReleased, ///< released: deeper than the target is thick
    countOverEdge, ///< left the target over a free edge while in contact
    countInside,   ///< found by a search inside the target, their initial depth forgiven
    countMistaken, ///< found by a search to have tracked a face that is not the nearest, by 1 %
    countCrowded,  ///< searches that found more bodies within reach of a contactor than it has
                   ///< slots
    countLate,     ///< list checks that found lists used beyond their validity
    passCounts
};

/// Shape of the target within reach of a contactor. Flat: the faces differ by a degree at most, and
/// the one over which the contactor lies is the nearest. Curved: a neighbour may be nearer.
/// Intricate: faces at more than 60 degrees, or across a gap, so that stepping from face to face
/// may miss the nearest.
enum Around : std::uint8_t { aroundFlat, aroundCurved, aroundIntricate };

/// The normal of a contactor's own faces serves only to test whether faces oppose each other, so
/// two bytes per component are enough.
inline constexpr int ownNormalScale = 32767;

/// Largest number of bodies (parts) with which one node may be in contact at once.
inline constexpr int maxSlots = 3;

/// A float that is not less than `value`, which is not negative.
template <class Work>
FPM_KERNEL float notLess(Work value)
{
    const float near = float(value);
    return Work(near) < value ? near * (1 + 0x1p-23f) : near;
}

/// One pass of a contact pair on the device: contactor nodes against quadrilateral target faces, in
/// arrays over contactors and over faces. A node that may be in contact with several bodies at once
/// has one contactor (slot) per body.
template <class Numbers>
struct ContactPassView {
    using Position = typename Numbers::Position;
    using Motion = typename Numbers::Motion;
    using Work = typename Numbers::Work;

    Index contactorCount, faceCount, targetCount;
    Index nodeCount;            ///< nodes of the pass: contactor i is at node i % nodeCount
    const Index* contactor;     ///< node
    const Index* contactNumber; ///< number among all contact nodes of each node of the model, -1:
                                ///< none
    const Index*
        ownFaceStart; ///< faces of the contactor's own surface around it: CSR over [nodeCount]
    const Index* ownFaces;
    const Index* ownFaceNode;    ///< [4 * own face + corner], node
    const Index* faceNode;       ///< [4 * face + corner]
    const Index* nextAround;     ///< [4 * face + corner]: 4 * face + corner of the next face around
                                 ///< the same node, ascending and cyclic
    const Index* neighbour;      ///< [4 * face + edge]: 4 * face + edge of the face across edge i,
                                 ///< which joins corners i and i + 1
    const Work* mirrorNormal;    ///< [3 * k]: unit normals of the planes of symmetry
    const std::uint8_t* mirrors; ///< symmetry planes on which a contactor lies, one bit each; null:
                                 ///< none
    const Work* faceStiffness;   ///< k_n of the initial state by the pair's rule; 0: rigid
    const float* faceThickness;  ///< V / A
    const Work* faceMass;        ///< of its lightest free corner, for contact damping
    const Index* targetCorner;   ///< [target node]: a corner of a face at it, as in nextAround;
                                 ///< only for `search closestParticle`
    const Index* excludedStart;  ///< faces excluded for a node, ascending: CSR over [nodeCount];
                                 ///< null: none
    const Index* excluded;
    const Index* faceComponent;      ///< body of a face; null: one body
    const Index* contactorComponent; ///< body of a node, [nodeCount]
    const std::uint8_t* mayMeet;     ///< [contactor's body * components + face's]; null: all pairs
                                     ///< of bodies
    Index components;

    std::int16_t* ownNormal; ///< unit mean normal of the contactor's own faces at the last search,
                             ///< times ownNormalScale
    Index* face;
    Work *xi, *eta;
    std::uint8_t* around;         ///< shape of the target at the last search, an Around
    std::int64_t* force;          ///< on each block of contactors in this step, see BlockForce
    std::int64_t* contactorForce; ///< on each contactor, where elements may be deleted; else null
    std::int64_t* counts;         ///< as PassCount
    float* overlap;               ///< initial depth, of which forgivenShare causes no force
    Work* heldStiffness; ///< k_n with which a contactor's spring closed; null: all faces have one
                         ///< k_n
    double* injected;    ///< work of initial depths that fade in time; null: none fades. Second
                         ///< half: gap at the last step, 0 where nothing is forgiven
    double fadeTime;     ///< > 0: time over which initial depths fade

    const Position* position;
    const Motion* velocity;
    std::size_t nodeStride;
    ContactSums sums;
    const StepClock* clock;

    Work reach; ///< skin of the Verlet list, and gap up to which a face is tracked
    bool cold;  ///< `projection cold`: each step projects from the face centre onto all faces
                ///< around
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
    /// Image of a vector in the planes of a set, one bit each, taken in their order; its inverse
    /// takes them in the reverse order.
    FPM_KERNEL Vec3<Work> mirrored(Index planes, Vec3<Work> v) const
    {
        for (Index k = 0; planes >> k; ++k)
            if (planes >> k & 1) v = multiplyAdd(Work(-2) * dot(v, mirror(k)), mirror(k), v);
        return v;
    }
    FPM_KERNEL Vec3<Work> mirroredBack(Index planes, Vec3<Work> v) const
    {
        for (Index k = mostMirrors - 1; k >= 0; --k)
            if (planes >> k & 1) v = multiplyAdd(Work(-2) * dot(v, mirror(k)), mirror(k), v);
        return v;
    }
    FPM_KERNEL Index mirrorsOf(Index i) const { return mirrors ? mirrors[i] : 0; }
    /// Calls visit(face) for the faces around a corner of a face, ascending, until it returns
    /// false.
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
    /// Distance from a face within which a search has to find it: the reach, or half the thickness
    /// for contactors inside the target, plus half a reach that the face itself may move.
    FPM_KERNEL Work margin(Index number) const
    {
        const Work deep = Work(0.5) * (Work(faceThickness[number]) + reach);
        return deep > reach ? deep : reach;
    }
    /// Share of initial depths still forgiven; depths found later than fadeTime are forgiven whole.
    FPM_KERNEL Work forgivenShare(double time) const
    {
        return time < fadeTime ? Work((fadeTime - time) / fadeTime) : Work(1);
    }
    FPM_KERNEL Index componentOf(Index number) const
    {
        return faceComponent ? faceComponent[number] : 0;
    }
    /// False for faces excluded around the contactor and for bodies whose contact is not defined.
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
