#pragma once

#include "kernels/contact/narrow/ContactPoint.h"
#include "kernels/contact/narrow/FaceChoice.h"

namespace fpm {

/// Narrow phase of the contactors from `first` on, one in each lane of T: closest-point projection
/// from the last point. Contactors with a flat target within reach that stay over their face need
/// nothing else; most of them do.
template <class Numbers, class T>
class SteadyContactors
{
public:
    using Work = typename Numbers::Work;
    static constexpr int lanes = NumberTraits<T>::lanes;

    FPM_KERNEL SteadyContactors(const ContactPassView<Numbers>& pass, Index first)
    {
        alignas(T) Work corner[12][lanes], start[2][lanes], flat[lanes];
        if (!areFlat(pass, first, flat)) {
            store(holds_, T(0));
            return;
        }
        for (int lane = 0; lane < lanes; ++lane) fetch(pass, first, lane, flat, corner, start);
        FaceCorners<T> corners;
        for (int k = 0; k < 4; ++k)
            corners.corner[k] = {read<T>(corner[3 * k]), read<T>(corner[3 * k + 1]),
                                 read<T>(corner[3 * k + 2])};
        T xi = read<T>(start[0]), eta = read<T>(start[1]);
        const MaskOf<T> inside =
            projectWhere(read<T>(flat) > T(0), corners, xi, eta) & isInside(xi, eta);
        if (!NumberTraits<T>::any(inside)) {
            store(holds_, T(0));
            return;
        }
        const Projection<T> at = gapAtClosest(corners, clampedUnit(xi), clampedUnit(eta));
        store(holds_, select(inside & !nearsRidge(corners, at), T(1), T(0)));
        const T values[6] = {at.xi, at.eta, at.gap, at.normal.x, at.normal.y, at.normal.z};
        for (int k = 0; k < 6; ++k) store(values_[k], values[k]);
    }

    FPM_KERNEL bool holds(int lane) const { return holds_[lane] > 0; }
    FPM_KERNEL ContactPoint<Work> at(int lane, Index face) const
    {
        const auto value = [&](int k) { return values_[k][lane]; };
        return {
            face, {value(0), value(1), {value(3), value(4), value(5)}, {0, 0, 0}, value(2)}, false};
    }

private:
    /// Marks the lanes whose target is flat within reach; returns whether there is any.
    FPM_KERNEL static bool
    areFlat(const ContactPassView<Numbers>& pass, Index first, Work (&flat)[lanes])
    {
        bool any = false;
        for (int lane = 0; lane < lanes; ++lane) {
            const Index i = first + lane;
            const bool here = !pass.cold && i < pass.contactorCount && pass.face[i] >= 0
                              && pass.around[i] == aroundFlat;
            flat[lane] = Work(here);
            any |= here;
        }
        return any;
    }
    /// Corners of the face of one lane, and the last projection point of its contactor.
    FPM_KERNEL static void fetch(const ContactPassView<Numbers>& pass,
                                 Index first,
                                 int lane,
                                 const Work (&flat)[lanes],
                                 Work (&corner)[12][lanes],
                                 Work (&start)[2][lanes])
    {
        if (!(flat[lane] > 0)) {
            start[0][lane] = start[1][lane] = 0;
            for (int k = 0; k < 12; ++k) corner[k][lane] = 0;
            return;
        }
        const Index i = first + lane, face = pass.face[i];
        start[0][lane] = pass.xi[i];
        start[1][lane] = pass.eta[i];
        const FaceCorners<Work> corners = pass.corners(face, pass.contactor[i]);
        for (int k = 0; k < 4; ++k) // the force sums are needed last
            prefetch(pass.sums.values + 4 * pass.contactNumberAt(face, k));
        prefetch(pass.sums.values + 4 * std::size_t(pass.contactNumber[pass.contactor[i]]));
        for (int k = 0; k < 4; ++k) {
            corner[3 * k][lane] = corners.corner[k].x;
            corner[3 * k + 1][lane] = corners.corner[k].y;
            corner[3 * k + 2][lane] = corners.corner[k].z;
        }
    }
    /// Inside, and nearer to an edge than a tenth of the depth: inside a ridge, even one so blunt
    /// that its faces count as flat, other faces may be equally near.
    FPM_KERNEL static MaskOf<T> nearsRidge(const FaceCorners<T>& corners, const Projection<T>& at)
    {
        Vec3<T> r, t1, t2;
        evaluateFace(corners, at.xi, at.eta, r, t1, t2);
        const T zero = T(0), xi = T(1) - magnitude(at.xi), eta = T(1) - magnitude(at.eta),
                square = T(0.01) * at.gap * at.gap;
        return (at.gap < zero)
               & (((xi > zero) & (xi * xi * dot(t1, t1) < square))
                  | ((eta > zero) & (eta * eta * dot(t2, t2) < square)));
    }

    alignas(T) Work holds_[lanes], values_[6][lanes];
};

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
    static constexpr int mostCandidates = 14;

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
            int hop = 0;
            while (hop < maxHops && hopped(i, here, corners, near)) ++hop;
            if (hop == maxHops) // too far to step from face to face: search the cells
                pass.around[i] = aroundIntricate;
            if (pass.around[i] == aroundIntricate && near.count == 0) tryCells(i, here, corners);
        }
        bool beyond = false;
        const Projection<Work> at =
            SignedGap<Numbers>{pass, i}.at(here.face, corners, here.point, beyond);
        ContactPoint<Work> out(here.face, at, beyond);
        if (near.count > 0 && at.gap < 0 && !beyond) out.blend(near);
        return out;
    }

private:
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
        if (mayMove
            && (turnedAway || found.square < ContactTolerances<Work>::nearer * here.point.square)
            && !isNotOpposing(pass, i, normalAt(there, found))) {
            here = {other, found, 0};
            corners = there;
            return true;
        }
        if (near) addNear(i, other, there, found, here, corners, *near);
        return false;
    }
    /// Enters a face that a contactor inside is less than the blend's reach farther from than from
    /// the tracked one.
    FPM_KERNEL void addNear(Index i,
                            Index other,
                            const FaceCorners<Work>& there,
                            const FacePoint<Work>& found,
                            const Candidate<Work>& here,
                            const FaceCorners<Work>& corners,
                            RidgeFaces<Work>& near) const
    {
        const Projection<Work> first = gapAtClosest(corners, here.point.xi, here.point.eta),
                               second = gapAtClosest(there, found.xi, found.eta);
        if (!(first.gap < 0) || !(second.gap < 0)) return;
        // Of two the second has a weight where d_2 < d_1 (1 + 2 f (1 - n_1 . n_2)); with others it
        // may have one a little farther away.
        const Work turn = Work(6) * RidgeDepth<Work>::factor;
        if (!(-second.gap < -first.gap * (1 + turn * (1 - dot(first.normal, second.normal))))
            || isNotOpposing(pass, i, second.normal))
            return;
        near.add(other, second, first.offset, squareOfDiagonal(there));
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
        Index list[mostCandidates];
        const Index count = candidates(i, here, corners, list);
        for (Index k = 0; k < count; ++k)
            if (moved(i, list[k], here, corners, &near)) return true;
        return false;
    }

    /// Faces near the closest point that may be as near: across the edges close to it, and around a
    /// corner close to it. Those across edges come first: of equally near faces, as at a symmetry
    /// plane, these lie on the same side.
    FPM_KERNEL Index candidates(Index i,
                                const Candidate<Work>& here,
                                const FaceCorners<Work>& corners,
                                Index (&list)[mostCandidates]) const
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
        Index count = 0;
        if (!near[0] && !near[1]) return count;
        const Index* neighbour = pass.neighbour + 4 * std::size_t(here.face);
        for (int axis = 0; axis < 2; ++axis) {
            const int edge = axis == 0 ? (point.xi > 0 ? 1 : 3) : (point.eta > 0 ? 2 : 0);
            if (!near[axis] || neighbour[edge] < 0) continue;
            if (point.where == insideFace
                && !turns(i, neighbour[edge], corners, edge, normal, behind))
                continue;
            list[count++] = neighbour[edge] / 4;
        }
        const bool onEdge = point.where >= 0 && point.where < firstCorner;
        if (!near[0] || !near[1] || (count == 0 && point.where < firstCorner)
            || (onEdge && !behind))
            return count;
        const int corner = point.xi > 0 ? (point.eta > 0 ? 2 : 1) : (point.eta > 0 ? 3 : 0);
        pass.visitAround(
            here.face, corner, [&](Index face) __attribute__((always_inline)) {
                if (face != here.face && (count == 0 || list[0] != face)
                    && (count < 2 || list[1] != face))
                    list[count++] = face;
                return count < mostCandidates;
            });
        return count;
    }

    /// Whether the face across an edge bends towards the side of the contactor.
    FPM_KERNEL bool turns(Index i,
                          Index across,
                          const FaceCorners<Work>& corners,
                          int edge,
                          const Vec3<Work>& normal,
                          bool behind) const
    {
        if (across < 0) return false;
        const Index* nodes = pass.faceNode + 4 * std::size_t(across / 4);
        const Index origin = pass.contactor[i];
        // Far corners of the neighbour relative to the common edge, whose direction is opposite
        // there.
        const Vec3<Work> a = pass.relative(nodes[(across + 3) & 3], origin)
                             - corners.corner[(edge + 1) & 3],
                         b = pass.relative(nodes[(across + 2) & 3], origin) - corners.corner[edge];
        const Work first = dot(a, normal), second = dot(b, normal);
        const Work bend =
            behind ? (first < second ? -first : -second) : (first > second ? first : second);
        return bend > 0
               && bend * bend > ContactTolerances<Work>::bend * dot(normal, normal) * dot(a, a);
    }

    FPM_KERNEL void tryCells(Index i, Candidate<Work>& here, FaceCorners<Work>& corners) const
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
            return;
        here = best;
        corners = pass.corners(here.face, pass.contactor[i]);
    }
};

} // namespace fpm
