#pragma once

#include "kernels/contact/broad/CellLists.h"
#include "kernels/contact/narrow/SignedGap.h"

namespace fpm {

/// Face that a contactor may be in contact with, and its closest point.
template <class Work>
struct Candidate {
    Index face;
    FacePoint<Work> point;
    Work gap;
};

/// True where all four values lie more than `margin` to one side of 0.
template <class Work>
FPM_KERNEL bool outsideRange(Work a, Work b, Work c, Work d, Work margin)
{
    return (a > margin && b > margin && c > margin && d > margin)
           || (a < -margin && b < -margin && c < -margin && d < -margin);
}

/// Tests one face as partner of contactor i: true where the pair is allowed, the normals oppose
/// each other, the contactor is not beyond a free edge, and it lies within reach outside or no
/// deeper than half the thickness inside.
template <class Numbers>
FPM_KERNEL bool isPartner(const ContactPassView<Numbers>& pass,
                          Index i,
                          Index face,
                          Candidate<typename Numbers::Work>& out)
{
    using Work = typename Numbers::Work;
    const FaceCorners<Work> corners = pass.corners(face, pass.contactor[i]);
    const Work margin = pass.margin(face);
    const Vec3<Work>* x = corners.corner;
    if (outsideRange(x[0].x, x[1].x, x[2].x, x[3].x, margin)
        || outsideRange(x[0].y, x[1].y, x[2].y, x[3].y, margin)
        || outsideRange(x[0].z, x[1].z, x[2].z, x[3].z, margin) || !pass.mayTouch(i, face))
        return false;
    const FacePoint<Work> point = closestPoint(corners, Work(0), Work(0));
    const Work depth = Work(0.5) * Work(pass.faceThickness[face]);
    const bool inReach = point.square <= pass.reach * pass.reach;
    if (!inReach && !(point.square <= depth * depth)) return false;
    if (isNotOpposing(pass, i, gapAt(corners, point.xi, point.eta).normal)) return false;
    bool beyond = false;
    const Projection<Work> at = SignedGap<Numbers>{pass, i}.at(face, corners, point, beyond);
    if (beyond || (at.gap < 0 ? -at.gap > depth : !inReach)) return false;
    out = {face, point, at.gap};
    return true;
}

/// A contactor that slides over a slit between two flush bodies comes over the edge of the second a
/// little below its surface, as deep as its springs: the side face is nearer and would stop it. As
/// if the edge were rounded by the height `lift`, it is taken to be inside the face along which it
/// moves, not the one that it runs into.
template <class Numbers>
struct EdgeLift {
    using Work = typename Numbers::Work;
    const ContactPassView<Numbers>& pass;
    Index i;

    /// Replaces a face by its neighbour across a sharp edge close above. `before`: normal of the
    /// face in contact before, which this one then follows; 0: none, the motion tells.
    FPM_KERNEL void lift(Candidate<Work>& side, const Vec3<Work>& before) const
    {
        const FacePoint<Work>& point = side.point;
        if (!(side.gap < 0) || point.where != insideFace) return;
        const Work two = Work(2) * ContactTolerances<Work>::lift;
        const FaceCorners<Work> corners = pass.corners(side.face, pass.contactor[i]);
        const Vec3<Work> normal = gapAt(corners, point.xi, point.eta).normal;
        if (dot(before, normal) > ContactTolerances<Work>::sharp) return;
        for (int axis = 0; axis < 2; ++axis) {
            const Work at = axis == 0 ? point.xi : point.eta;
            if (!(magnitude(at) > 1 - two)) continue;
            const Index across =
                pass.neighbour[4 * std::size_t(side.face)
                               + std::size_t(axis == 0 ? (at > 0 ? 1 : 3) : (at > 0 ? 2 : 0))];
            Candidate<Work> top;
            if (across < 0 || !isPartner(pass, i, across / 4, top) || !(top.gap < 0)
                || top.point.where != insideFace)
                continue;
            const FaceCorners<Work> above = pass.corners(top.face, pass.contactor[i]);
            const Vec3<Work> up = gapAt(above, top.point.xi, top.point.eta).normal;
            // Over a convex edge alone: in a corner that is concave both bear.
            const Vec3<Work> beyond =
                offsetOn(corners, point.xi, point.eta) - offsetOn(above, Work(0), Work(0));
            if (!(dot(up, normal) < ContactTolerances<Work>::sharp) || !(dot(beyond, normal) < 0))
                continue;
            if (dot(before, before) > 0 ? dot(before, up) > ContactTolerances<Work>::sharp
                                        : runsAlong(side, up, normal)) {
                side = top;
                return;
            }
        }
    }

private:
    /// Whether the contactor moves along the face with normal `up` rather than into it.
    FPM_KERNEL bool
    runsAlong(const Candidate<Work>& side, const Vec3<Work>& up, const Vec3<Work>& normal) const
    {
        Work n[4];
        shapeFunctions(side.point.xi, side.point.eta, n);
        Vec3<Work> velocity = pass.velocityOf(pass.contactor[i]);
        for (int k = 0; k < 4; ++k)
            velocity =
                velocity - n[k] * pass.velocityOf(pass.faceNode[4 * std::size_t(side.face) + k]);
        return magnitude(dot(velocity, up)) < magnitude(dot(velocity, normal));
    }
};

/// Compares true distances; of equal distances the lower face number is nearer.
template <class Work>
FPM_KERNEL bool isNearer(const Candidate<Work>& a, const Candidate<Work>& b)
{
    return a.point.square < b.point.square || (a.point.square == b.point.square && a.face < b.face);
}

/// The nearest faces of up to `slots` bodies, one per body, nearest first.
template <class Work>
struct NearestFaces {
    Candidate<Work> best[maxSlots];
    Index component[maxSlots];
    int count = 0;
    bool crowded = false; ///< more bodies were found than there are slots

    FPM_KERNEL void add(const Candidate<Work>& face, Index body, int slots)
    {
        // `count` never exceeds maxSlots; the bound is repeated for compilers that warn.
        const int held = count < maxSlots ? count : maxSlots;
        int at = 0;
        while (at < held && component[at] != body) ++at;
        if (at < held) {
            if (!isNearer(face, best[at])) return;
        } else if (held < slots)
            count = held + 1;
        else {
            crowded = true;
            at = held - 1;
            if (!isNearer(face, best[at])) return;
        }
        for (; at > 0 && isNearer(face, best[at - 1]); --at) {
            best[at] = best[at - 1];
            component[at] = component[at - 1];
        }
        best[at] = face;
        component[at] = body;
    }
};

} // namespace fpm
