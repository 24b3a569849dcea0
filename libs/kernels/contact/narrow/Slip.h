#pragma once

#include "kernels/contact/narrow/ProjectionFaces.h"
#include "kernels/contact/narrow/Tracking.h"

namespace fpm {

/// Slip increment of a contactor along the target in one step, for friction.
template <class Numbers>
struct Slip {
    using Work = typename Numbers::Work;
    using Faces = ProjectionFaces<Numbers>;
    const ContactPassView<Numbers>& pass;
    Index i;

    /// Displacement increment of the contactor relative to the material of the face, Delta u.
    FPM_KERNEL Vec3<Work> relativeDisplacement(Index face, const Projection<Work>& at) const
    {
        Work n[4];
        shapeFunctions(at.xi, at.eta, n);
        Vec3<Work> relative = pass.velocityOf(pass.contactor[i]);
        for (int k = 0; k < 4; ++k)
            relative = relative - n[k] * pass.velocityOf(pass.faceNode[4 * std::size_t(face) + k]);
        return Work(pass.clock->step) * relative;
    }
    /// Objective slip increment: displacement of the contactor in the rotating frame of the target
    /// since the projection point `last`. `corners`: of its present face; `here`: the faces at its
    /// projection point. Only the tangential part is used.
    FPM_KERNEL Vec3<Work> displacement(const Tracked<Work>& now,
                                       const Faces& here,
                                       const FaceCorners<Work>& corners,
                                       const Place<Work>& last) const
    {
        const Projection<Work>& at = now.at;
        const bool stays = last.face == now.face && last.xi == at.xi && last.eta == at.eta,
                   beyond = (isOnBorder(at.xi, at.eta) || isOnBorder(last.xi, last.eta))
                            && isBeyond(at, corners, last, stays ? &here : nullptr);
        if (stays && !beyond) return {0, 0, 0};
        const Faces there(pass, i, last);
        Vec3<Work> displacement{0, 0, 0};
        if (!stays) displacement = displacementOverFaces(now, here, there, corners, last);
        if (beyond) displacement += displacementBeyondEdge(at, here, there, corners);
        return displacement;
    }

    /// Directions in which friction cancels with its mirror image: normal to the symmetry planes of
    /// the model on which the contactor lies, and to the plane midway between faces while the
    /// contactor stays in it inside a ridge or in a valley.
    FPM_KERNEL Directions<Work> acrossMirrors(const Tracked<Work>& now, const Faces& here) const
    {
        Directions<Work> out;
        for (Index k = 0, mirrors = pass.mirrorsOf(i); mirrors >> k; ++k)
            if (mirrors >> k & 1) out.add(pass.mirror(k), now.at.normal);
        if (!now.ridge && here.count < 2) return out;
        const Vec3<Work> moved = relativeDisplacement(now.face, now.at);
        if (now.ridge)
            addMidway(RidgeFaces<Numbers>(pass, i, now.face, now.at), now, moved, out);
        else
            addMidway(here, now, moved, out);
        return out;
    }

private:
    /// Adds the normals of the planes midway between faces that share an edge.
    template <class AnyFaces>
    FPM_KERNEL void addMidway(const AnyFaces& faces,
                              const Tracked<Work>& now,
                              const Vec3<Work>& moved,
                              Directions<Work>& out) const
    {
        for (int k = 1; k < faces.count; ++k)
            for (int j = 0; j < k; ++j) {
                const Vec3<Work> apart = faces.normal[j] - faces.normal[k];
                if ((now.ridge || isMidway(now.at.offset, apart)) && staysMidway(moved, apart)
                    && haveEdgeInCommon(pass, faces.face[j], faces.face[k]))
                    out.add(apart, now.at.normal);
            }
    }
    /// Whether a displacement lies in the plane midway between two faces. `apart`: difference of
    /// their normals.
    FPM_KERNEL static bool staysMidway(const Vec3<Work>& moved, const Vec3<Work>& apart)
    {
        return isNormal(moved, apart, Work(1));
    }
    /// Whether a point lies in it, seen from the common edge, within a fraction of the angle of the
    /// faces.
    FPM_KERNEL static bool isMidway(const Vec3<Work>& offset, const Vec3<Work>& apart)
    {
        const Work square = dot(apart, apart);
        return square > negligibleSquare<Work>() && isNormal(offset, apart, square);
    }
    FPM_KERNEL static bool isNormal(const Vec3<Work>& vector, const Vec3<Work>& to, Work square)
    {
        constexpr Work share = symmetryShare<Work>();
        const Work out = dot(vector, to);
        return !(out * out > share * share * square * dot(to, to) * dot(vector, vector));
    }

    /// Displacement of the projection point plus gap times change of normal, Delta x_p and g Delta
    /// n, both on the target in its current position. At an edge the normal is the mean of those of
    /// the adjoining faces, so that half of its change counts when the projection point reaches the
    /// edge and half when it leaves it. Inside a ridge, where the nearest side changes, projection
    /// point and normal jump, but their sum does not.
    FPM_KERNEL Vec3<Work> displacementOverFaces(const Tracked<Work>& now,
                                                const Faces& here,
                                                const Faces& there,
                                                const FaceCorners<Work>& corners,
                                                const Place<Work>& last) const
    {
        const Work xi = now.at.xi, eta = now.at.eta;
        Vec3<Work> moved;
        if (last.face == now.face)
            moved = slipOnFace(corners, last.xi, last.eta, xi, eta);
        else
            moved = offsetOn(pass.corners(last.face, pass.contactor[i]), last.xi, last.eta)
                    - offsetOn(corners, xi, eta);
        return moved + now.at.gap * (here.meanNormal(pass) - there.meanNormal(pass));
    }

    /// Whether a border point of a face lies where the surface ends for the contactor. `known`: the
    /// faces that share it; null: to be determined.
    FPM_KERNEL bool isOnRim(const Place<Work>& at, const Faces* known) const
    {
        return (isOnBorder(at.xi) && endsAt(at, edgeAtXi(at.xi), known))
               || (isOnBorder(at.eta) && endsAt(at, edgeAtEta(at.eta), known));
    }
    FPM_KERNEL bool endsAt(const Place<Work>& at, int edge, const Faces* known) const
    {
        Place<Work> other;
        if (!placeAcross(pass, at, edge, other))
            return pass.neighbour[4 * std::size_t(at.face) + std::size_t(edge)] == freeEdge;
        if (known) {
            for (int k = 0; k < known->count; ++k)
                if (known->face[k] == other.face) return false;
            return known->count < Faces::most;
        }
        const FaceCorners<Work> corners = pass.corners(other.face, pass.contactor[i]);
        return isNotOpposing(pass, i, gapAt(corners, other.xi, other.eta).normal);
    }

    /// Whether the displacement beyond the end of the surface counts, now or one step ago.
    FPM_KERNEL bool isBeyond(const Projection<Work>& at,
                             const FaceCorners<Work>& corners,
                             const Place<Work>& last,
                             const Faces* known) const
    {
        const Vec3<Work> trimmed = offsetOn(corners, at.xi, at.eta) - at.offset;
        return dot(trimmed, trimmed) > 0 || isOnRim(last, known);
    }
    /// Beyond the end of the surface the projection point stays on the edge while the contactor
    /// moves on: the part of the displacement that the projection point does not follow, relative
    /// to the faces there.
    FPM_KERNEL Vec3<Work> displacementBeyondEdge(const Projection<Work>& at,
                                                 const Faces& here,
                                                 const Faces& there,
                                                 const FaceCorners<Work>& corners) const
    {
        const Vec3<Work> offset = offsetOn(corners, at.xi, at.eta);
        Vec3<Work> after{0, 0, 0}, before{0, 0, 0};
        for (int k = 0; k < here.count; ++k) after += inPlane(offset, here.normal[k]);
        for (int k = 0; k < there.count; ++k)
            before += offsetBefore({there.face[k], there.xi[k], there.eta[k]});
        return (Work(1) / Work(here.count)) * after - (Work(1) / Work(there.count)) * before;
    }
    /// In-plane offset of the contactor from its last projection point, one step ago, rotated with
    /// that face.
    FPM_KERNEL Vec3<Work> offsetBefore(const Place<Work>& last) const
    {
        const FaceCorners<Work> now = pass.corners(last.face, pass.contactor[i]);
        FaceCorners<Work> before = now;
        const Vec3<Work> own = pass.velocityOf(pass.contactor[i]);
        for (int k = 0; k < 4; ++k) {
            const Index node = pass.faceNode[4 * std::size_t(last.face) + std::size_t(k)];
            before.corner[k] =
                before.corner[k] - Work(pass.clock->step) * (pass.velocityOf(node) - own);
        }
        Vec3<Work> offset, t1, t2;
        evaluateFace(before, last.xi, last.eta, offset, t1, t2);
        const Vec3<Work> normal = unit(cross(t1, t2)), inside = inPlane(offset, normal);
        evaluateFace(now, last.xi, last.eta, offset, t1, t2);
        return FaceFrame<Work>(now).vector(FaceFrame<Work>(before).components(inside, normal),
                                           unit(cross(t1, t2)));
    }
};

} // namespace fpm
