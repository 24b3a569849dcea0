#pragma once

#include "kernels/element/Gradient.h"
#include "kernels/element/Rotation.h"
#include "kernels/material/MaterialConstants.h"

namespace fpm {

/// What the hourglass forms share: mode 4 + j belongs to Gamma_{order} of Flanagan and Belytschko.
/// Generalised forces Q are kept in the order eta zeta, zeta xi, xi eta, xi eta zeta.
FPM_KERNEL constexpr int hourglassMode(int j)
{
    return j == 0 ? 5 : j == 1 ? 6 : j == 2 ? 4 : 7;
}

template <class T>
struct HourglassInput {
    const Modes<T>& middle;          ///< geometry at mid-step
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

/// Trial forces of a step. The work of the step is workStart + share * workTrial, share = 1 unless
/// the section yields and the forces are scaled down.
template <class T>
struct HourglassTrial {
    T workStart, workTrial;
    T bending;       ///< equivalent bending stress of the section, 0 where the form knows none
    T bendingEnergy; ///< twice the elastic energy of that bending per volume
};

/// Artificial stiffness (Flanagan and Belytschko 1981), k = kappa (lambda + 2 mu) B B / (8 V);
/// kappa = 1 is the highest frequency of a brick; up to 0.2 no warped element's stable step is
/// touched. Q turns with the element.
struct StiffnessHourglass {
    static constexpr int stateSize = 12, points = 1;

    template <class T>
    FPM_KERNEL static HourglassTrial<T>
    trial(const MaterialConstants<ScalarOf<T>>& m, const HourglassInput<T>& in, Vec3<T> (&q)[4])
    {
        const T half = T(ScalarOf<T>(0.5));
        const T k = T(m.hourglass * m.pressureWaveModulus * ScalarOf<T>(0.125)) * in.gradientSquare
                    * in.inverseVolume;
        const T zero = T(ScalarOf<T>(0));
        HourglassTrial<T> out{zero, zero, zero, zero};
        for (int j = 0; j < 4; ++j) {
            const Vec3<T> dq = in.increment(j);
            const Vec3<T> turned = q[j] + in.rotation * q[j];
            q[j] = multiplyAdd(k, dq, turned);
            out.workStart += half * dot(dq, turned);
            out.workTrial += half * dot(dq, q[j]);
        }
        return out;
    }
};

/// Viscous form, C = Q_h rho c_d l^2 / 4 with l^2 = sqrt(2/3 B B) (the edge squared of a cube).
/// No history; cannot stop slow drift. Stable up to Q_h = 0.2 at the element's own step.
struct ViscousHourglass {
    static constexpr int stateSize = 0, points = 1;

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
        HourglassTrial<T> out{zero, zero, zero, zero};
        for (int j = 0; j < 4; ++j) {
            const Vec3<T> dq = in.increment(j);
            q[j] = c * dq;
            out.workTrial += dot(dq, q[j]);
        }
        return out;
    }
};

/// Assumed-strain form: the bending and torsion stiffness of a brick, no free parameter (Belytschko
/// and Bindeman 1993, rederived for parallelepipeds). Works in the frame of the middle surface,
/// e1 along x1, e3 along x1 x x2, and keeps Q there: the frame turns with the element.
struct PhysicalHourglass {
    static constexpr int stateSize = 12, points = 1;

    template <class T>
    FPM_KERNEL static HourglassTrial<T>
    trial(const MaterialConstants<ScalarOf<T>>& m, const HourglassInput<T>& in, Vec3<T> (&q)[4])
    {
        using Real = ScalarOf<T>;
        const T half = T(Real(0.5));
        const Vec3<T>* x = in.middle.mode;
        const Mat3<T> axes = frame(in.middle);

        // Inverse edge lengths; |x_i| is four times the length along direction i.
        const T four = T(Real(4));
        const T r1 = four / squareRoot(dot(x[1], x[1])), r2 = four / squareRoot(dot(x[2], x[2])),
                r3 = four / squareRoot(dot(x[3], x[3]));
        const T scale = T(m.hourglass) * in.volume * T(Real(1) / Real(48));
        const T bend = scale * T(m.young / (Real(1) - m.poisson * m.poisson));
        const T cross12 = T(m.poisson) * r1 * r2, cross23 = T(m.poisson) * r2 * r3,
                cross31 = T(m.poisson) * r3 * r1;
        const T twist = scale * T(Real(0.5) * m.twoMu);
        const T last = scale * T(m.young * Real(1) / Real(3));

        const Vec3<T> d1 = axes * in.increment(0), d2 = axes * in.increment(1),
                      d3 = axes * in.increment(2), d4 = axes * in.increment(3);
        const Vec3<T> change[4] = {
            {twist * ((r2 * r2 + r3 * r3) * d1.x + r1 * r2 * d2.y + r1 * r3 * d3.z),
             bend * (r2 * r2 * d1.y + cross12 * d2.x), bend * (r3 * r3 * d1.z + cross31 * d3.x)},
            {bend * (r1 * r1 * d2.x + cross12 * d1.y),
             twist * ((r3 * r3 + r1 * r1) * d2.y + r2 * r3 * d3.z + r1 * r2 * d1.x),
             bend * (r3 * r3 * d2.z + cross23 * d3.y)},
            {bend * (r1 * r1 * d3.x + cross31 * d1.z), bend * (r2 * r2 * d3.y + cross23 * d2.z),
             twist * ((r1 * r1 + r2 * r2) * d3.z + r1 * r3 * d1.x + r2 * r3 * d2.y)},
            {last * r1 * r1 * d4.x, last * r2 * r2 * d4.y, last * r3 * r3 * d4.z}};
        const Vec3<T> increments[4] = {d1, d2, d3, d4};
        const T zero = T(Real(0));
        HourglassTrial<T> out{zero, zero, zero, zero};
        for (int j = 0; j < 4; ++j) {
            out.workStart += half * dot(increments[j], q[j]);
            q[j] += change[j];
            out.workTrial += half * dot(increments[j], q[j]);
        }
        measureBending(m, q, in.inverseVolume, r1, r2, r3, out);
        return out;
    }

    /// `plastic tangent`: while the element flows, the stiffness of its increments is that share of
    /// the elastic one which the tangent modulus is of Young's, at least a hundredth. `modulus`:
    /// d(flow stress) / d(plastic strain).
    template <class T>
    FPM_KERNEL static void followFlow(const MaterialConstants<ScalarOf<T>>& m,
                                      const T& plasticStrainIncrement,
                                      const T& modulus,
                                      const Vec3<T> (&before)[4],
                                      Vec3<T> (&q)[4],
                                      HourglassTrial<T>& work)
    {
        using Real = ScalarOf<T>;
        const T tangent = maximum(modulus / (T(m.young) + modulus), T(Real(0.01)));
        const T share = select(plasticStrainIncrement > T(Real(0)), tangent, T(Real(1)));
        for (int j = 0; j < 4; ++j) q[j] = multiplyAdd(share, q[j] - before[j], before[j]);
        work.workTrial = fusedMultiplyAdd(share, work.workTrial - work.workStart, work.workStart);
    }

    /// Equivalent bending stress of the section, q_b = 2/3 of the Mises stress of the outer fibre:
    /// pure bending yields at the plastic moment sigma_y t^2 / 4 of a solid section. Outer fibre
    /// stresses follow from Q: sigma_i = 12 Q_ij s_i / V, and 12 Q_ii / V = tau_ij / s_j + tau_ik /
    /// s_k for the twists. `r`: inverse edge lengths.
    template <class T>
    FPM_KERNEL static void measureBending(const MaterialConstants<ScalarOf<T>>& m,
                                          const Vec3<T> (&q)[4],
                                          const T& inverseVolume,
                                          const T& r1,
                                          const T& r2,
                                          const T& r3,
                                          HourglassTrial<T>& out)
    {
        using Real = ScalarOf<T>;
        const T one = T(Real(1)), half = T(Real(0.5));
        const T s1 = one / r1, s2 = one / r2, s3 = one / r3;
        const T a1 = q[1].x * s1, b1 = q[0].y * s2, a2 = q[2].y * s2, b2 = q[1].z * s3,
                a3 = q[0].z * s3, b3 = q[2].x * s1;
        const T squares = a1 * a1 + b1 * b1 + a2 * a2 + b2 * b2 + a3 * a3 + b3 * b3;
        const T products = a1 * b1 + a2 * b2 + a3 * b3;
        const T x1 = q[0].x * s2 * s3, x2 = q[1].y * s1 * s3, x3 = q[2].z * s1 * s2;
        const T t12 = half * (x1 + x2 - x3) * r3, t13 = half * (x1 + x3 - x2) * r2,
                t23 = half * (x2 + x3 - x1) * r1;
        const T shear = t12 * t12 + t13 * t13 + t23 * t23;
        const T inverse = T(m.coupledHourglass) * inverseVolume;
        out.bending = T(Real(8)) * inverse * squareRoot(squares - products + T(Real(3)) * shear);
        out.bendingEnergy = T(Real(48)) * inverse * inverse
                            * (T(Real(1) / m.young) * (squares - T(Real(2) * m.poisson) * products)
                               + T(Real(2) / m.twoMu) * shear);
    }

    /// Rows: the axes of the middle surface.
    template <class T>
    FPM_KERNEL static Mat3<T> frame(const Modes<T>& x)
    {
        const T one = T(ScalarOf<T>(1));
        const Vec3<T> normal = cross(x.mode[1], x.mode[2]);
        const Vec3<T> e1 = (one / squareRoot(dot(x.mode[1], x.mode[1]))) * x.mode[1];
        const Vec3<T> e3 = (one / squareRoot(dot(normal, normal))) * normal;
        return {e1, cross(e3, e1), e3};
    }
};

} // namespace fpm
