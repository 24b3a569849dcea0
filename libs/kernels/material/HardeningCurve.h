#pragma once

#include "kernels/material/MaterialConstants.h"
#include "parallel/ExpLog.h"

namespace fpm {

/// A yield stress and its derivative.
template <class T>
struct YieldStress {
    T value, slope;
};

/// Quasi-static yield stress at the reference temperature and an equivalent plastic strain: the
/// table (piecewise linear, its last slope continues) plus B e^n (A of Johnson and Cook is the only
/// row of the table).
template <class T>
FPM_KERNEL YieldStress<T> hardeningCurve(const MaterialConstants<ScalarOf<T>>& m, const T& strain)
{
    using Real = ScalarOf<T>;
    T from = T(m.strain[0]), value = T(m.stress[0]), slope = T(m.slope[0]);
    for (int row = 1; row < m.rows; ++row) {
        const auto beyond = strain > T(m.strain[row]);
        from = select(beyond, T(m.strain[row]), from);
        value = select(beyond, T(m.stress[row]), value);
        slope = select(beyond, T(m.slope[row]), slope);
    }
    value = fusedMultiplyAdd(slope, strain - from, value);
    if (m.general.powerModulus > Real(0)) {
        // At zero strain the slope is infinite: it is taken at a strain of 1e-12.
        const T held = maximum(strain, T(Real(1e-12)));
        const T powered = T(m.general.powerModulus) * power(strain, T(m.general.powerExponent));
        value += powered;
        slope += T(m.general.powerExponent) * powered / held;
    }
    return {value, slope};
}

} // namespace fpm
