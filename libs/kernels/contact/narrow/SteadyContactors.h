#pragma once

#include "kernels/contact/narrow/ContactPoint.h"

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

} // namespace fpm
