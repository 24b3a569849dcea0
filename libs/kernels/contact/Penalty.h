#pragma once

#include "kernels/contact/Friction.h"
#include "kernels/contact/PenaltyRules.h"

namespace fpm {

/// Springs, friction and damping of a pair, the same against faces and against analytic surfaces.
/// Arrays over contactors; vectors in planes `count` apart.
template <class Work>
struct PassLaw {
    Index count;
    std::int32_t rule;              ///< number in PenaltyRules
    const Work* contactorStiffness; ///< k_n the contactor's own side gives; null: not asked for
    const std::uint8_t*
        mirrors; ///< planes of symmetry it lies on, a bit each, each halves it; null: none
    FrictionLaw<Work> friction;
    Work* stored;              ///< tangential force: two components in a face's frame, or a vector
    Index* storedFace;         ///< whose frame that is; null where `stored` is a vector in space
    double* spring;            ///< recoverable energy of normal and tangential spring
    double* dissipated;        ///< by friction, running sum
    Work dampingRatio;         ///< zeta; 0: none, and the arrays below are empty
    const Work* contactorMass; ///< m_c; 0: nothing can move the contactor
    double* dampingForce;      ///< at the last step
    double* damped;            ///< by contact damping, running sum
    Work limitFactor; ///< of the spring's share in the step bound: (sqrt(1 + zeta^2) + zeta)^2

    /// k_n between contactor i and a face. A rigid side has stiffness 0: the other's counts.
    FPM_KERNEL Work stiffness(Index i, Work face) const
    {
        Work stiffness = wholeStiffness(i, face);
        if (mirrors)
            for (unsigned left = mirrors[i]; left > 0; left &= left - 1) stiffness *= Work(0.5);
        return stiffness;
    }
    FPM_KERNEL Work wholeStiffness(Index i, Work face) const
    {
        if (!contactorStiffness) return face;
        const Work own = contactorStiffness[i];
        if (!(face > 0)) return own;
        return own > 0 ? springStiffness(rule, own, face) : face;
    }
    /// m*: the lesser mass of contactor and face, of those that can be moved.
    FPM_KERNEL Work lesserMass(Index i, Work face) const
    {
        const Work own = contactorMass[i];
        return own > 0 && !(face > 0 && face < own) ? own : face;
    }
    FPM_KERNEL bool damps() const { return dampingRatio > 0; }

    /// Normal force k |g| plus damping -2 zeta sqrt(k m*) dg/dt, never tensile. `gapChange`: change
    /// of the gap in this step, which took `step`.
    FPM_KERNEL Work
    normalForce(Index i, Work stiffness, Work gap, Work mass, Work gapChange, double step) const
    {
        const Work elastic = -stiffness * gap;
        if (!damps()) return elastic;
        const Work rate = step > 0 ? gapChange / Work(step) : Work(0);
        Work force = Work(-2) * dampingRatio * squareRoot(stiffness * mass) * rate;
        if (force < -elastic) force = -elastic;
        bookDamping(i, double(force), gapChange);
        return elastic + force;
    }
    /// Mean damping force of the step times its way.
    FPM_KERNEL void bookDamping(Index i, double force, Work gapChange) const
    {
        damped[i] -= 0.5 * (dampingForce[i] + force) * double(gapChange);
        dampingForce[i] = force;
    }

    FPM_KERNEL Vec3<Work> storedVector(Index i) const
    {
        return {stored[i], stored[count + i], storedFace ? Work(0) : stored[2 * count + i]};
    }
    FPM_KERNEL void store(Index i, const Vec3<Work>& force) const
    {
        stored[i] = force.x;
        stored[count + i] = force.y;
        if (!storedFace) stored[2 * count + i] = force.z;
    }
    /// Friction with elastic slip from the stored force on; stores the new one.
    FPM_KERNEL Vec3<Work> slide(Index i,
                                const Vec3<Work>& from,
                                const Vec3<Work>& slip,
                                Work k,
                                Work normal,
                                double step) const
    {
        const Vec3<Work> force = frictionForce(friction, from, slip, friction.stiffnessRatio * k,
                                               normal, step, dissipated[i]);
        store(i, force);
        return force;
    }
    /// Recoverable energy of the springs.
    FPM_KERNEL double energy(Work k, Work gap, const Vec3<Work>& tangential) const
    {
        Work sum = Work(0.5) * k * gap * gap;
        if (friction.acts() && k > 0) // 0: neither side can move
            sum += dot(tangential, tangential) / (Work(2) * friction.stiffnessRatio * k);
        return double(sum);
    }
    /// The tangential spring, of the square of its force, is lost to friction.
    FPM_KERNEL void lose(Index i, Work square, Work k) const
    {
        if (square > 0) dissipated[i] += double(Work(0.5) * square / (friction.stiffnessRatio * k));
    }
    /// No touch: what the tangential spring still held is lost to friction. `gapChange` as above.
    FPM_KERNEL void open(Index i, Work k, Work gapChange) const
    {
        spring[i] = 0;
        if (damps()) bookDamping(i, 0, gapChange);
        if (!friction.acts()) return;
        const Vec3<Work> held = storedVector(i);
        const Work square = dot(held, held);
        if (!(square > 0)) return;
        lose(i, square, k);
        store(i, {Work(0), Work(0), Work(0)});
    }
};

} // namespace fpm
