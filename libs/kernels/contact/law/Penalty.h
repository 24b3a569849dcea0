#pragma once

#include "kernels/contact/law/Friction.h"
#include "kernels/contact/law/PenaltyRules.h"
#include "kernels/contact/law/TouchMemory.h"

namespace fpm {

/// Penalty springs, friction and damping of a pass, the same against faces and analytic surfaces.
/// Arrays over contactors; vectors in planes `count` apart.
template <class Work>
struct PassLaw {
    Index count;
    std::int32_t rule;              ///< number in PenaltyRules
    const Work* contactorStiffness; ///< k_n of the contactor's own side; null: not used
    const std::uint8_t*
        mirrors; ///< symmetry planes on which it lies, one bit each; each halves k_n; null: none
    FrictionLaw<Work> friction;
    SlipDamping<Work> slipDamping;
    Work* tangentialForce;     ///< in a face's frame, or in fixed axes
    Index* frictionFace;       ///< face of that frame; null: fixed axes
    double* springEnergy;      ///< recoverable, of normal and tangential spring
    TouchMemory<Work> touch;   ///< of the normal spring
    double* dissipated;        ///< by friction, running sum
    Work dampingRatio;         ///< zeta; 0: no damping, and the arrays below are empty
    const Work* contactorMass; ///< m_c; 0: the contactor cannot move; null: no damping at all
    double* dampingForce;      ///< of the last step
    double* damped;            ///< by contact damping, running sum
    Work limitFactor; ///< factor of the spring's share in the stability bound: (sqrt(1 + zeta^2) +
                      ///< zeta)^2

    /// Penalty stiffness k_n between contactor i and a face. A rigid side has stiffness 0; then the
    /// other side's counts.
    FPM_KERNEL Work stiffness(Index i, Work faceStiffness) const
    {
        Work stiffness = wholeStiffness(i, faceStiffness);
        if (mirrors)
            for (unsigned left = mirrors[i]; left > 0; left &= left - 1) stiffness *= Work(0.5);
        return stiffness;
    }
    FPM_KERNEL Work wholeStiffness(Index i, Work faceStiffness) const
    {
        if (!contactorStiffness) return faceStiffness;
        const Work own = contactorStiffness[i];
        if (!(faceStiffness > 0)) return own;
        return own > 0 ? springStiffness(PenaltyRules{}, rule, own, faceStiffness) : faceStiffness;
    }
    /// m*: the lesser mass of contactor and face, of the sides that can move.
    FPM_KERNEL Work lesserMass(Index i, Work faceMass) const
    {
        const Work own = contactorMass[i];
        return own > 0 && !(faceMass > 0 && faceMass < own) ? own : faceMass;
    }
    FPM_KERNEL bool damps() const { return dampingRatio > 0; }
    /// Whether the law reads the change of the gap in this step.
    FPM_KERNEL bool asksGapChange(Index i, Work gap) const
    {
        return damps() || (gap < 0 && touch.wasOpen(i));
    }

    /// Normal force k_n |g|, eq. (16) of the paper, with what TouchMemory returns, plus damping
    /// -2 zeta sqrt(k_n m*) dg/dt, never tensile. `gapChange`: Delta g_N in this step of length
    /// `step`.
    FPM_KERNEL Work
    normalForce(Index i, Work stiffness, Work gap, Work mass, Work gapChange, double step) const
    {
        const Work elastic = -stiffness * gap + touch.press(i, stiffness, gap, gapChange);
        if (!damps()) return elastic;
        const Work rate = step > 0 ? gapChange / Work(step) : Work(0);
        Work force = Work(-2) * dampingRatio * squareRoot(stiffness * mass) * rate;
        if (force < -elastic) force = -elastic;
        bookDamping(i, double(force), gapChange);
        return elastic + force;
    }
    /// Accounts for the mean damping force of the step times the change of gap.
    FPM_KERNEL void bookDamping(Index i, double force, Work gapChange) const
    {
        damped[i] -= 0.5 * (dampingForce[i] + force) * double(gapChange);
        dampingForce[i] = force;
    }

    FPM_KERNEL Vec3<Work> storedForce(Index i) const
    {
        return {tangentialForce[i], tangentialForce[count + i], tangentialForce[2 * count + i]};
    }
    FPM_KERNEL void store(Index i, const Vec3<Work>& force) const
    {
        tangentialForce[i] = force.x;
        tangentialForce[count + i] = force.y;
        tangentialForce[2 * count + i] = force.z;
    }
    /// Return mapping of friction from the traction `from`; stores the new traction.
    FPM_KERNEL Vec3<Work> slide(Index i,
                                const Vec3<Work>& from,
                                const Vec3<Work>& slip,
                                Work stiffness,
                                Work normal,
                                double step) const
    {
        const Vec3<Work> force =
            frictionForce(friction, from, slip, friction.stiffnessRatio * stiffness, normal, step,
                          dissipated[i], slidingResistance(i, slip, stiffness, step));
        store(i, force);
        return force;
    }
    /// A contactor that cannot move has none.
    FPM_KERNEL Work slidingResistance(Index i,
                                      const Vec3<Work>& slip,
                                      Work stiffness,
                                      double step) const
    {
        if (!slipDamping.acts()) return Work(0);
        return slipDamping.resistance(i, squareRoot(dot(slip, slip)), stiffness, contactorMass[i],
                                      step);
    }
    /// Recoverable energy of the springs.
    FPM_KERNEL double energy(Work stiffness, Work gap, const Vec3<Work>& tangential) const
    {
        Work sum = Work(0.5) * stiffness * gap * gap;
        if (friction.acts() && stiffness > 0) // 0: neither side can move
            sum += dot(tangential, tangential) / (Work(2) * friction.stiffnessRatio * stiffness);
        return double(sum);
    }
    /// Dissipates the energy of a tangential spring with this squared force.
    FPM_KERNEL void lose(Index i, Work square, Work stiffness) const
    {
        if (square > 0)
            dissipated[i] += double(Work(0.5) * square / (friction.stiffnessRatio * stiffness));
    }
    /// Separation: the energy of the tangential spring is dissipated. `gapChange` as in
    /// normalForce; `gap`: where the spring is open now, negative where the contactor was lost.
    FPM_KERNEL void open(Index i, Work stiffness, Work gapChange, Work gap) const
    {
        springEnergy[i] = 0;
        if (gap < 0)
            touch.lose(i);
        else
            touch.open(i, stiffness, gap);
        if (damps()) bookDamping(i, 0, gapChange);
        if (!friction.acts()) return;
        slipDamping.forget(i);
        const Vec3<Work> held = storedForce(i);
        const Work square = dot(held, held);
        if (!(square > 0)) return;
        lose(i, square, stiffness);
        store(i, {Work(0), Work(0), Work(0)});
    }
};

} // namespace fpm
