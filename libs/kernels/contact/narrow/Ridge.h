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

/// Faces beside the tracked one that a contactor inside a ridge is about as near to.
template <class Work>
struct RidgeFaces {
    static constexpr int most = 7;
    int count = 0;
    Index face[most];
    Work xi[most], eta[most], gap[most];
    Vec3<Work> normal[most], offset[most];

    /// Enters a face that is no farther than the blend reaches; points entered before are one with
    /// it.
    FPM_KERNEL void
    add(Index number, const Projection<Work>& at, const Vec3<Work>& trackedOffset, Work size)
    {
        if (count == most || !areDistinctPoints(trackedOffset, at.offset, size)) return;
        for (int k = 0; k < count; ++k)
            if (face[k] == number || !areDistinctPoints(offset[k], at.offset, size)) return;
        face[count] = number;
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
///     D = min over weights w_i >= 0, sum w_i = 1, of  sum w_i d_i / (1 + (1 - |sum w_i n_i|^2) /
///     4)
/// Faces in one plane are not blended, and the force of k D^2 / 2 changes by no more than 2 k times
/// the motion. Its derivatives are w_i / (1 + ...), at the minimum.
template <class Work>
struct RidgeDepth {
    static constexpr int most = 8;
    /// Half of 1/2: with 1 the blend would reach to the end of the faces.
    static constexpr Work factor = Work(0.25);

    int count = 0;
    Work given[most], weight[most];
    Vec3<Work> normal[most];
    Work depth = 0, bottom = 1;

    FPM_KERNEL void add(Work inside, const Vec3<Work>& unitNormal)
    {
        given[count] = inside;
        weight[count] = count == 0 ? Work(1) : Work(0);
        normal[count++] = unitNormal;
    }
    FPM_KERNEL Work derivative(int k) const { return weight[k] / bottom; }

    /// Moves weight between two faces at a time, each time to the minimum: two need it once.
    FPM_KERNEL void solve()
    {
        Work top = given[0];
        Vec3<Work> mean = normal[0];
        bottom = Work(1) + factor * (Work(1) - dot(mean, mean));
        const int sweeps = count == 2 ? 1 : 40;
        for (int sweep = 0; sweep < sweeps; ++sweep) {
            Work largest = 0;
            for (int i = 0; i < count; ++i)
                for (int j = 0; j < i; ++j) {
                    const Work moved = move(i, j, top, mean);
                    largest = moved > largest ? moved : largest;
                }
            if (!(largest > ContactTolerances<Work>::shares)) break;
        }
        depth = top / bottom;
    }

private:
    /// Moves weight from face j to face i, or back; returns how much.
    FPM_KERNEL Work move(int i, int j, Work& top, Vec3<Work>& mean)
    {
        const Vec3<Work> apart = normal[i] - normal[j];
        const Work a = given[i] - given[j], linear = Work(2) * factor * dot(mean, apart),
                   square = factor * dot(apart, apart), slope = a * bottom + top * linear,
                   least = -weight[i], largest = weight[j];
        // Of top + a t over bottom - linear t - square t^2 the derivative vanishes at the root that
        // is the smaller in size.
        const Work under = top * top * square * square - a * square * slope;
        const Work divisor = top * square + (under > 0 ? squareRoot(under) : Work(0));
        Work t = slope > 0 ? least : largest;
        if (under > 0 && divisor > 0) t = -slope / divisor;
        if (slope == 0) t = 0;
        t = t < least ? least : t > largest ? largest : t;
        weight[i] += t;
        weight[j] -= t;
        top += t * a;
        mean = multiplyAdd(t, apart, mean);
        bottom = Work(1) + factor * (Work(1) - dot(mean, mean));
        return t < 0 ? -t : t;
    }
};

} // namespace fpm
