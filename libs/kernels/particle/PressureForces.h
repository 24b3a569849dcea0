#pragma once

#include "kernels/particle/Amplitude.h"
#include "kernels/particle/StepClock.h"
#include "parallel/Precision.h"
#include "parallel/Vec3.h"

namespace fpm {

/// Forces of a pressure on the corners of one face, -p times the integral of N_I n dA over the
/// bilinear face: its area vector is linear in xi and eta, so the integral is exact and the
/// resultant and moment on a closed surface are zero. `x`: corners, counter-clockwise seen from
/// outside.
template <class Real>
FPM_KERNEL void pressureOnFace(const Vec3<Real> (&x)[4], Real pressure, Vec3<Real> (&force)[4])
{
    const Vec3<Real> b = (x[1] - x[0]) + (x[2] - x[3]), c = (x[3] - x[0]) + (x[2] - x[1]),
                     d = (x[0] - x[1]) + (x[2] - x[3]);
    const Real share = -pressure / Real(16), third = Real(1) / Real(3);
    const Vec3<Real> mean = share * cross(b, c), alongXi = (share * third) * cross(b, d),
                     alongEta = (share * third) * cross(d, c);
    force[0] = mean - alongXi - alongEta;
    force[1] = mean + alongXi - alongEta;
    force[2] = mean + alongXi + alongEta;
    force[3] = mean - alongXi + alongEta;
}

/// Pressures on faces at the clock's time, each corner force into a slot of its own.
template <class Numbers>
struct PressureForces {
    using Motion = typename Numbers::Motion;

    const Index* faceNode;      ///< [4 * face + corner]
    const Index* faceCondition; ///< -1: none any longer
    const Condition* conditions;
    const double* amplitudeRows;
    const typename Numbers::Position* position;
    std::size_t nodeStride;
    Motion* slotForce; ///< three planes, slotStride apart; slot = 4 * face + corner
    std::size_t slotStride;
    const StepClock* clock;

    FPM_KERNEL void operator()(Index face) const
    {
        if (!clock->running) return;
        const Index* nodes = faceNode + 4 * std::size_t(face);
        const bool presses = faceCondition[face] >= 0;
        Vec3<Motion> x[4], force[4] = {};
        for (int i = 0; i < 4; ++i) {
            const std::size_t a = std::size_t(nodes[i]), o = std::size_t(nodes[0]);
            x[i] = {difference<Motion>(position[a], position[o]),
                    difference<Motion>(position[nodeStride + a], position[nodeStride + o]),
                    difference<Motion>(position[2 * nodeStride + a], position[2 * nodeStride + o])};
        }
        if (presses) {
            const Condition& condition = conditions[faceCondition[face]];
            const double factor = amplitudeAt(condition, amplitudeRows, clock->time);
            pressureOnFace(x, Motion(condition.value[0] * factor), force);
        }
        for (int i = 0; i < 4; ++i) {
            const std::size_t slot = 4 * std::size_t(face) + std::size_t(i);
            slotForce[slot] = force[i].x;
            slotForce[slotStride + slot] = force[i].y;
            slotForce[2 * slotStride + slot] = force[i].z;
        }
    }
};

} // namespace fpm
