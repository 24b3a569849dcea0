#pragma once

#include "kernels/material/J2Plasticity.h"

namespace fpm {

/// Everything a part may ask for beyond Elastic and J2Plasticity with the middle surface's
/// rotation: options are constants of the part, asked at run time, so that each of them needs no
/// kernels of its own. Also serves elastic parts (no hardening rows).
struct GeneralPlasticity {
    static constexpr bool plastic = true;
    static constexpr bool general = true;
};

/// Takes the elastic trial stress to the yield surface of the part's law.
template <class T>
FPM_KERNEL PlasticStep<T> generalReturn(const MaterialConstants<ScalarOf<T>>& m,
                                        const T& plasticStrain,
                                        const T& bending,
                                        Sym3<T>& stress)
{
    const T zero = T(ScalarOf<T>(0));
    if (m.rows == 0) return {zero, zero, zero};
    return radialReturn<T>(m, plasticStrain, bending, stress);
}

} // namespace fpm
