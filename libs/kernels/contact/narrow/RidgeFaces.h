#pragma once

#include "kernels/contact/narrow/SignedGap.h"

namespace fpm {

/// Relative deviation from symmetry up to which two quantities count as equal: larger than what
/// rounding makes of a symmetric model during a run.
template <class Work>
FPM_KERNEL constexpr Work symmetryShare()
{
    return sizeof(Work) == 8 ? Work(1e-5) : Work(1e-4);
}
/// Whether the squares of the distances to two faces are equal within that deviation and the
/// rounding of positions. `size`: square of a face's diagonal.
template <class Work>
FPM_KERNEL bool isAsNear(Work other, Work here, Work size)
{
    constexpr Work share = symmetryShare<Work>();
    const Work rounding = sizeof(Work) == 8 ? Work(1e-20) : Work(1e-12), apart = other - here;
    return apart * apart < here * (share * share * here + rounding * size);
}
/// Whether the projection points on two faces are distinct, not one point of a common edge.
/// Arguments: offsets of the contactor from them.
template <class Work>
FPM_KERNEL bool areDistinctPoints(const Vec3<Work>& a, const Vec3<Work>& b, Work size)
{
    constexpr Work width = sizeof(Work) == 8 ? Work(1e-13) : Work(1e-6);
    const Vec3<Work> apart = a - b;
    return dot(apart, apart) > width * width * size;
}
template <class Work>
FPM_KERNEL Vec3<Work> offsetOn(const FaceCorners<Work>& face, Work xi, Work eta)
{
    Vec3<Work> offset, t1, t2;
    evaluateFace(face, xi, eta, offset, t1, t2);
    return offset;
}
template <class Work>
FPM_KERNEL Work squareOfDiagonal(const FaceCorners<Work>& face)
{
    const Vec3<Work> diagonal = face.corner[2] - face.corner[0];
    return dot(diagonal, diagonal);
}

template <class Numbers>
FPM_KERNEL bool haveEdgeInCommon(const ContactPassView<Numbers>& pass, Index a, Index b)
{
    for (int edge = 0; edge < 4; ++edge) {
        const Index across = pass.neighbour[4 * std::size_t(a) + std::size_t(edge)];
        if (across >= 0 && across / 4 == b) return true;
    }
    return false;
}

/// Faces to which a contactor inside a ridge is as near as to `face`, with projection points inside
/// all of them: at most four around one corner. They take equal shares of the force; with one face
/// alone a symmetric scene would drift to one side.
template <class Numbers>
struct RidgeFaces {
    using Work = typename Numbers::Work;
    static constexpr int most = 4;

    Index face[most]; ///< the first is the face it is tracked on
    Work xi[most], eta[most];
    Vec3<Work> normal[most], offset[most];
    bool adjacent[most]; ///< shares an edge with the first
    int count = 1;

    FPM_KERNEL
    RidgeFaces(const ContactPassView<Numbers>& pass,
               Index i,
               Index first,
               const Projection<Work>& at)
    {
        face[0] = first;
        xi[0] = at.xi;
        eta[0] = at.eta;
        normal[0] = at.normal;
        offset[0] = at.offset;
        adjacent[0] = true;
        const int corner = at.xi > 0 ? (at.eta > 0 ? 2 : 1) : (at.eta > 0 ? 3 : 0);
        const Work square = at.gap * at.gap;
        pass.visitAround(
            first, corner, [&](Index other) __attribute__((always_inline)) {
                if (other != first && pass.mayTouch(i, other)) add(pass, i, other, square);
                return count < most;
            });
    }

    /// Image of a force on the first face at another: mirrored in the plane midway between two
    /// neighbours, rotated by half a turn about the midline of faces that share only a corner.
    FPM_KERNEL Vec3<Work> image(int k, const Vec3<Work>& force) const
    {
        if (k == 0) return force;
        const Vec3<Work> axis = adjacent[k] ? normal[0] - normal[k] : normal[0] + normal[k];
        const Work square = dot(axis, axis), two = adjacent[k] ? Work(-2) : Work(2);
        if (!(square > 0)) return force;
        const Vec3<Work> along = (two * dot(force, axis) / square) * axis;
        return adjacent[k] ? force + along : along - force;
    }

private:
    FPM_KERNEL void add(const ContactPassView<Numbers>& pass, Index i, Index other, Work square)
    {
        const FaceCorners<Work> corners = pass.corners(other, pass.contactor[i]);
        const FacePoint<Work> point = closestPoint(corners, Work(0), Work(0));
        if (point.where != insideFace || !isAsNear(point.square, square, squareOfDiagonal(corners)))
            return;
        const Projection<Work> at = gapAt(corners, point.xi, point.eta);
        if (!(at.gap < 0) || isNotOpposing(pass, i, at.normal)) return;
        for (int k = 0; k < count; ++k)
            if (!areDistinctPoints(offset[k], at.offset, squareOfDiagonal(corners))) return;
        face[count] = other;
        xi[count] = point.xi;
        eta[count] = point.eta;
        normal[count] = at.normal;
        offset[count] = at.offset;
        adjacent[count] = haveEdgeInCommon(pass, face[0], other);
        ++count;
    }
};

} // namespace fpm
