#pragma once

#include "kernels/material/MaterialConstants.h"
#include "parallel/ExpLog.h"

namespace fpm {

/// Thermal softening of Johnson and Cook 1983: 1 - T*^m, T* = (T - room) / (melting - room) between
/// 0 and 1. A molten material keeps a millionth of its strength. `rise`: of the temperature since
/// the start.
template <class T>
FPM_KERNEL T thermalSoftening(const GeneralConstants<ScalarOf<T>>& m, const T& rise)
{
    using Real = ScalarOf<T>;
    const T one = T(Real(1)), zero = T(Real(0));
    if (!(m.softeningExponent > Real(0))) return one;
    const T homologous =
        maximum((rise + T(m.temperature - m.roomTemperature)) * T(m.inverseMeltingRange), zero);
    return maximum(one - power(homologous, T(m.softeningExponent)), T(Real(1e-6)));
}

} // namespace fpm
