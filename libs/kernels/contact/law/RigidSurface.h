#pragma once

#include "kernels/contact/distribute/ForceSum.h"
#include "kernels/contact/law/Penalty.h"
#include "kernels/contact/law/SurfaceShape.h"
#include "kernels/particle/StepClock.h"
#include "parallel/Precision.h"

namespace fpm {

/// Penalty and friction force of one contactor against an analytic surface: exact gap and normal,
/// neither faces nor search. Arrays over contactors, as in ContactPassView.
template <class Numbers>
struct SurfaceForce {
    using Work = typename Numbers::Work;

    Index contactorCount;
    const Index* contactor;
    const Index* contactNumber; ///< of each node
    double* force;              ///< on the contactor in this step
    double* work;               ///< done by the moving surface, running sum
    const typename Numbers::Position* position;
    const typename Numbers::Motion* velocity;
    std::size_t nodeStride;
    ContactSums sums;
    const StepClock* clock;
    const double* amplitudeRows;
    double reach;   ///< gap below which a spring enters the stability bound
    double deepest; ///< depth beyond which the force is constant, so that fixed-point sums cannot
                    ///< overflow
    SurfaceShape shape;
    PassLaw<Work> law;

    FPM_KERNEL void operator()(Index i) const
    {
        if (!clock->running) return;
        const std::size_t node = std::size_t(contactor[i]);
        const double now = clock->time, step = clock->step;
        const Vec3<double> moved = shape.displacement(amplitudeRows, now);
        const Vec3<double> x =
            Vec3<double>{double(position[node]), double(position[nodeStride + node]),
                         double(position[2 * nodeStride + node])}
            - moved;
        const SurfacePoint at = shape.at(x);
        const bool near = at.opposite && at.gap < reach;
        const Vec3<double> before = lastForce(i);
        // A contactor out of reach that was separated before contributes nothing.
        if (!near && !(law.springEnergy[i] > 0)) return;
        const Vec3<double> surfaceDisplacement =
            moved - shape.displacement(amplitudeRows, now - step);
        const Vec3<double> displacement =
            step
                * Vec3<double>{double(velocity[node]), double(velocity[nodeStride + node]),
                               double(velocity[2 * nodeStride + node])}
            - surfaceDisplacement;
        const Work stiffness = law.stiffness(i, Work(0));
        std::int64_t fixed[3] = {0, 0, 0};
        if (near && at.gap < 0)
            applyForces(i, at, x, displacement, stiffness, fixed);
        else
            law.open(i, stiffness, Work(dot(displacement, at.normal)),
                     Work(at.opposite ? at.gap : -1));
        distribute(i, near, stiffness, fixed);
        if (shape.moves) work[i] += 0.5 * dot(before + lastForce(i), surfaceDisplacement);
    }

private:
    FPM_KERNEL Vec3<double> lastForce(Index i) const
    {
        return {force[i], force[contactorCount + i], force[2 * contactorCount + i]};
    }

    FPM_KERNEL void applyForces(Index i,
                                const SurfacePoint& at,
                                const Vec3<double>& x,
                                const Vec3<double>& displacement,
                                Work stiffness,
                                std::int64_t (&fixed)[3]) const
    {
        const double step = clock->step;
        const Work gap = Work(at.gap > -deepest ? at.gap : -deepest);
        const Work normalForce =
            law.normalForce(i, stiffness, gap, law.damps() ? law.contactorMass[i] : Work(0),
                            Work(dot(displacement, at.normal)), step);
        const Vec3<Work> normal = toWork(at.normal);
        Vec3<Work> total = normalForce * normal, held{0, 0, 0};
        if (law.friction.acts()) {
            held = law.storedForce(i);
            if (!law.friction.paper) {
                const SurfacePoint last = shape.at(x - displacement);
                if (last.opposite) held = turnedPlane(held, toWork(last.normal), normal);
            }
            held = law.slide(i, held, toWork(inPlane(displacement, at.normal)), stiffness,
                             normalForce, step);
            total += held;
        }
        law.springEnergy[i] = law.energy(stiffness, gap, held);
        fixed[0] = sums.scale.force(double(total.x));
        fixed[1] = sums.scale.force(double(total.y));
        fixed[2] = sums.scale.force(double(total.z));
    }

    FPM_KERNEL void
    distribute(Index i, bool near, Work stiffness, const std::int64_t (&fixed)[3]) const
    {
        const Index number = contactNumber[contactor[i]];
        if (fixed[0] != 0 || fixed[1] != 0 || fixed[2] != 0) sums.addForce(number, fixed);
        for (int c = 0; c < 3; ++c) force[c * contactorCount + i] = sums.scale.toForce(fixed[c]);
        if (near) sums.addStiffness(number, double(Work(2) * law.limitFactor * stiffness));
    }
    FPM_KERNEL static Vec3<Work> toWork(const Vec3<double>& v)
    {
        return {Work(v.x), Work(v.y), Work(v.z)};
    }
};

} // namespace fpm
