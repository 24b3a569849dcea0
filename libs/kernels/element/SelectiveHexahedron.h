#pragma once

#include "kernels/element/Hexahedron.h"

namespace fpm {

inline constexpr int selectivePoints = 8;

/// Modes multiplied by the coordinates of the Gauss points, +-1/sqrt(3): the functions below need
/// signs only.
template <class T>
FPM_KERNEL Modes<T> gaussModes(const Modes<T>& x)
{
    using Real = ScalarOf<T>;
    const T g = T(Real(0.57735026918962576451)), gg = T(Real(1) / Real(3)), zero = T(Real(0));
    return {{{zero, zero, zero},
             x.mode[1],
             x.mode[2],
             x.mode[3],
             g * x.mode[4],
             g * x.mode[5],
             g * x.mode[6],
             gg * x.mode[7]}};
}

/// Signs of xi, eta, zeta of a Gauss point.
template <class T>
struct PointSigns {
    T xi, eta, zeta;
    FPM_KERNEL explicit PointSigns(int point)
        : xi(ScalarOf<T>(point & 1 ? 1 : -1)),
          eta(ScalarOf<T>(point & 2 ? 1 : -1)),
          zeta(ScalarOf<T>(point & 4 ? 1 : -1))
    {
    }
};

/// Eight times the derivatives along xi, eta and zeta at a Gauss point, as rows.
template <class T>
FPM_KERNEL Mat3<T> pointSlopes(const Modes<T>& gauss, const PointSigns<T>& at)
{
    const Vec3<T>* a = gauss.mode;
    const Vec3<T> twist = multiplyAdd(at.zeta, a[7], a[4]);
    return {multiplyAdd(at.eta, twist, multiplyAdd(at.zeta, a[6], a[1])),
            multiplyAdd(at.xi, twist, multiplyAdd(at.zeta, a[5], a[2])),
            multiplyAdd(at.eta, a[5], multiplyAdd(at.xi, multiplyAdd(at.eta, a[7], a[6]), a[3]))};
}

/// Cofactors of a matrix of rows; row . cofactors is the determinant.
template <class T>
FPM_KERNEL Mat3<T> cofactors(const Mat3<T>& m)
{
    return {cross(m.y, m.z), cross(m.z, m.x), cross(m.x, m.y)};
}

/// Largest sum of the absolute values in a row of C C^T.
template <class T>
FPM_KERNEL T largestRow(const Mat3<T>& c)
{
    const auto absolute = [](const T& a) { return maximum(a, -a); };
    const T xy = absolute(dot(c.x, c.y)), yz = absolute(dot(c.y, c.z)),
            zx = absolute(dot(c.z, c.x));
    return maximum(dot(c.x, c.x) + xy + zx,
                   maximum(dot(c.y, c.y) + xy + yz, dot(c.z, c.z) + yz + zx));
}

/// Corner forces of the deviators, summed as modes in the places of gaussModes, 512 times too
/// large.
template <class T>
FPM_KERNEL void addPointForce(Modes<T>& force,
                              const Sym3<T>& deviator,
                              const Mat3<T>& cofactor,
                              const PointSigns<T>& at)
{
    const Mat3<T> s = matrix(deviator);
    const Vec3<T> t1 = s * cofactor.x, t2 = s * cofactor.y, t3 = s * cofactor.z;
    Vec3<T>* f = force.mode;
    f[1] += t1;
    f[2] += t2;
    f[3] += t3;
    const Vec3<T> twist = multiplyAdd(at.eta, t1, at.xi * t2);
    f[4] += twist;
    f[5] += multiplyAdd(at.zeta, t2, at.eta * t3);
    f[6] += multiplyAdd(at.zeta, t1, at.xi * t3);
    f[7] += multiplyAdd(at.zeta, twist, (at.xi * at.eta) * t3);
}

/// Sums over the Gauss points of an element in one step.
template <class T>
struct PointSums {
    Modes<T> force;
    T internal, plastic; ///< 512 times too large
    T pressure;          ///< mean stress times 512 det J at the end
    T stretch;           ///< largest row of C C^T / det J: see stableStep
    T leastVolume;       ///< smallest 512 det J
};

/// One Gauss point: strain with the element's mean dilatation, spin, stress, force.
template <class Material, class T, class Points>
FPM_KERNEL void updatePoint(const MaterialConstants<ScalarOf<T>>& m,
                            const Modes<T>& middle,
                            const Modes<T>& increment,
                            const Modes<T>& end,
                            const T& dilatation,
                            const T& specificVolume,
                            ScalarOf<T> rate,
                            int number,
                            const Points& points,
                            PointSums<T>& sums)
{
    using Real = ScalarOf<T>;
    const T zero = T(Real(0)), half = T(Real(0.5)), third = T(Real(1) / Real(3)),
            quarter = T(Real(0.25));
    const PointSigns<T> at(number);
    const Mat3<T> slopes = pointSlopes(middle, at), moved = pointSlopes(increment, at),
                  c = cofactors(slopes);
    const T volume = dot(slopes.x, c.x), inverse = T(Real(1)) / volume;
    Mat3<T> l{{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}};
    addOuter(l, moved.x, c.x);
    addOuter(l, moved.y, c.y);
    addOuter(l, moved.z, c.z);
    l = {inverse * l.x, inverse * l.y, inverse * l.z};
    const T rest = third * (dilatation - (l.x.x + l.y.y + l.z.z));
    const SpinRotation<T> spin = spinRotation(
        Vec3<T>{quarter * (l.z.y - l.y.z), quarter * (l.x.z - l.z.x), quarter * (l.y.x - l.x.y)});
    const Sym3<T> strain =
        rotated(spin.half, Sym3<T>{l.x.x + rest, l.y.y + rest, l.z.z + rest, half * (l.x.y + l.y.x),
                                   half * (l.y.z + l.z.y), half * (l.z.x + l.x.z)});

    ElementState<T> state;
    points.read(number, state);
    const Sym3<T> before = rotated(spin.whole, state.stress);
    state.stress = elasticStress<T>(m, before, strain);
    PlasticStep<T> plastic{zero, zero, zero};
    if constexpr (Material::plastic) {
        if (m.general.kinematicModulus > Real(0))
            state.backstress = rotated(spin.whole, state.backstress);
        plastic = Material::template update<T>(
            m, {state.equivalentPlasticStrain, zero, state.temperatureRise, rate}, state.stress,
            state.backstress);
    }
    ElementStep<T> step{};
    step.plasticStrainIncrement = plastic.strainIncrement;
    step.temperatureIncrement = T(m.general.heatPerWork) * plastic.work * specificVolume;
    points.store(number, state, step);

    sums.internal += volume * (half * contract(before + state.stress, strain));
    sums.plastic += volume * plastic.work;
    sums.stretch = maximum(sums.stretch, inverse * largestRow(c));
    sums.leastVolume = select(volume < sums.leastVolume, volume, sums.leastVolume);

    const Mat3<T> shape = pointSlopes(end, at), normal = cofactors(shape);
    const Sym3<T>& s = state.stress;
    const T mean = third * (s.xx + s.yy + s.zz);
    sums.pressure += dot(shape.x, normal.x) * mean;
    addPointForce(sums.force, {s.xx - mean, s.yy - mean, s.zz - mean, s.xy, s.yz, s.zx}, normal,
                  at);
}

/// Half the inverse of the largest frequency, squared and inverted: the undamped step squared.
/// With the mean dilatation u K u = sum_p V_p (lambda tr^2 + 2 mu e_p : e_p) at most, lambda >= 0
/// (e_p with its own trace: the mean square of the traces is not below the square of their mean).
/// The first term is at most lambda B B / V, as of one point. In the second e : e <= |grad u|^2,
/// and sum_p V_p |grad u|^2 <= a |u|^2 for each component with a the largest row of V_p (J^T J)^-1
/// at any point, since on the reference cube no mode has more than the uniform ones. For a cube the
/// bound is exact; for bricks it is never below that of Flanagan and Belytschko.
template <class T>
FPM_KERNEL T squaredStep(const MaterialConstants<ScalarOf<T>>& m,
                         const T& mass,
                         const T& volume,
                         const T& gradientSquare,
                         const T& stretch)
{
    using Real = ScalarOf<T>;
    const T stiffness = T(m.lambda > 0 ? m.lambda : Real(0)) * gradientSquare / volume
                        + T(m.twoMu * Real(0.125)) * stretch;
    return T(Real(0.5)) * mass / stiffness;
}

/// One time step of the selective hexahedron. Arguments as of updateHexahedron; `points` reads and
/// stores the state of each Gauss point: read(point, state), store(point, state, step: increments
/// of the accumulated values).
template <class Material, class T, class Points>
FPM_KERNEL ElementStep<T> updateSelective(const MaterialConstants<ScalarOf<T>>& m,
                                          const Modes<T>& x,
                                          Modes<T>& increment,
                                          const T& mass,
                                          ScalarOf<T> rate,
                                          const Points& points)
{
    using Real = ScalarOf<T>;
    const T one = T(Real(1)), half = T(Real(0.5)), zero = T(Real(0));
    Modes<T> middle;
    for (int k = 1; k < 8; ++k) middle.mode[k] = multiplyAdd(-half, increment.mode[k], x.mode[k]);
    const Gradient<T> gradient = meanGradient(middle);
    T dilatation = zero;
    for (int k = 1; k < 7; ++k) dilatation += dot(gradient.g[k], increment.mode[k]);
    dilatation = dilatation / gradient.volume64;

    PointSums<T> sums;
    for (int k = 0; k < 8; ++k) sums.force.mode[k] = {zero, zero, zero};
    sums.internal = sums.plastic = sums.pressure = sums.stretch = zero;
    sums.leastVolume = gradient.volume64 * T(Real(8));
    const Modes<T> middleGauss = gaussModes(middle), incrementGauss = gaussModes(increment),
                   endGauss = gaussModes(x);
    const T volume = gradient.volume64 * T(Real(1) / Real(64));
    for (int point = 0; point < selectivePoints; ++point)
        updatePoint<Material>(m, middleGauss, incrementGauss, endGauss, dilatation, volume / mass,
                              rate, point, points, sums);

    const T square = gradientSquare512(gradient) * T(Real(1) / Real(512));
    const T length = volume / squareRoot(square + square);
    const BulkViscosity<T> viscosity =
        bulkViscosity<T>(m, mass / volume, length, dilatation, T(rate));
    const T share = T(Real(1) / Real(512));
    ElementStep<T> step{};
    step.internal = share * sums.internal;
    step.plastic = share * sums.plastic;
    step.bulkViscosity = volume * viscosity.pressure * dilatation;
    const T undamped = squareRoot(squaredStep<T>(m, mass, volume, square, sums.stretch));
    const T damping = viscosity.damping * (undamped * viscosity.waveSpeed / length);
    step.stableTimeStep =
        undamped * (squareRoot(fusedMultiplyAdd(damping, damping, one)) - damping);
    step.stableTimeStep = select(sums.leastVolume > zero, step.stableTimeStep, -one);

    const Gradient<T> forceGradient = meanGradient(x);
    const T pressure =
        T(Real(1) / Real(64))
        * (viscosity.pressure + sums.pressure / (T(Real(8)) * forceGradient.volume64));
    const Modes<T> force = gaussModes(sums.force);
    for (int k = 1; k < 7; ++k)
        increment.mode[k] = multiplyAdd(pressure, forceGradient.g[k], share * force.mode[k]);
    increment.mode[7] = share * force.mode[7];
    increment.mode[0] = {zero, zero, zero};
    return step;
}

/// The reference element beside FPM-H8R: 2 x 2 x 2 Gauss points with the mean dilatation of the
/// element at each of them (B-bar: Nagtegaal, Parks and Rice 1974; Hughes 1980), so that neither
/// incompressible elasticity nor plastic flow locks. No mode is without strain, hence there is no
/// hourglass control. Every point rotates with its own mid-step spin (Hughes and Winget 1980), the
/// Jaumann rate, which has no preferred surface. Bending with one element through the thickness is
/// too stiff, as for every element of this kind.
struct SelectiveHexahedron {
    using Shape = HexahedronShape;
    static constexpr const char *word = "selective", *name = "eight points";
    static constexpr const char* hourglass = nullptr;
    static constexpr int points = selectivePoints, stateSize = 0;
    static constexpr bool everyLaw = true;

    template <class Material, class T, class Points>
    FPM_KERNEL static ElementStep<T> update(const MaterialConstants<ScalarOf<T>>& m,
                                            const Modes<T>& x,
                                            Modes<T>& increment,
                                            const T& mass,
                                            ScalarOf<T> rate,
                                            ScalarOf<T>,
                                            const Points& pointStates)
    {
        return updateSelective<Material>(m, x, increment, mass, rate, pointStates);
    }
};

} // namespace fpm
