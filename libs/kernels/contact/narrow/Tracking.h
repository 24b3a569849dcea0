#pragma once

#include "kernels/contact/narrow/ContactPoint.h"
#include "kernels/contact/narrow/FaceChoice.h"

namespace fpm {

/// Tracks a contactor from face to face between searches, always to the nearest: projection from
/// the last point and, where the surface is not flat, a test of the faces across nearby edges.
/// Where faces at large angles lie within reach (`aroundIntricate`), all faces of the cells of the
/// last search are tested, so that tracking finds what a search would find. With `projection cold`
/// nothing is tracked: all faces around a corner are tested.
template <class Numbers>
struct FaceTracker {
    using Work = typename Numbers::Work;
    const ContactPassView<Numbers>& pass;
    CellLists cells;
    static constexpr int maxHops = 16;
    static constexpr int mostCandidates = 32;

    FPM_KERNEL ContactPoint<Work> follow(Index i) const
    {
        Candidate<Work> here;
        here.face = pass.face[i];
        FaceCorners<Work> corners = pass.corners(here.face, pass.contactor[i]);
        RidgeFaces<Work> near;
        if (pass.cold)
            aroundCorner(i, here, corners);
        else {
            here.point = closestPoint(corners, pass.xi[i], pass.eta[i]);
            step(i, here, corners, near);
            if (pass.around[i] == aroundIntricate && tryCells(i, here, corners)) {
                // Stepping on from there might leave the partner that the search chose.
                Candidate<Work> next = here;
                FaceCorners<Work> unused = corners;
                if (hopped(i, next, unused, near)) near.count = 0;
            }
        }
        bool beyond = false;
        Projection<Work> at =
            SignedGap<Numbers>{pass, i}.at(here.face, corners, here.point, beyond);
        if (at.gap < 0 && !beyond && pass.around[i] == aroundIntricate && isNewInside(i)) {
            here.gap = at.gap;
            if (lifted(i, here, corners)) {
                near.count = 0;
                at = SignedGap<Numbers>{pass, i}.at(here.face, corners, here.point, beyond);
                pass.overlap[i] = notLess(-at.gap);
                atomicAdd64(pass.counts + countInside, 1);
            }
        }
        ContactPoint<Work> out(here.face, at, beyond);
        if (near.count > 0 && at.gap < 0 && !beyond) out.blend(near);
        return out;
    }

private:
    /// Whether a contactor had no contact before.
    FPM_KERNEL bool isNewInside(Index i) const
    {
        return !pass.cold && !(pass.law.springEnergy[i] > 0) && !(pass.overlap[i] > 0);
    }
    /// Moves a contactor that has come in over a sharp edge to the face above it, see EdgeLift.
    FPM_KERNEL bool lifted(Index i, Candidate<Work>& here, FaceCorners<Work>& corners) const
    {
        const Index side = here.face;
        EdgeLift<Numbers>{pass, i}.lift(here, {0, 0, 0});
        if (here.face == side) return false;
        corners = pass.corners(here.face, pass.contactor[i]);
        return true;
    }
    /// Steps from face to face to the nearest. `near`: receives those about as near, inside a
    /// ridge.
    FPM_KERNEL void
    step(Index i, Candidate<Work>& here, FaceCorners<Work>& corners, RidgeFaces<Work>& near) const
    {
        int hop = 0;
        while (hop < maxHops && hopped(i, here, corners, near)) ++hop;
        if (hop == maxHops) // too far to step from face to face: search the cells
            pass.around[i] = aroundIntricate;
    }

    /// `projection cold`, as in the paper: projects onto every face around the corner nearest to
    /// the contactor, from the face centre.
    FPM_KERNEL void aroundCorner(Index i, Candidate<Work>& here, FaceCorners<Work>& corners) const
    {
        int nearest = 0;
        Work least = dot(corners.corner[0], corners.corner[0]);
        for (int k = 1; k < 4; ++k) {
            const Work square = dot(corners.corner[k], corners.corner[k]);
            if (!(square < least)) continue;
            least = square;
            nearest = k;
        }
        const Index start = here.face;
        here.point = closestPoint(corners, Work(0), Work(0));
        pass.visitAround(
            start, nearest, [&](Index face) __attribute__((always_inline)) {
                if (face != start) moved(i, face, here, corners, nullptr);
                return true;
            });
    }

    /// Moves to a face that is nearer by more than rounding. Of faces that share the projection
    /// point it moves from one that does not oppose the contactor to one that does: otherwise their
    /// shares of the force would depend on which of them is tracked. `near`: receives it where it
    /// is about as near, inside a ridge; null: not asked.
    FPM_KERNEL bool moved(Index i,
                          Index other,
                          Candidate<Work>& here,
                          FaceCorners<Work>& corners,
                          RidgeFaces<Work>* near) const
    {
        if (other == here.face || (pass.excludedStart && !pass.mayTouch(i, other))) return false;
        const FaceCorners<Work> there = pass.corners(other, pass.contactor[i]);
        const FacePoint<Work> found = closestPoint(there, Work(0), Work(0));
        const Work size = squareOfDiagonal(there);
        bool turnedAway = false, mayMove = true;
        if (isAsNear(found.square, here.point.square, size)) {
            const bool inside = found.where == insideFace && here.point.where == insideFace,
                       apart = areDistinctPoints(offsetOn(corners, here.point.xi, here.point.eta),
                                                 offsetOn(there, found.xi, found.eta), size);
            turnedAway = !apart && isNotOpposing(pass, i, normalAt(corners, here.point));
            // A change of face at one common point would be decided by rounding.
            mayMove = turnedAway || (!inside && apart);
        }
        // What does not oppose the contactor is no partner, however near.
        const Vec3<Work> normal = normalAt(there, found);
        if (isNotOpposing(pass, i, normal)) return false;
        if (mayMove
            && (turnedAway || found.square < ContactTolerances<Work>::nearer * here.point.square)) {
            if (isHeldOver(i, here, corners, there, found, normal)) return false;
            here = {other, found, 0};
            corners = there;
            return true;
        }
        if (near) addNear(i, {other, 0}, {0, 0, 0}, there, found, here, corners, *near);
        return false;
    }
    /// Whether a contactor whose depth in the tracked face is forgiven stays on it beside the
    /// nearer face across a sharp edge, over which it came (EdgeLift): less deep in what presses
    /// it.
    FPM_KERNEL bool isHeldOver(Index i,
                               const Candidate<Work>& here,
                               const FaceCorners<Work>& corners,
                               const FaceCorners<Work>& there,
                               const FacePoint<Work>& other,
                               const Vec3<Work>& normal) const
    {
        if (!(pass.overlap[i] > 0) || here.point.where != insideFace) return false;
        const Vec3<Work> up = normalAt(corners, here.point),
                         beyond = offsetOn(corners, here.point.xi, here.point.eta)
                                  - offsetOn(there, Work(0), Work(0));
        if (!(dot(up, normal) < ContactTolerances<Work>::sharp) || !(dot(beyond, up) < 0))
            return false;
        const Work left = squareRoot(here.point.square) - Work(pass.overlap[i]);
        return !(left > 0) || left * left < other.square;
    }
    /// Enters a face that a contactor inside is less than the blend's reach farther from than from
    /// the tracked one. `there`: corners relative to the image of the contactor, `shift` from it.
    FPM_KERNEL void addNear(Index i,
                            const FaceImage& other,
                            const Vec3<Work>& shift,
                            const FaceCorners<Work>& there,
                            const FacePoint<Work>& found,
                            const Candidate<Work>& here,
                            const FaceCorners<Work>& corners,
                            RidgeFaces<Work>& near) const
    {
        const Projection<Work> first = gapAtClosest(corners, here.point.xi, here.point.eta);
        Projection<Work> second = gapAtClosest(there, found.xi, found.eta);
        if (!(first.gap < 0) || !(second.gap < 0)
            || isHeldOver(i, here, corners, there, found, second.normal))
            return;
        second.normal = pass.mirroredBack(other.planes, second.normal);
        second.offset = pass.mirroredBack(other.planes, second.offset);
        // Of two the second has a weight where d_2 < d_1 (1 + f m_12); with others it may have one
        // a little farther away.
        const Work reach = 1
                           + Work(3) * RidgeDepth<Work>::factor
                                 * RidgeDepth<Work>::turnBetween(first.normal, second.normal);
        if (!(-second.gap < -first.gap * reach)) return;
        near.add(other, shift, second, first.offset, squareOfDiagonal(there));
    }
    /// The same for the image of a face in planes of symmetry through a corner of the tracked one.
    FPM_KERNEL void addImage(Index i,
                             const FaceImage& other,
                             const Vec3<Work>& through,
                             const Candidate<Work>& here,
                             const FaceCorners<Work>& corners,
                             RidgeFaces<Work>& near) const
    {
        const Vec3<Work> shift = imageShift(pass, other.planes, through);
        const FaceCorners<Work> there = shifted(pass.corners(other.face, pass.contactor[i]), shift);
        const FacePoint<Work> found = closestPoint(there, Work(0), Work(0));
        if (!isNotOpposing(pass, i, pass.mirroredBack(other.planes, normalAt(there, found))))
            addNear(i, other, shift, there, found, here, corners, near);
    }

    FPM_KERNEL static Vec3<Work> normalAt(const FaceCorners<Work>& face,
                                          const FacePoint<Work>& point)
    {
        return gapAt(face, point.xi, point.eta).normal;
    }

    /// Moves to a neighbouring face that is nearer by more than rounding, if there is one. `near`:
    /// receives those that are about as near, where there is none.
    FPM_KERNEL bool
    hopped(Index i, Candidate<Work>& here, FaceCorners<Work>& corners, RidgeFaces<Work>& near) const
    {
        near.count = 0;
        FaceImage list[mostCandidates];
        int corner = 0;
        const Index count = candidates(i, here, corners, list, corner);
        for (Index k = 0; k < count; ++k)
            if (list[k].planes != 0)
                addImage(i, list[k], corners.corner[corner], here, corners, near);
            else if (moved(i, list[k].face, here, corners, &near))
                return true;
        return false;
    }

    /// Faces near the closest point that may be as near: across the edges close to it, around a
    /// corner close to it, and for a contactor inside their images in the planes of symmetry there.
    /// Those across edges come first: of equally near faces, as at a symmetry plane, these lie on
    /// the same side. `corner`: receives the corner in whose planes the images are.
    FPM_KERNEL Index candidates(Index i,
                                const Candidate<Work>& here,
                                const FaceCorners<Work>& corners,
                                FaceImage (&list)[mostCandidates],
                                int& corner) const
    {
        const FacePoint<Work>& point = here.point;
        Vec3<Work> r, t1, t2;
        evaluateFace(corners, point.xi, point.eta, r, t1, t2);
        // Across an edge further away than the face itself no face that turns by less than a right
        // angle can be nearer, across one twice as far none that counts in a ridge.
        const Work xi = 1 - (point.xi < 0 ? -point.xi : point.xi),
                   eta = 1 - (point.eta < 0 ? -point.eta : point.eta);
        const Vec3<Work> normal = cross(t1, t2);
        const bool behind = dot(r, normal) < 0;
        const Work reach = behind ? Work(4) * point.square : point.square;
        const bool near[2] = {!(xi * xi * dot(t1, t1) > reach), !(eta * eta * dot(t2, t2) > reach)};
        Index count = 0, planes = 0;
        if (!near[0] && !near[1]) return count;
        const Index* neighbour = pass.neighbour + 4 * std::size_t(here.face);
        for (int axis = 0; axis < 2; ++axis) {
            const int edge = axis == 0 ? (point.xi > 0 ? 1 : 3) : (point.eta > 0 ? 2 : 0);
            if (!near[axis]
                || (point.where == insideFace
                    && !turns(i, neighbour[edge], corners, edge, normal, behind)))
                continue;
            planes |= planesAt(neighbour[edge]);
            if (neighbour[edge] >= 0) list[count++] = {neighbour[edge] / 4, 0};
        }
        corner = point.xi > 0 ? (point.eta > 0 ? 2 : 1) : (point.eta > 0 ? 3 : 0);
        const Index across = count;
        // A contactor inside may be near any of them, also where those across the edges turn away.
        if (near[0] && near[1] && (behind || point.where >= firstCorner))
            pass.visitAround(
                here.face, corner, [&](Index face) __attribute__((always_inline)) {
                    planes |= planesAround(face, here.face, corner);
                    if (face != here.face && (across == 0 || list[0].face != face)
                        && (across < 2 || list[1].face != face))
                        list[count++] = {face, 0};
                    return count < mostCandidates / 4;
                });
        if (!behind) return count;
        const Index real = count;
        for (Index set = 1; set <= planes; ++set) {
            if ((set & planes) != set) continue;
            list[count++] = {here.face, set};
            for (Index k = 0; k < real && near[0] && near[1]; ++k)
                list[count++] = {list[k].face, set};
        }
        return count;
    }
    /// The plane on which an edge lies, as a bit; 0: none.
    FPM_KERNEL static Index planesAt(Index neighbour)
    {
        return neighbour < noEdge && mirrorEdge(neighbour) < 2 ? Index(1) << mirrorEdge(neighbour)
                                                               : 0;
    }
    /// Those of the edges of a face at its corner that is a corner of another.
    FPM_KERNEL Index planesAround(Index face, Index other, int corner) const
    {
        const Index node = pass.faceNode[4 * std::size_t(other) + std::size_t(corner)],
                    *nodes = pass.faceNode + 4 * std::size_t(face),
                    *neighbour = pass.neighbour + 4 * std::size_t(face);
        int c = 0;
        while (c < 3 && nodes[c] != node) ++c;
        return planesAt(neighbour[c]) | planesAt(neighbour[(c + 3) & 3]);
    }

    /// Whether the face across an edge, or its own image beyond a plane of symmetry, bends towards
    /// the side of the contactor.
    FPM_KERNEL bool turns(Index i,
                          Index across,
                          const FaceCorners<Work>& corners,
                          int edge,
                          const Vec3<Work>& normal,
                          bool behind) const
    {
        const Index planes = planesAt(across);
        if (across < 0 && planes == 0) return false;
        // Far corners of the neighbour relative to the common edge, whose direction is opposite
        // there.
        Vec3<Work> a, b;
        if (planes != 0) {
            a = pass.mirrored(planes,
                              corners.corner[(edge + 2) & 3] - corners.corner[(edge + 1) & 3]);
            b = pass.mirrored(planes, corners.corner[(edge + 3) & 3] - corners.corner[edge]);
        } else {
            const Index* nodes = pass.faceNode + 4 * std::size_t(across / 4);
            const Index origin = pass.contactor[i];
            a = pass.relative(nodes[(across + 3) & 3], origin) - corners.corner[(edge + 1) & 3];
            b = pass.relative(nodes[(across + 2) & 3], origin) - corners.corner[edge];
        }
        const Work first = dot(a, normal), second = dot(b, normal);
        const Work bend =
            behind ? (first < second ? -first : -second) : (first > second ? first : second);
        return bend > 0
               && bend * bend > ContactTolerances<Work>::bend * dot(normal, normal) * dot(a, a);
    }

    /// Moves to the nearest face of the cells, if it is nearer.
    FPM_KERNEL bool tryCells(Index i, Candidate<Work>& here, FaceCorners<Work>& corners) const
    {
        const Index body = pass.componentOf(here.face);
        Candidate<Work> best{noFace, {}, 0};
        cells.forEachFace(
            pass, pass.contactor[i], [&](Index face) __attribute__((always_inline)) {
                Candidate<Work> other;
                if (face != here.face && pass.componentOf(face) == body
                    && isPartner(pass, i, face, other) && (best.face < 0 || isNearer(other, best)))
                    best = other;
            });
        if (best.face < 0
            || !(best.point.square < ContactTolerances<Work>::nearer * here.point.square))
            return false;
        EdgeLift<Numbers>{pass, i}.lift(best, normalAt(corners, here.point));
        here = best;
        corners = pass.corners(here.face, pass.contactor[i]);
        return true;
    }
};

} // namespace fpm
