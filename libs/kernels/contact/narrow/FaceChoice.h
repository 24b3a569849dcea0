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
