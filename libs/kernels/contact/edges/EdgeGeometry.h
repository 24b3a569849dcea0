#pragma once

#include "kernels/contact/law/Friction.h"

namespace fpm {

/// Angles of edge contact, as sines and tolerances.
struct EdgeAngles {
    /// Segments closer to parallel than 10 degrees do not close: their nodes meet the faces. A
    /// closed pair is held down to 5 degrees. Squares of the sines.
    static constexpr double closingSquare = 0.030153689607045807, heldSquare = 0.0075961234938959;
    /// By how much the normal may lie outside the cone of a wedge: sines of 3 and 30 degrees.
    static constexpr double closing = 0.05, held = 0.5;
};

/// A segment of a sharp edge, relative to some origin: a straight line between two nodes, with the
/// outward unit normals of the two faces that meet there. Face 1 lies on the left of `along`, seen
/// from outside.
template <class T>
struct EdgeSegment {
    Vec3<T> start, along, normal1, normal2;

    /// `far1`, `far2`: twice the middle of the far side of either face.
    FPM_KERNEL
    EdgeSegment(const Vec3<T>& from, const Vec3<T>& to, const Vec3<T>& far1, const Vec3<T>& far2)
        : start(from),
          along(to - from)
    {
        const Vec3<T> middle = from + to;
        normal1 = unit(cross(along, far1 - middle));
        normal2 = unit(cross(far2 - middle, along));
    }
    FPM_KERNEL Vec3<T> at(T share) const { return start + share * along; }
    /// Sine of the angle by which a unit vector normal to the edge lies inside the cone between the
    /// two normals, of the nearer side; negative outside, -1 where it points into the wedge.
    FPM_KERNEL T insideCone(const Vec3<T>& n) const
    {
        if (!(dot(n, normal1 + normal2) > 0)) return T(-1);
        const Vec3<T> axis = unit(along);
        const T first = dot(cross(normal1, n), axis), second = dot(cross(n, normal2), axis);
        return first < second ? first : second;
    }
};

/// Where the lines of two segments a and b come closest, at a(s) and b(t). The gap is their
/// distance along the unit normal, which points out of a and into b: negative where the bodies
/// overlap. With both weights it is a potential: dg/dx = n times -(1-s), -s, 1-t, t.
template <class T>
struct EdgeCrossing {
    T s = 0, t = 0, gap = 0;
    Vec3<T> normal{0, 0, 0};
    T sineSquare = 0; ///< of the angle between the two
    T cone = -1;      ///< insideCone of both wedges, the lesser

    EdgeCrossing() = default;
    FPM_KERNEL EdgeCrossing(const EdgeSegment<T>& a, const EdgeSegment<T>& b)
    {
        const T aa = dot(a.along, a.along), bb = dot(b.along, b.along), ab = dot(a.along, b.along);
        const Vec3<T> across = cross(a.along, b.along);
        const T square = dot(across, across); // aa bb - ab ab, without cancellation
        if (!(square > T(EdgeAngles::heldSquare) * aa * bb)) return;
        sineSquare = square / (aa * bb);
        const Vec3<T> apart = b.start - a.start;
        const T ra = dot(apart, a.along), rb = dot(apart, b.along);
        s = (ra * bb - rb * ab) / square;
        t = (ra * ab - rb * aa) / square;
        normal = (T(1) / squareRoot(square)) * across;
        if (dot(normal, (a.normal1 + a.normal2) - (b.normal1 + b.normal2)) < 0) normal = -normal;
        gap = dot(apart, normal);
        const T ofA = a.insideCone(normal), ofB = b.insideCone(-normal);
        cone = ofA < ofB ? ofA : ofB;
    }

    FPM_KERNEL static bool within(T share, T margin)
    {
        return share >= -margin && share <= T(1) + margin;
    }
    /// Half-open, so that one of two neighbours has a crossing at their joint.
    FPM_KERNEL bool isInner() const { return s >= 0 && s < 1 && t >= 0 && t < 1; }
    FPM_KERNEL bool mayClose() const
    {
        return isInner() && sineSquare > T(EdgeAngles::closingSquare)
               && cone >= T(-EdgeAngles::closing);
    }
    FPM_KERNEL bool mayHold() const { return sineSquare > 0 && cone >= T(-EdgeAngles::held); }
    /// By how much the closest points lie beyond the ends of the segments, in their lengths.
    FPM_KERNEL T beyond() const
    {
        const T ofS = beyond(s), ofT = beyond(t);
        return ofS > ofT ? ofS : ofT;
    }

private:
    FPM_KERNEL static T beyond(T share)
    {
        return share < 0 ? -share : share > 1 ? share - T(1) : T(0);
    }
};

/// Square of the distance of two segments, ends included; for the search.
template <class T>
FPM_KERNEL T distanceSquare(const EdgeSegment<T>& a, const EdgeSegment<T>& b)
{
    const auto clamped = [](T share) { return share < 0 ? T(0) : share > 1 ? T(1) : share; };
    const T aa = dot(a.along, a.along), bb = dot(b.along, b.along), ab = dot(a.along, b.along);
    const Vec3<T> apart = b.start - a.start;
    const Vec3<T> across = cross(a.along, b.along);
    const T square = dot(across, across), ra = dot(apart, a.along), rb = dot(apart, b.along);
    // Of parallel segments any point serves as a start.
    T s = square > 0 ? clamped((ra * bb - rb * ab) / square) : T(0);
    const T t = clamped((s * ab - rb) / bb);
    s = clamped((t * ab + ra) / aa);
    const Vec3<T> offset = apart + t * b.along - s * a.along;
    return dot(offset, offset);
}

/// Orthonormal frame of a pair, e1 midway between the two edges: friction stored in it turns with
/// both bodies alike, by half of what one turns against the other about the normal.
template <class T>
struct EdgeFrame {
    Vec3<T> e1, e2, normal;

    FPM_KERNEL
    EdgeFrame(const EdgeSegment<T>& a, const EdgeSegment<T>& b, const Vec3<T>& n) : normal(n)
    {
        e1 = unit(inPlane(unit(a.along) + unit(b.along), n));
        e2 = cross(n, e1);
    }
    FPM_KERNEL Vec3<T> components(const Vec3<T>& v) const { return {dot(v, e1), dot(v, e2), T(0)}; }
    FPM_KERNEL Vec3<T> vector(const Vec3<T>& c) const { return c.x * e1 + c.y * e2; }
};

/// Forces on the four nodes of a pair, from the force on a: a.start, a.end, b.start, b.end. The
/// friction part acts with couples of forces along the normal at the ends of either segment, so
/// that it has no moment, and its work is force times slip t' b - s' a, which is zero in any common
/// rigid motion.
template <class T>
struct EdgeForces {
    Vec3<T> node[4];

    FPM_KERNEL EdgeForces(const EdgeSegment<T>& a,
                          const EdgeSegment<T>& b,
                          const EdgeCrossing<T>& at,
                          T normalForce,
                          const Vec3<T>& friction)
    {
        const Vec3<T> onA = friction - normalForce * at.normal;
        const T aa = dot(a.along, a.along), bb = dot(b.along, b.along), ab = dot(a.along, b.along),
                fa = dot(friction, a.along), fb = dot(friction, b.along),
                square = aa * bb - ab * ab;
        const T ofA = at.gap * (fa * bb - fb * ab) / square,
                ofB = at.gap * (fb * aa - fa * ab) / square;
        node[0] = (1 - at.s) * onA + ofA * at.normal;
        node[1] = at.s * onA - ofA * at.normal;
        node[2] = ofB * at.normal - (1 - at.t) * onA;
        node[3] = -at.t * onA - ofB * at.normal;
    }
};

} // namespace fpm
