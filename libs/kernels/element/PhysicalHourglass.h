#pragma once

#include "kernels/element/Hourglass.h"

namespace fpm {

/// Assumed-strain form: the bending and torsion stiffness of a brick, no free parameter (after
/// Belytschko and Bindeman 1993).
///
/// State: c_ij, components along the edges x_i (modes 1 to 3 of the corners) of the elastic part
/// X_j = sum_i c_ij x_i of the motion in hourglass mode j. They are strains of the outer fibres,
/// and no motion without hourglassing changes them. The energy is a function of state, so that no
/// closed elastic path makes or loses any. Per volume, with h_i = |x_i|^2 and e_ij = x_i . X_j /
/// h_i:
///
///     W = kb/2 sum over the pairs (e, e') that bend about one axis of (e^2 + e'^2 + 2 nu e e')
///       + kt/2 sum_(i<j) G_ij^2 / (h_i h_j) + k4/2 sum_i e_i4^2,     G_ij = h_i e_ii + h_j e_jj,
///     kb = 1/3 E / (1 - nu^2),     kt = 1/3 mu,     k4 = 1/9 E.
///
/// Its derivatives by X_j and by the edges are the forces Q_j and a stress. Projections on the
/// edges give a brick that leans the bending stiffness of beam theory.
struct PhysicalHourglass {
    static constexpr int stateSize = 12, points = 1;

    /// kb, nu, kt, k4, times the coefficient of the form.
    template <class T>
    struct Stiffness {
        T bend, poisson, twist, last;
    };

    /// The edges at the end of the step.
    template <class T>
    struct Edges {
        Vec3<T> square, inverse; ///< h_i and 1 / h_i
        Mat3<T> projection;      ///< e_j = projection c_j
    };

    /// Per volume: forces along the edges, Q_j = sum_i force[j]_i x_i; of modes 1 to 3 and of mode
    /// 4 the energy, and the stress, sum_ik stress_ik x_i x_k^T and the energy as a pressure.
    template <class T>
    struct Trial : HourglassTrial<T> {
        Vec3<T> force[4];
        Sym3<T> sectionStress, lastStress;
        T sectionEnergy, lastEnergy;
    };

    template <class T>
    FPM_KERNEL static Trial<T>
    trial(const MaterialConstants<ScalarOf<T>>& m, const HourglassInput<T>& in, Vec3<T> (&c)[4])
    {
        using Real = ScalarOf<T>;
        const Real third = m.hourglass * Real(1) / Real(3);
        const Stiffness<T> k{T(third * m.young / (Real(1) - m.poisson * m.poisson)), T(m.poisson),
                             T(third * Real(0.5) * m.twoMu),
                             T(third * m.young * Real(1) / Real(3))};
        const Edges<T> edges = edgesOf(in.end.mode);
        const Mat3<T> dual = dualBasis(in.middle.mode);

        Vec3<T> change[4], e[4]; // of e over the step, and e at its end
        for (int j = 0; j < 4; ++j) {
            const Vec3<T> dc = dual * in.increment(j);
            change[j] = edges.projection * dc;
            c[j] += dc;
            e[j] = edges.projection * c[j];
        }
        Trial<T> out;
        Vec3<T> f[4]; // dW/de
        derive(k, edges, e, f, out);
        measure(m, k, edges, c, e, f, out);

        // Work: half of the increment times the forces at the start, and times those at the end.
        const T half = T(Real(0.5)) * in.volume;
        out.bendingTrial =
            half * (dot(change[0], f[0]) + dot(change[1], f[1]) + dot(change[2], f[2]));
        out.bendingStart = out.bendingTrial - half * squares(k, edges, change);
        out.workTrial = half * dot(change[3], f[3]);
        out.workStart = out.workTrial - half * k.last * dot(change[3], change[3]);
        return out;
    }

    /// The section keeps the share `section` of modes 1 to 3, and `radial` of mode 4: that is no
    /// bending of the section, so it decays as the deviator does under the flow of the whole. It
    /// always meets a resistance, and bears no load at rest.
    template <class T>
    FPM_KERNEL static void
    yield(const T& section, const T& radial, Vec3<T> (&c)[4], Trial<T>& trial)
    {
        for (int j = 0; j < 4; ++j) {
            const T& kept = j < 3 ? section : radial;
            c[j] = kept * c[j];
            trial.force[j] = kept * trial.force[j];
        }
        trial.bendingTrial = section * trial.bendingTrial;
        trial.workTrial = radial * trial.workTrial;
        const T sectionSquare = section * section, radialSquare = radial * radial;
        trial.sectionStress = sectionSquare * trial.sectionStress;
        trial.sectionEnergy = sectionSquare * trial.sectionEnergy;
        trial.lastStress = radialSquare * trial.lastStress;
        trial.lastEnergy = radialSquare * trial.lastEnergy;
    }

    /// Q_j per volume where the corners are `at`; returns the stress.
    template <class T>
    FPM_KERNEL static Sym3<T> forces(const Trial<T>& trial, const Modes<T>& at, Vec3<T> (&q)[4])
    {
        const Vec3<T>* x = at.mode;
        const auto combined = [&](const T& a, const T& b, const T& c) {
            return multiplyAdd(a, x[1], multiplyAdd(b, x[2], c * x[3]));
        };
        for (int j = 0; j < 4; ++j)
            q[j] = combined(trial.force[j].x, trial.force[j].y, trial.force[j].z);
        const Sym3<T> a = trial.sectionStress + trial.lastStress;
        const Vec3<T> y[4] = {
            {}, combined(a.xx, a.xy, a.zx), combined(a.xy, a.yy, a.yz), combined(a.zx, a.yz, a.zz)};
        const T energy = trial.sectionEnergy + trial.lastEnergy;
        Sym3<T> stress{energy, energy, energy, x[1].x * y[1].y, x[1].y * y[1].z, x[1].z * y[1].x};
        for (int i = 1; i < 4; ++i) {
            stress.xx = fusedMultiplyAdd(x[i].x, y[i].x, stress.xx);
            stress.yy = fusedMultiplyAdd(x[i].y, y[i].y, stress.yy);
            stress.zz = fusedMultiplyAdd(x[i].z, y[i].z, stress.zz);
            if (i == 1) continue;
            stress.xy = fusedMultiplyAdd(x[i].x, y[i].y, stress.xy);
            stress.yz = fusedMultiplyAdd(x[i].y, y[i].z, stress.yz);
            stress.zx = fusedMultiplyAdd(x[i].z, y[i].x, stress.zx);
        }
        return stress;
    }

private:
    template <class T>
    FPM_KERNEL static Edges<T> edgesOf(const Vec3<T>* x)
    {
        const T one = T(ScalarOf<T>(1));
        const Vec3<T> h{dot(x[1], x[1]), dot(x[2], x[2]), dot(x[3], x[3])};
        const Vec3<T> r{one / h.x, one / h.y, one / h.z};
        const T g12 = dot(x[1], x[2]), g23 = dot(x[2], x[3]), g31 = dot(x[3], x[1]);
        return {h,
                r,
                {{one, r.x * g12, r.x * g31},
                 {r.y * g12, one, r.y * g23},
                 {r.z * g31, r.z * g23, one}}};
    }

    /// Rows d_i with d_i . x_k = delta_ik.
    template <class T>
    FPM_KERNEL static Mat3<T> dualBasis(const Vec3<T>* x)
    {
        const Vec3<T> d1 = cross(x[2], x[3]), d2 = cross(x[3], x[1]), d3 = cross(x[1], x[2]);
        const T inverse = T(ScalarOf<T>(1)) / dot(x[1], d1);
        return {inverse * d1, inverse * d2, inverse * d3};
    }

    /// Twice the energy of modes 1 to 3.
    template <class T>
    FPM_KERNEL static T squares(const Stiffness<T>& k, const Edges<T>& edges, const Vec3<T> (&e)[4])
    {
        const Vec3<T>&h = edges.square, &r = edges.inverse;
        const T twice = k.poisson + k.poisson;
        const auto pair = [&](const T& a, const T& b) {
            return fusedMultiplyAdd(a, a, fusedMultiplyAdd(b, b, twice * a * b));
        };
        const T g1 = h.x * e[0].x, g2 = h.y * e[1].y, g3 = h.z * e[2].z;
        const T g12 = g1 + g2, g23 = g2 + g3, g31 = g3 + g1;
        const T twists =
            g12 * g12 * (r.x * r.y) + g23 * g23 * (r.y * r.z) + g31 * g31 * (r.z * r.x);
        const T bends = pair(e[0].y, e[1].x) + pair(e[1].z, e[2].y) + pair(e[2].x, e[0].z);
        return fusedMultiplyAdd(k.bend, bends, k.twist * twists);
    }

    /// f = dW/de, and the forces along the edges.
    template <class T>
    FPM_KERNEL static void derive(const Stiffness<T>& k,
                                  const Edges<T>& edges,
                                  const Vec3<T> (&e)[4],
                                  Vec3<T> (&f)[4],
                                  Trial<T>& out)
    {
        const Vec3<T>&h = edges.square, &r = edges.inverse;
        const auto bend = [&](const T& a, const T& b) {
            return k.bend * fusedMultiplyAdd(k.poisson, b, a);
        };
        const T s12 = k.twist * fusedMultiplyAdd(r.y, e[0].x, r.x * e[1].y),
                s23 = k.twist * fusedMultiplyAdd(r.z, e[1].y, r.y * e[2].z),
                s31 = k.twist * fusedMultiplyAdd(r.x, e[2].z, r.z * e[0].x);
        f[0] = {h.x * (s12 + s31), bend(e[0].y, e[1].x), bend(e[0].z, e[2].x)};
        f[1] = {bend(e[1].x, e[0].y), h.y * (s12 + s23), bend(e[1].z, e[2].y)};
        f[2] = {bend(e[2].x, e[0].z), bend(e[2].y, e[1].z), h.z * (s23 + s31)};
        f[3] = k.last * e[3];
        for (int j = 0; j < 4; ++j) out.force[j] = {r.x * f[j].x, r.y * f[j].y, r.z * f[j].z};
    }

    /// Energies, the stresses that follow from them, and the equivalent bending stress q_b of the
    /// section, 2/3 of the Mises stress of the outer fibre: pure bending yields at the plastic
    /// moment sigma_y t^2 / 4 of a solid section. An outer fibre bears 3 f.
    template <class T>
    FPM_KERNEL static void measure(const MaterialConstants<ScalarOf<T>>& m,
                                   const Stiffness<T>& k,
                                   const Edges<T>& edges,
                                   const Vec3<T> (&c)[4],
                                   const Vec3<T> (&e)[4],
                                   const Vec3<T> (&f)[4],
                                   Trial<T>& out)
    {
        using Real = ScalarOf<T>;
        const T half = T(Real(0.5)), two = T(Real(2));
        const Vec3<T>&h = edges.square, &r = edges.inverse;
        const Vec3<T>(&p)[4] = out.force;

        // Twists: the shear forces s_ij and the energies they hold.
        const T s12 = half * (p[0].x + p[1].y - p[2].z), s23 = half * (p[1].y + p[2].z - p[0].x),
                s31 = half * (p[2].z + p[0].x - p[1].y);
        const T g1 = h.x * e[0].x, g2 = h.y * e[1].y, g3 = h.z * e[2].z;
        const T w12 = s12 * (g1 + g2), w23 = s23 * (g2 + g3), w31 = s31 * (g3 + g1);

        const T squares = f[0].y * f[0].y + f[0].z * f[0].z + f[1].x * f[1].x + f[1].z * f[1].z
                          + f[2].x * f[2].x + f[2].y * f[2].y;
        const T products = f[0].y * f[1].x + f[1].z * f[2].y + f[2].x * f[0].z;
        const T twists = w12 + w23 + w31;
        out.bending = T(Real(2) * m.coupledHourglass)
                      * squareRoot(squares - products + T(Real(3)) * k.twist * twists);
        out.bendingEnergy = dot(e[0], f[0]) + dot(e[1], f[1]) + dot(e[2], f[2]);
        out.sectionEnergy = half * out.bendingEnergy;
        out.lastEnergy = half * dot(e[3], f[3]);

        const auto fibres = [&](const T& a, const T& b) { return -two * (a + b); };
        out.sectionStress =
            product(p[0], c[0]) + product(p[1], c[1]) + product(p[2], c[2])
            + diagonal(fibres(p[1].x * e[1].x, p[2].x * e[2].x) - r.x * (w12 + w31),
                       fibres(p[0].y * e[0].y, p[2].y * e[2].y) - r.y * (w12 + w23),
                       fibres(p[0].z * e[0].z, p[1].z * e[1].z) - r.z * (w23 + w31));
        out.lastStress = product(p[3], c[3])
                         + diagonal(-two * (p[3].x * e[3].x), -two * (p[3].y * e[3].y),
                                    -two * (p[3].z * e[3].z));
    }

    /// a b^T + b a^T
    template <class T>
    FPM_KERNEL static Sym3<T> product(const Vec3<T>& a, const Vec3<T>& b)
    {
        const T two = T(ScalarOf<T>(2));
        return {two * a.x * b.x,
                two * a.y * b.y,
                two * a.z * b.z,
                fusedMultiplyAdd(a.x, b.y, a.y * b.x),
                fusedMultiplyAdd(a.y, b.z, a.z * b.y),
                fusedMultiplyAdd(a.z, b.x, a.x * b.z)};
    }
    template <class T>
    FPM_KERNEL static Sym3<T> diagonal(const T& a, const T& b, const T& c)
    {
        const T zero = T(ScalarOf<T>(0));
        return {a, b, c, zero, zero, zero};
    }
};

} // namespace fpm
