#pragma once

#include "kernels/element/Gradient.h"
#include "kernels/material/MaterialConstants.h"

namespace fpm {

/// Input of every hourglass form: mode 4 + j belongs to Gamma_{order} of Flanagan and Belytschko.
/// Modes have the order eta zeta, zeta xi, xi eta, xi eta zeta.
FPM_KERNEL constexpr int hourglassMode(int j)
{
    return j == 0 ? 5 : j == 1 ? 6 : j == 2 ? 4 : 7;
}

template <class T>
struct HourglassInput {
    const Modes<T>& middle;          ///< geometry at mid-step
    const Modes<T>& end;             ///< at the end of the step, in the same axes
    const Modes<T>& deformation;     ///< increment without rotation
    const Mat3<T>& velocityGradient; ///< mean, times the step
    const Mat3<T>& rotation;         ///< R - I over the step
    T volume, inverseVolume;
    T gradientSquare; ///< sum B_iI B_iI
    T rate;           ///< 1 / step, 0 when the step is 0
    T density;        ///< current

    /// dq_j: hourglass part of the increment, zero for every linear field.
    FPM_KERNEL Vec3<T> increment(int j) const
    {
        const int m = hourglassMode(j);
        return deformation.mode[m] - velocityGradient * middle.mode[m];
    }
};

/// Trial state of a step: work of the forces at its start, and at its end, over half of the step.
template <class T>
struct HourglassTrial {
    T workStart, workTrial;       ///< of spurious motions that one point does not see
    T bendingStart, bendingTrial; ///< of the bending of the section, part of the strain energy
    T bending;       ///< equivalent bending stress of the section, 0 where the form has none
    T bendingEnergy; ///< twice the elastic energy of that bending per volume
};

/// Artificial stiffness (Flanagan and Belytschko 1981), k = kappa (lambda + 2 mu) B B / (8 V);
/// kappa = 1 gives the highest frequency of a brick; up to 0.2 the stable step of no warped element
/// changes. Q rotates with the element.
struct StiffnessHourglass {
    static constexpr const char* word = "stiffness";
    static constexpr int stateSize = 12;
    static constexpr double presetCoefficient = 0.05, largestCoefficient = 0.2;

    template <class T>
    FPM_KERNEL static HourglassTrial<T>
    trial(const MaterialConstants<ScalarOf<T>>& m, const HourglassInput<T>& in, Vec3<T> (&q)[4])
    {
        const T half = T(ScalarOf<T>(0.5));
        const T k = stiffness<T>(m, in.gradientSquare, in.inverseVolume);
        const T zero = T(ScalarOf<T>(0));
        HourglassTrial<T> out{zero, zero, zero, zero, zero, zero};
        for (int j = 0; j < 4; ++j) {
            const Vec3<T> dq = in.increment(j);
            const Vec3<T> turned = q[j] + in.rotation * q[j];
            q[j] = multiplyAdd(k, dq, turned);
            out.workStart += half * dot(dq, turned);
            out.workTrial += half * dot(dq, q[j]);
        }
        return out;
    }

    /// k of dQ = k dq.
    template <class T>
    FPM_KERNEL static T stiffness(const MaterialConstants<ScalarOf<T>>& m,
                                  const T& gradientSquare,
                                  const T& inverseVolume)
    {
        return T(m.hourglass * m.pressureWaveModulus * ScalarOf<T>(0.125)) * gradientSquare
               * inverseVolume;
    }
};

/// Viscous form, C = Q_h rho c_d l^2 / 4 with l^2 = sqrt(2/3 B B) (the edge squared of a cube).
/// No history; cannot stop slow drift. Stable up to Q_h = 0.2 at the element's own step.
struct ViscousHourglass {
    static constexpr const char* word = "viscous";
    static constexpr int stateSize = 0;
    static constexpr double presetCoefficient = 0.1, largestCoefficient = 0.2;

    template <class T>
    FPM_KERNEL static HourglassTrial<T>
    trial(const MaterialConstants<ScalarOf<T>>& m, const HourglassInput<T>& in, Vec3<T> (&q)[4])
    {
        using Real = ScalarOf<T>;
        // rho c_d l^2; density and wave speed of the element's own mass, which may be scaled.
        const T impedance = squareRoot(T(Real(2) / Real(3) * m.pressureWaveModulus) * in.density
                                       * in.gradientSquare);
        const T c = T(Real(0.25) * m.hourglass) * impedance * in.rate;
        const T zero = T(Real(0));
        HourglassTrial<T> out{zero, zero, zero, zero, zero, zero};
        for (int j = 0; j < 4; ++j) {
            const Vec3<T> dq = in.increment(j);
            q[j] = c * dq;
            out.workTrial += dot(dq, q[j]);
        }
        return out;
    }
};

} // namespace fpm
