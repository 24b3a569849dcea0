#pragma once

#include "kernels/contact/narrow/SignedGap.h"

namespace fpm {

/// Whether the squares of two distances are equal within the deviation from symmetry and the
/// rounding of positions. `size`: square of a face's diagonal.
template <class Work>
FPM_KERNEL bool isAsNear(Work other, Work here, Work size)
{
    using Tolerances = ContactTolerances<Work>;
    const Work share = Tolerances::symmetric, apart = other - here;
    return apart * apart < here * (share * share * here + Tolerances::positionSquare * size);
}
/// Whether the projection points on two faces are distinct, not one point of a common edge.
/// Arguments: offsets of the contactor from them.
template <class Work>
FPM_KERNEL bool areDistinctPoints(const Vec3<Work>& a, const Vec3<Work>& b, Work size)
{
    constexpr Work width = ContactTolerances<Work>::distinct;
    const Vec3<Work> apart = a - b;
    return dot(apart, apart) > width * width * size;
}

/// A face, or its image in planes of symmetry, one bit each: as the contactor's own image meets the
/// face.
struct FaceImage {
    Index face;
    Index planes; ///< 0: the face itself
};

/// Position of the contactor's image in planes through a point, relative to the contactor.
template <class Numbers>
FPM_KERNEL Vec3<typename Numbers::Work> imageShift(const ContactPassView<Numbers>& pass,
                                                   Index planes,
                                                   const Vec3<typename Numbers::Work>& through)
{
    using Work = typename Numbers::Work;
    Vec3<Work> shift{0, 0, 0};
    for (Index k = 0; planes >> k; ++k)
        if (planes >> k & 1)
            shift =
                multiplyAdd(Work(2) * dot(through - shift, pass.mirror(k)), pass.mirror(k), shift);
    return shift;
}
template <class Work>
FPM_KERNEL FaceCorners<Work> shifted(FaceCorners<Work> face, const Vec3<Work>& shift)
{
    for (int k = 0; k < 4; ++k) face.corner[k] = face.corner[k] - shift;
    return face;
}

/// Faces beside the tracked one that a contactor inside a ridge is about as near to.
template <class Work>
struct RidgeFaces {
    static constexpr int most = 7;
    int count = 0;
    FaceImage face[most];
    Vec3<Work> shift[most]; ///< of the contactor's image
    Work xi[most], eta[most], gap[most];
    Vec3<Work> normal[most], offset[most]; ///< of the image

    /// Enters a face; one whose projection point is that of another is one with it. `tracked`:
    /// offset of the contactor from the tracked face; `size`: square of a diagonal.
    FPM_KERNEL void add(const FaceImage& number,
                        const Vec3<Work>& moved,
                        const Projection<Work>& at,
                        const Vec3<Work>& tracked,
                        Work size)
    {
        if (count == most || !areDistinctPoints(tracked, at.offset, size)) return;
        for (int k = 0; k < count; ++k)
            if (!areDistinctPoints(offset[k], at.offset, size)) return;
        face[count] = number;
        shift[count] = moved;
        xi[count] = at.xi;
        eta[count] = at.eta;
        gap[count] = at.gap;
        normal[count] = at.normal;
        offset[count] = at.offset;
        ++count;
    }
};

/// Depth inside a ridge of several faces. The depth to the nearest of them has a kink in the planes
/// midway between them, where the force of its potential would jump. This one is smooth, of degree
/// one in the depths d_i, and the depth to the nearest wherever that is the nearest by more than a
/// share of the depth that the angle of the faces sets:
///     D = min over weights w_i >= 0, sum w_i = 1, of  sum w_i d_i / (1 + f sum_i<j w_i w_j m_ij)
/// with m_ij = |n_i - n_j|^(2 - 1/8) of the directions n_i in which the d_i fall. With the power 2
/// the sum would be 1 - |sum w_i n_i|^2 and the weights of four faces around a corner not unique.
/// Faces in one plane are not blended, and the force of k D^2 / 2 changes by no more than some k
/// times the motion (ContactContinuity tests). The derivatives by d_i are w_i / (1 + ...), at the
/// minimum; those by the directions, which turn where faces are warped, are left out.
template <class Work>
struct RidgeDepth {
    static constexpr int most = 8;
    /// With 1/2 the blend would reach to the end of the faces.
    static constexpr Work factor = Work(0.2);

    int count = 0;
    Work given[most], weight[most], turn[most][most];
    Vec3<Work> normal[most];
    Work depth = 0, bottom = 1;

    FPM_KERNEL void add(Work inside, const Vec3<Work>& direction)
    {
        given[count] = inside;
        weight[count] = count == 0 ? Work(1) : Work(0);
        normal[count] = direction;
        for (int k = 0; k <= count; ++k)
            turn[k][count] = turn[count][k] = turnBetween(normal[k], direction);
        ++count;
    }
    FPM_KERNEL Work derivative(int k) const { return weight[k] / bottom; }

    /// m_ij of two normals.
    FPM_KERNEL static Work turnBetween(const Vec3<Work>& a, const Vec3<Work>& b)
    {
        const Vec3<Work> apart = a - b;
        const Work square = dot(apart, apart);
        if (!(square > 0)) return 0;
        return square / squareRoot(squareRoot(squareRoot(squareRoot(square))));
    }

    /// Moves weight between two faces at a time, each time to the minimum: two need it once.
    FPM_KERNEL void solve()
    {
        Work top = given[0];
        bottom = 1;
        const int sweeps = count == 2 ? 1 : 200;
        for (int sweep = 0; sweep < sweeps; ++sweep) {
            Work largest = 0;
            for (int i = 0; i < count; ++i)
                for (int j = 0; j < i; ++j) {
                    const Work moved = move(i, j, top);
                    largest = moved > largest ? moved : largest;
                }
            if (!(largest > ContactTolerances<Work>::shares)) break;
        }
        depth = top / bottom;
    }

private:
    /// Moves weight from face j to face i, or back; returns how much.
    FPM_KERNEL Work move(int i, int j, Work& top)
    {
        Work linear = 0;
        for (int k = 0; k < count; ++k) linear += weight[k] * (turn[i][k] - turn[j][k]);
        const Work pair = factor * turn[i][j];
        linear = factor * linear;
        const Work a = given[i] - given[j], slope = a * bottom - top * linear, least = -weight[i],
                   largest = weight[j];
        // Of top + a t over bottom + linear t - pair t^2 the derivative vanishes at the root that
        // is the smaller in size.
        const Work under = top * top * pair * pair - a * pair * slope;
        const Work divisor = top * pair + (under > 0 ? squareRoot(under) : Work(0));
        Work t = slope > 0 ? least : largest;
        if (under > 0 && divisor > 0) t = -slope / divisor;
        if (slope == 0) t = 0;
        t = t < least ? least : t > largest ? largest : t;
        weight[i] += t;
        weight[j] -= t;
        top += t * a;
        bottom += t * (linear - t * pair);
        return t < 0 ? -t : t;
    }
};

} // namespace fpm
