#pragma once

#include "kernels/material/MaterialConstants.h"
#include "parallel/ExpLog.h"

namespace fpm {

/// A yield stress and its derivative.
template <class T>
struct YieldStress {
    T value, slope;
};

/// Slow, cold yield stress at an equivalent plastic strain: the table (piecewise linear, its last
/// slope continues) plus B e^n (Johnson and Cook's A is the table's only row).
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
        // Where the strain is nothing the slope has no end: held at that of a strain of 1e-12.
        const T held = maximum(strain, T(Real(1e-12)));
        const T powered = T(m.general.powerModulus) * power(strain, T(m.general.powerExponent));
        value += powered;
        slope += T(m.general.powerExponent) * powered / held;
    }
    return {value, slope};
}

} // namespace fpm
