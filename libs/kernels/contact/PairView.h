#pragma once

#include "base/Types.h"
#include "kernels/contact/ForceSum.h"
#include "kernels/contact/Penalty.h"
#include "kernels/particle/StepClock.h"
#include "parallel/Precision.h"

namespace fpm {

/// What `face` of a contactor may say beyond a face number.
inline constexpr Index noFace = -1;       ///< no target within reach
inline constexpr Index releasedFace = -2; ///< went deeper than the target is thick: let go, counted

/// One contact pair on the device: contactor nodes against quadrilateral target faces. Arrays over
/// contactors and faces; vectors in three planes `contactorCount` apart.
template <class Precision>
struct PairView {
    using Position = typename Precision::Position;
    using Motion = typename Precision::Motion;
    using Work = typename Precision::Work;

    Index contactorCount, faceCount, targetCount;
    const Index* contactor;       ///< node
    const Index* contactorNumber; ///< its number among all contact nodes
    const Index* ownFaceStart;    ///< faces of the contactor's own surface around it: CSR over
    const Index* ownFaceNode;     ///< ... [4 * entry + corner], node
    const Index* faceNode;        ///< [4 * face + corner]
    const Index* faceNumber;      ///< [4 * face + corner], number among all contact nodes
    const Index* neighbour;       ///< [4 * face + edge], edge i joins corners i and i + 1; -1: free
    const Work* faceStiffness;    ///< k_n = s_n K A^2 / V, frozen at the start; 0: rigid
    const Work* faceThickness;    ///< V / A
    const Work* faceMass;         ///< of its lightest free corner, for contact damping
    const Index* target;          ///< target nodes
    const Index* targetFaceStart; ///< faces around a target node: CSR
    const Index* targetFaces;

    Work* ownNormal; ///< unit mean normal of the contactor's own faces at the last search
    Index* face;
    Work *xi, *eta;
    double* force;          ///< on the contactor, this step
    std::int64_t* released; ///< count of contactors let go

    const Position* position;
    const Motion* velocity;
    std::size_t nodeStride;
    std::int64_t* sum; ///< [contact node][4]: force and stiffness, fixed point
    ForceScale scale;
    const StepClock* clock;

    Work reach; ///< distance at which a face is tracked
    PairLaw<Work> law;

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
    /// Distance from a face at which a contactor may still be its own: within reach of it, or
    /// inside the target up to half its thickness.
    FPM_KERNEL Work margin(Index number) const
    {
        const Work half = Work(0.5) * faceThickness[number];
        return half > reach ? half : reach;
    }
    FPM_KERNEL Vec3<Work> ownNormalOf(Index i) const
    {
        return {ownNormal[i], ownNormal[contactorCount + i], ownNormal[2 * contactorCount + i]};
    }
};

} // namespace fpm
