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
    static constexpr const char* word = "physical";
    static constexpr int stateSize = 12;
    static constexpr double presetCoefficient = 1, largestCoefficient = 1;

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
    /// 4 twice the energy, and what an edge bears less of stress than forces and strains say.
    template <class T>
    struct Trial : HourglassTrial<T> {
        Vec3<T> force[4];
        Vec3<T> sectionRelief, lastRelief;
        T lastEnergy;
    };

    template <class T>
    FPM_KERNEL static Trial<T>
    trial(const MaterialConstants<ScalarOf<T>>& m, const HourglassInput<T>& in, Vec3<T> (&c)[4])
    {
        using Real = ScalarOf<T>;
        const Stiffness<T> k = stiffnessOf<T>(m);
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
        const Vec3<T> shear = derive(k, edges, e, f, out);
        measure(m, k, edges, e, f, shear, out);

        // Work: half of the increment times the forces at the start, and times those at the end.
        const T half = T(Real(0.5)) * in.volume;
        out.bendingTrial =
            half * (dot(change[0], f[0]) + dot(change[1], f[1]) + dot(change[2], f[2]));
        out.bendingStart = out.bendingTrial - half * squares(k, edges, change);
        out.workTrial = half * dot(change[3], f[3]);
        out.workStart = out.workTrial - half * k.last * dot(change[3], change[3]);
        return out;
    }

    /// Forces, energies and equivalent bending stress of the strains c where the corners are `at`;
    /// no works.
    template <class T>
    FPM_KERNEL static Trial<T>
    present(const MaterialConstants<ScalarOf<T>>& m, const Modes<T>& at, const Vec3<T> (&c)[4])
    {
        const T zero = T(ScalarOf<T>(0));
        const Stiffness<T> k = stiffnessOf<T>(m);
        const Edges<T> edges = edgesOf(at.mode);
        Vec3<T> e[4], f[4];
        for (int j = 0; j < 4; ++j) e[j] = edges.projection * c[j];
        Trial<T> out;
        const Vec3<T> shear = derive(k, edges, e, f, out);
        measure(m, k, edges, e, f, shear, out);
        out.workStart = out.workTrial = out.bendingStart = out.bendingTrial = zero;
        return out;
    }

    /// The section keeps the fraction `section` of modes 1 to 3, and `radial` of mode 4: that mode
    /// is no bending of the section, so it decays like the deviator under the flow of the whole
    /// element. It always meets a resistance, and carries no load at rest.
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
        trial.bendingEnergy = sectionSquare * trial.bendingEnergy;
        trial.sectionRelief = sectionSquare * trial.sectionRelief;
        trial.lastEnergy = radialSquare * trial.lastEnergy;
        trial.lastRelief = radialSquare * trial.lastRelief;
    }

    /// Q_j per volume where the corners are `at`; returns the stress, sum_ik a_ik x_i x_k^T and the
    /// energy as a tension: what the energy gains as the edges stretch and shear.
    template <class T>
    FPM_KERNEL static Sym3<T>
    forces(const Trial<T>& trial, const Vec3<T> (&c)[4], const Modes<T>& at, Vec3<T> (&q)[4])
    {
        const T zero = T(ScalarOf<T>(0)), half = T(ScalarOf<T>(0.5)), two = T(ScalarOf<T>(2));
        const Vec3<T>* x = at.mode;
        const auto combined = [&](const T& a, const T& b, const T& d) {
            return multiplyAdd(a, x[1], multiplyAdd(b, x[2], d * x[3]));
        };
        Sym3<T> a{zero, zero, zero, zero, zero, zero};
        for (int j = 0; j < 4; ++j) {
            const Vec3<T>& f = trial.force[j];
            q[j] = combined(f.x, f.y, f.z);
            a.xx = fusedMultiplyAdd(f.x, c[j].x, a.xx);
            a.yy = fusedMultiplyAdd(f.y, c[j].y, a.yy);
            a.zz = fusedMultiplyAdd(f.z, c[j].z, a.zz);
            a.xy = fusedMultiplyAdd(f.x, c[j].y, fusedMultiplyAdd(f.y, c[j].x, a.xy));
            a.yz = fusedMultiplyAdd(f.y, c[j].z, fusedMultiplyAdd(f.z, c[j].y, a.yz));
            a.zx = fusedMultiplyAdd(f.z, c[j].x, fusedMultiplyAdd(f.x, c[j].z, a.zx));
        }
        a.xx = fusedMultiplyAdd(two, a.xx, -(trial.sectionRelief.x + trial.lastRelief.x));
        a.yy = fusedMultiplyAdd(two, a.yy, -(trial.sectionRelief.y + trial.lastRelief.y));
        a.zz = fusedMultiplyAdd(two, a.zz, -(trial.sectionRelief.z + trial.lastRelief.z));
        const Vec3<T> y[3] = {combined(a.xx, a.xy, a.zx), combined(a.xy, a.yy, a.yz),
                              combined(a.zx, a.yz, a.zz)};
        const T energy = half * (trial.bendingEnergy + trial.lastEnergy);
        Sym3<T> stress{energy, energy, energy, zero, zero, zero};
        for (int i = 0; i < 3; ++i) {
            const Vec3<T>& edge = x[i + 1];
            stress.xx = fusedMultiplyAdd(edge.x, y[i].x, stress.xx);
            stress.yy = fusedMultiplyAdd(edge.y, y[i].y, stress.yy);
            stress.zz = fusedMultiplyAdd(edge.z, y[i].z, stress.zz);
            stress.xy = fusedMultiplyAdd(edge.x, y[i].y, stress.xy);
            stress.yz = fusedMultiplyAdd(edge.y, y[i].z, stress.yz);
            stress.zx = fusedMultiplyAdd(edge.z, y[i].x, stress.zx);
        }
        return stress;
    }

private:
    template <class T>
    FPM_KERNEL static Stiffness<T> stiffnessOf(const MaterialConstants<ScalarOf<T>>& m)
    {
        using Real = ScalarOf<T>;
        const Real third = m.hourglass * Real(1) / Real(3);
        return {T(third * m.young / (Real(1) - m.poisson * m.poisson)), T(m.poisson),
                T(third * Real(0.5) * m.twoMu), T(third * m.young * Real(1) / Real(3))};
    }

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

    /// f = dW/de, and the forces along the edges; returns dW/dG of 12, 23, 31.
    template <class T>
    FPM_KERNEL static Vec3<T> derive(const Stiffness<T>& k,
                                     const Edges<T>& edges,
                                     const Vec3<T> (&e)[4],
                                     Vec3<T> (&f)[4],
                                     Trial<T>& out)
    {
        const Vec3<T>&h = edges.square, &r = edges.inverse;
        const auto bend = [&](const T& a, const T& b) {
            return k.bend * fusedMultiplyAdd(k.poisson, b, a);
        };
        const Vec3<T> shear{k.twist * fusedMultiplyAdd(r.y, e[0].x, r.x * e[1].y),
                            k.twist * fusedMultiplyAdd(r.z, e[1].y, r.y * e[2].z),
                            k.twist * fusedMultiplyAdd(r.x, e[2].z, r.z * e[0].x)};
        const Vec3<T> twist{shear.x + shear.z, shear.x + shear.y, shear.y + shear.z};
        f[0] = {h.x * twist.x, bend(e[0].y, e[1].x), bend(e[0].z, e[2].x)};
        f[1] = {bend(e[1].x, e[0].y), h.y * twist.y, bend(e[1].z, e[2].y)};
        f[2] = {bend(e[2].x, e[0].z), bend(e[2].y, e[1].z), h.z * twist.z};
        f[3] = k.last * e[3];
        out.force[0] = {twist.x, r.y * f[0].y, r.z * f[0].z};
        out.force[1] = {r.x * f[1].x, twist.y, r.z * f[1].z};
        out.force[2] = {r.x * f[2].x, r.y * f[2].y, twist.z};
        out.force[3] = {r.x * f[3].x, r.y * f[3].y, r.z * f[3].z};
        return shear;
    }

    /// Energies, what they take from the stress, and the equivalent bending stress q_b of the
    /// section, 2/3 of the Mises stress of the outer fibre: pure bending yields at the plastic
    /// moment sigma_y t^2 / 4 of a solid section. An outer fibre bears 3 f.
    template <class T>
    FPM_KERNEL static void measure(const MaterialConstants<ScalarOf<T>>& m,
                                   const Stiffness<T>& k,
                                   const Edges<T>& edges,
                                   const Vec3<T> (&e)[4],
                                   const Vec3<T> (&f)[4],
                                   const Vec3<T>& shear,
                                   Trial<T>& out)
    {
        using Real = ScalarOf<T>;
        const T two = T(Real(2));
        const Vec3<T>&h = edges.square, &r = edges.inverse;
        const Vec3<T>(&p)[4] = out.force;

        const T g1 = h.x * e[0].x, g2 = h.y * e[1].y, g3 = h.z * e[2].z;
        const T w12 = shear.x * (g1 + g2), w23 = shear.y * (g2 + g3), w31 = shear.z * (g3 + g1);
        const T squares = f[0].y * f[0].y + f[0].z * f[0].z + f[1].x * f[1].x + f[1].z * f[1].z
                          + f[2].x * f[2].x + f[2].y * f[2].y;
        const T products = f[0].y * f[1].x + f[1].z * f[2].y + f[2].x * f[0].z;
        const T twists = w12 + w23 + w31;
        out.bending = T(Real(2) * m.coupledHourglass)
                      * squareRoot(squares - products + T(Real(3)) * k.twist * twists);
        out.bendingEnergy = dot(e[0], f[0]) + dot(e[1], f[1]) + dot(e[2], f[2]);
        out.lastEnergy = dot(e[3], f[3]);
        out.sectionRelief = {
            fusedMultiplyAdd(two, fusedMultiplyAdd(p[1].x, e[1].x, p[2].x * e[2].x),
                             r.x * (w12 + w31)),
            fusedMultiplyAdd(two, fusedMultiplyAdd(p[0].y, e[0].y, p[2].y * e[2].y),
                             r.y * (w12 + w23)),
            fusedMultiplyAdd(two, fusedMultiplyAdd(p[0].z, e[0].z, p[1].z * e[1].z),
                             r.z * (w23 + w31))};
        out.lastRelief = {two * (p[3].x * e[3].x), two * (p[3].y * e[3].y),
                          two * (p[3].z * e[3].z)};
    }
};

} // namespace fpm
