#pragma once

#include "base/ElementShape.h"
#include "kernels/element/BulkViscosity.h"
#include "kernels/element/Deletion.h"
#include "kernels/element/PhysicalHourglass.h"
#include "kernels/element/RotationRules.h"
#include "kernels/material/Elastic.h"
#include "kernels/material/SectionFlow.h"

#include <type_traits>

namespace fpm {

/// One time step of FPM-H8R (the paper, section 2.2; one point, exact mean gradient): fictitious
/// reverse motion, strain increment of eq. (6), stress update of eqs. (7) and (8), corner forces of
/// eqs. (9) to (11). `x`: modes of the corner coordinates at the end of the step, `increment`:
/// modes of the displacement over the step; on return `increment` holds the modes of the internal
/// force on the corners. `strainPoint`: where the strain is measured, 0.5 mid-step, 1 start of the
/// step (the paper).
template <class Material, class Hourglass, class T>
FPM_KERNEL ElementStep<T> updateHexahedron(const MaterialConstants<ScalarOf<T>>& m,
                                           const Modes<T>& x,
                                           Modes<T>& increment,
                                           const T& mass,
                                           ScalarOf<T> rate,
                                           ScalarOf<T> strainPoint,
                                           ElementState<T>& state)
{
    using Real = ScalarOf<T>;
    const T one = T(Real(1)), half = T(Real(0.5)), zero = T(Real(0));

    // Fictitious reverse motion: removes translation and rotation from the increment.
    Modes<T>& w = increment;
    Modes<T> middle;
    const Mat3<T> rotation =
        removeRotation(Material::general ? m.general.rotation : RotationRule::midSurface,
                       strainPoint, x, w, middle);

    const Gradient<T> strainGradient = meanGradient(middle);
    const T inverseVolume64 = one / strainGradient.volume64;
    Mat3<T> l{{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}};
    for (int k = 1; k < 7; ++k) addOuter(l, w.mode[k], strainGradient.g[k]);
    l = {inverseVolume64 * l.x, inverseVolume64 * l.y, inverseVolume64 * l.z};
    const Sym3<T> strain{l.x.x,
                         l.y.y,
                         l.z.z,
                         half * (l.x.y + l.y.x),
                         half * (l.y.z + l.z.y),
                         half * (l.z.x + l.x.z)};

    const T volume = strainGradient.volume64 * T(Real(1) / Real(64));
    const T density = T(Real(64)) * mass * inverseVolume64;
    const T square = gradientSquare512(strainGradient) * T(Real(1) / Real(512));
    [[maybe_unused]] ElementState<T> start; // state to restore where the general options require it
    if constexpr (Material::general) start = state;
    auto hourglass = Hourglass::template trial<T>(
        m,
        HourglassInput<T>{middle, x, w, l, rotation, volume, T(Real(64)) * inverseVolume64, square,
                          T(rate), density},
        state.hourglass);

    const Sym3<T> before = rotated(rotation, state.stress);
    state.stress = elasticStress<T>(m, before, strain);
    PlasticStep<T> plastic{zero, zero, zero};
    T bent = zero; // plastic work of bending per volume
    if constexpr (Material::plastic) {
        Real kinematic = 0;
        FlowPoint<T> point{state.equivalentPlasticStrain, hourglass.bending, zero, rate};
        if constexpr (Material::general) {
            kinematic = m.general.kinematicModulus;
            if (kinematic > Real(0)) state.backstress = rotated(rotation, state.backstress);
            point.temperatureRise = state.temperatureRise;
        }
        plastic = Material::template update<T>(m, point, state.stress, state.backstress);
        if constexpr (std::is_same_v<Hourglass, PhysicalHourglass>)
            if (m.coupledHourglass > Real(0)) {
                T radial = one - plastic.reduction;
                SectionFlow<T> section;
                if constexpr (Material::section == SectionRule::limitSurface)
                    section = flowOfSection<T>(m, hourglass.bending, hourglass.bendingEnergy,
                                               kinematic, plastic, state.stress, state.backstress);
                else {
                    section = radialSection<T>(hourglass.bendingEnergy, plastic);
                    radial = section.bendingKept;
                }
                bent = section.bendingWork;
                Hourglass::yield(section.bendingKept, radial, state.hourglass, hourglass);
            }
    }

    ElementStep<T> step;
    step.plasticStrainIncrement = plastic.strainIncrement;
    step.plastic = volume * (plastic.work + bent);
    step.temperatureIncrement = zero;
    if constexpr (Material::general)
        if (m.general.heatPerWork > Real(0))
            step.temperatureIncrement = T(m.general.heatPerWork) * step.plastic / mass;
    step.internal = fusedMultiplyAdd(volume, half * contract(before + state.stress, strain),
                                     hourglass.bendingStart + hourglass.bendingTrial);

    // Largest frequency: omega^2 <= 8 (lambda + 2 mu) B B / (rho V^2) (Flanagan and Belytschko
    // 1984).
    const T length = volume / squareRoot(square + square);
    const T volumetric = strain.xx + strain.yy + strain.zz;
    const BulkViscosity<T> viscosity = bulkViscosity<T>(m, density, length, volumetric, T(rate));
    step.bulkViscosity = volume * viscosity.pressure * volumetric;
    const T damping = viscosity.damping, undamped = length * viscosity.slowness;
    step.stableTimeStep =
        undamped * (squareRoot(fusedMultiplyAdd(damping, damping, one)) - damping);
    step.stableTimeStep = select(volume > zero, step.stableTimeStep, -one);

    step.hourglass = hourglass.workStart + hourglass.workTrial;

    // Corner forces at the end of the step: eq. (10), sigma : B by one point, which satisfies eq.
    // (9), plus the orthogonal hourglass part, eq. (11).
    const Gradient<T> forceGradient = meanGradient(x);
    const T sixtyFourth = T(Real(1) / Real(64));
    Mat3<T> s = matrix(sixtyFourth * state.stress);
    const T pressure = sixtyFourth * viscosity.pressure;
    s.x.x += pressure;
    s.y.y += pressure;
    s.z.z += pressure;
    Vec3<T> q[4];
    if constexpr (std::is_same_v<Hourglass, PhysicalHourglass>) {
        const Sym3<T> section = Hourglass::forces(hourglass, state.hourglass, x, q);
        step.internal += volume * contract(section, strain);
        s = s + matrix(sixtyFourth * section);
        const T endVolume = sixtyFourth * forceGradient.volume64;
        for (int j = 0; j < 4; ++j) {
            addOuter(s, (-sixtyFourth) * q[j], x.mode[hourglassMode(j)]);
            q[j] = endVolume * q[j];
        }
    } else {
        const T inverse = one / forceGradient.volume64;
        for (int j = 0; j < 4; ++j) {
            q[j] = state.hourglass[j];
            addOuter(s, (-inverse) * q[j], x.mode[hourglassMode(j)]);
        }
    }
    for (int k = 1; k < 7; ++k) w.mode[k] = s * forceGradient.g[k];
    w.mode[7] = q[3];
    for (int j = 0; j < 3; ++j) w.mode[hourglassMode(j)] += q[j];
    w.mode[0] = {zero, zero, zero};
    step.deletes = zero;
    if constexpr (Material::general)
        if (m.general.erodes)
            erode<T>(
                m, start, before, volume,
                {fusedMultiplyAdd(volume, half * contract(before, strain), hourglass.bendingStart),
                 hourglass.workStart},
                step, state, w);
    return step;
}

/// FPM-H8R: one integration point and a form of hourglass control.
template <class HourglassForm>
struct ReducedHexahedron {
    using Shape = HexahedronShape;
    using Hourglass = HourglassForm;
    static constexpr const char *word = "reduced", *name = "one point";
    static constexpr const char* hourglass = Hourglass::word;
    static constexpr int points = 1, stateSize = Hourglass::stateSize;
    static constexpr bool everyLaw = std::is_same_v<Hourglass, PhysicalHourglass>;

    template <class Material, class T, class Points>
    FPM_KERNEL static ElementStep<T> update(const MaterialConstants<ScalarOf<T>>& m,
                                            const Modes<T>& x,
                                            Modes<T>& increment,
                                            const T& mass,
                                            ScalarOf<T> rate,
                                            ScalarOf<T> strainPoint,
                                            const Points& pointStates)
    {
        ElementState<T> state;
        pointStates.read(0, state);
        const ElementStep<T> step =
            updateHexahedron<Material, Hourglass>(m, x, increment, mass, rate, strainPoint, state);
        pointStates.store(0, state, step);
        return step;
    }
};

} // namespace fpm
