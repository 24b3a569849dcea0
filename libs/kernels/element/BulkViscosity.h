#pragma once

#include "kernels/material/MaterialConstants.h"
#include "parallel/Math.h"

namespace fpm {

/// Bulk viscosity of one step: linear in both signs, quadratic in compression. It acts in the nodal
/// force, not in the stress.
template <class T>
struct BulkViscosity {
    T pressure;  ///< to be added to the mean stress (tension positive)
    T damping;   ///< fraction of the critical damping of a wave as long as the element
    T slowness;  ///< sqrt(density / pressure wave modulus)
    T waveSpeed; ///< its inverse
};

/// `length`: V / sqrt(2 sum B B), for a cube the edge / sqrt(3); `volumetric`: strain of the step.
template <class T>
FPM_KERNEL BulkViscosity<T> bulkViscosity(const MaterialConstants<ScalarOf<T>>& m,
                                          const T& density,
                                          const T& length,
                                          const T& volumetric,
                                          const T& rate)
{
    using Real = ScalarOf<T>;
    const T slowness = squareRoot(density * T(Real(1) / m.pressureWaveModulus));
    const T waveSpeed = T(Real(1)) / slowness;
    const T compression = maximum(-(volumetric * rate), T(Real(0)));
    const T quadratic = T(m.quadraticViscosity * m.quadraticViscosity) * length * compression;
    const T pressure =
        density * length
        * (T(m.linearViscosity) * waveSpeed * (volumetric * rate) - quadratic * compression);
    return {pressure, T(m.linearViscosity) + quadratic * slowness, slowness, waveSpeed};
}

} // namespace fpm
