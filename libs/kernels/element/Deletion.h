#pragma once

#include "kernels/element/ElementState.h"
#include "kernels/element/Modes.h"
#include "kernels/material/MaterialConstants.h"

namespace fpm {

/// A deleted element is marked by its stored plastic strain alone: -1 - (its last value), a value
/// that no other element has. Its first stress value keeps the elastic energy it had.
FPM_KERNEL constexpr bool isDeleted(double storedStrain)
{
    return storedStrain < 0;
}
FPM_KERNEL constexpr double plasticStrainOf(double storedStrain)
{
    return isDeleted(storedStrain) ? -1 - storedStrain : storedStrain;
}

/// Elastic energy per volume of isotropic elasticity.
template <class T>
FPM_KERNEL T elasticEnergy(const MaterialConstants<ScalarOf<T>>& m, const Sym3<T>& s)
{
    using Real = ScalarOf<T>;
    const T trace = s.xx + s.yy + s.zz;
    return T(Real(0.5) / m.young)
           * (T(Real(1) + m.poisson) * contract(s, s) - T(m.poisson) * trace * trace);
}

template <class Mask, class T>
FPM_KERNEL Vec3<T> zeroWhere(const Mask& mask, const Vec3<T>& a)
{
    const T zero = T(ScalarOf<T>(0));
    return {select(mask, zero, a.x), select(mask, zero, a.y), select(mask, zero, a.z)};
}
template <class Mask, class T>
FPM_KERNEL Sym3<T> zeroWhere(const Mask& mask, const Sym3<T>& a)
{
    const T zero = T(ScalarOf<T>(0));
    return {select(mask, zero, a.xx), select(mask, zero, a.yy), select(mask, zero, a.zz),
            select(mask, zero, a.xy), select(mask, zero, a.yz), select(mask, zero, a.zx)};
}

/// Deletes the elements whose plastic strain exceeds the part's limit in this step and, where the
/// part demands it, inverted ones; deleted elements stay deleted. They carry no load, limit no time
/// step and do no work. `start`: state before the step; `before`: its stress, rotated; `work`: work
/// of the forces at the start in this step, of stress and hourglass control.
template <class T>
FPM_KERNEL void erode(const MaterialConstants<ScalarOf<T>>& m,
                      const ElementState<T>& start,
                      const Sym3<T>& before,
                      const T& volume,
                      const ElementWork<T>& work,
                      ElementStep<T>& step,
                      ElementState<T>& state,
                      Modes<T>& force)
{
    using Real = ScalarOf<T>;
    const T zero = T(Real(0)), one = T(Real(1)), half = T(Real(0.5));
    const T strain = start.equivalentPlasticStrain;
    const auto deleted = strain < zero;
    T inverted = zero; // 1: inverted, nothing computed for the element in this step is valid
    if (m.general.erodesInverted) inverted = select(step.stableTimeStep > zero, zero, one);
    const auto broken = inverted > half;
    const T increment = select(broken, zero, step.plasticStrainIncrement);
    T dies = select(strain + increment > T(m.general.erosionStrain), one, inverted);
    dies = select(deleted, zero, dies);
    step.deletes = dies;
    const T without = select(deleted, one, dies);
    const auto gone = without > half;
    if (!NumberTraits<T>::any(gone)) return;

    const auto now = dies > half;
    const T nothing = select(deleted, one, inverted); // 1: does no work
    const auto mute = nothing > half;
    step.internal = select(mute, zero, select(now, work.internal, step.internal));
    step.hourglass = select(mute, zero, select(now, work.hourglass, step.hourglass));
    step.plastic = select(mute, zero, step.plastic);
    step.temperatureIncrement = select(mute, zero, step.temperatureIncrement);
    step.bulkViscosity = select(gone, zero, step.bulkViscosity);
    step.stableTimeStep = select(gone, T(Real(1e30)), step.stableTimeStep);
    step.plasticStrainIncrement =
        select(deleted, zero,
               select(now, -one - (strain + strain) - increment, step.plasticStrainIncrement));

    const T held = select(broken, zero, volume * elasticEnergy(m, before));
    state.stress = zeroWhere(gone, state.stress);
    state.stress.xx = select(now, held, select(deleted, start.stress.xx, state.stress.xx));
    state.backstress = zeroWhere(gone, state.backstress);
    for (int j = 0; j < 4; ++j) state.hourglass[j] = zeroWhere(gone, state.hourglass[j]);
    for (int k = 0; k < 8; ++k) force.mode[k] = zeroWhere(gone, force.mode[k]);
}

} // namespace fpm
