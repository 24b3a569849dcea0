#pragma once

#include "kernels/contact/narrow/FaceProjection.h"

namespace fpm {

/// Region of a face that holds its closest point: the interior (with the borders, within rounding),
/// edge k from corner k to k + 1, or corner k (4 + k).
inline constexpr int insideFace = -1;
inline constexpr int firstCorner = 4;

/// Point of a face that is nearest to the contactor: the closest-point projection.
template <class Work>
struct FacePoint {
    Work xi, eta, square; ///< square of the distance
    int where;
};

/// Natural coordinates of the point at the fraction `t` of an edge.
template <class Work>
FPM_KERNEL void edgePoint(int edge, Work t, Work& xi, Work& eta)
{
    const Work along = t + t - 1;
    xi = edge == 0 ? along : edge == 1 ? Work(1) : edge == 2 ? -along : Work(-1);
    eta = edge == 0 ? Work(-1) : edge == 1 ? along : edge == 2 ? Work(1) : -along;
}

/// Fraction of the edge at which a point on it lies.
template <class Work>
FPM_KERNEL Work shareAlong(int edge, Work xi, Work eta)
{
    return Work(0.5) * (1 + (edge == 0 ? xi : edge == 1 ? eta : edge == 2 ? -xi : -eta));
}

/// Nearest point of the four edges.
template <class Work>
FPM_KERNEL FacePoint<Work> closestRimPoint(const FaceCorners<Work>& face)
{
    FacePoint<Work> best{0, 0, 0, insideFace};
    for (int edge = 0; edge < 4; ++edge) {
        const int end = (edge + 1) & 3;
        const Vec3<Work>& a = face.corner[edge];
        const Vec3<Work> e = face.corner[end] - a;
        const Work size = dot(e, e), along = -dot(a, e);
        const Work t = !(along > 0) ? Work(0) : along >= size ? Work(1) : along / size;
        const Vec3<Work> r = multiplyAdd(t, e, a);
        const Work square = dot(r, r);
        if (best.where != insideFace && !(square < best.square)) continue;
        best.square = square;
        best.where = t == 0 ? firstCorner + edge : t == 1 ? firstCorner + end : edge;
        edgePoint(edge, t, best.xi, best.eta);
    }
    return best;
}

/// Whether the contactor lies on the inner side of the edge as seen from a point on it; then a
/// point inside the face is nearer.
template <class Work>
FPM_KERNEL bool pullsInwards(const FaceCorners<Work>& face, const FacePoint<Work>& rim)
{
    if (rim.where >= firstCorner) return false;
    Vec3<Work> r, t1, t2;
    evaluateFace(face, rim.xi, rim.eta, r, t1, t2);
    const Vec3<Work> inwards = rim.where == 0   ? t2
                               : rim.where == 1 ? -t1
                               : rim.where == 2 ? -t2
                                                : t1;
    const Work pull = dot(r, inwards), little = ContactTolerances<Work>::inwards;
    return pull > 0 && pull * pull > little * rim.square * dot(inwards, inwards);
}

/// Nearest point of the triangles 0 1 2 and 0 2 3, in the natural coordinates of the face.
template <class Work>
FPM_KERNEL FacePoint<Work> closestTrianglePoint(const FaceCorners<Work>& face,
                                                const FacePoint<Work>& rim)
{
    FacePoint<Work> best = rim;
    const Vec3<Work>*x = face.corner, diagonal = x[2] - x[0];
    const auto improve = [&](Work s, Work t, const Vec3<Work>& r) {
        const Work square = dot(r, r);
        if (!(square < best.square)) return;
        best = {s + s - 1, t + t - 1, square, insideFace};
    };
    const Work size = dot(diagonal, diagonal), along = -dot(x[0], diagonal);
    if (along > 0 && along < size) {
        const Work t = along / size;
        improve(t, t, multiplyAdd(t, diagonal, x[0]));
    }
    for (int half = 0; half < 2; ++half) {
        const Vec3<Work> a = half == 0 ? x[1] - x[0] : diagonal,
                         b = half == 0 ? diagonal : x[3] - x[0];
        const Work aa = dot(a, a), bb = dot(b, b), ab = dot(a, b), pa = -dot(x[0], a),
                   pb = -dot(x[0], b), determinant = aa * bb - ab * ab;
        if (!(determinant > 0)) continue;
        const Work u = (pa * bb - pb * ab) / determinant, v = (pb * aa - pa * ab) / determinant;
        if (u < 0 || v < 0 || u + v > 1) continue;
        const Vec3<Work> r = multiplyAdd(u, a, multiplyAdd(v, b, x[0]));
        if (half == 0)
            improve(u + v, v, r);
        else
            improve(u, u + v, r);
    }
    return best;
}

/// Closest-point projection onto a face, from a start value near it or (0, 0): Newton's method
/// inside, eq. (14) of the paper; beyond |xi| = 1 or |eta| = 1 the nearest point of the four edges;
/// the nearest point of two triangles where Newton's method fails, as it may on strongly warped
/// faces one face width away.
template <class Work>
FPM_KERNEL FacePoint<Work> closestPoint(const FaceCorners<Work>& face, Work xi, Work eta)
{
    FacePoint<Work> rim{0, 0, 0, insideFace};
    for (int attempt = 0; attempt < 2; ++attempt) {
        const bool found = project(face, xi, eta);
        if (found && isInside(xi, eta)) {
            xi = clampedUnit(xi);
            eta = clampedUnit(eta);
            Vec3<Work> r, t1, t2;
            evaluateFace(face, xi, eta, r, t1, t2);
            return {xi, eta, dot(r, r), insideFace};
        }
        if (attempt == 1) break;
        rim = closestRimPoint(face);
        if (!pullsInwards(face, rim)) return rim;
        xi = Work(0.5) * rim.xi;
        eta = Work(0.5) * rim.eta;
    }
    return closestTrianglePoint(face, rim);
}

} // namespace fpm
